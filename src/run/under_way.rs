//! A run between two steps: when frames and checkpoints are due, and when it ends.

use super::checkpoint::{Checkpoint, Pace};
use super::error::RunError;
use super::recorder::Recorder;
use super::steady::Monitor;
use super::stopwatch::Stopwatch;
use super::swing::Swing;
use super::tally::Tally;
use crate::case::{Case, RunPlan, Stop};
use crate::output::Summary;
use aero_solver::Flow;

/// A step this short, as a part of the flow's own time, makes no headway: a thousand million would be
/// needed.
const TINY_STEP: f64 = 1e-9;

/// So many tiny steps in a row are no passing trouble.
const PATIENCE: u32 = 1000;

/// Runs `case` to its end; `recorder` sees the start, every step and every frame. Returns the
/// finished simulation for those who want to look into it.
pub(super) fn simulate<const D: usize>(
    case: Case<D>,
    recorder: &mut dyn Recorder<D>,
    stopwatch: Stopwatch,
) -> Result<(Flow<D>, Summary), RunError> {
    let mut under_way = UnderWay::start(case, recorder, stopwatch)?;
    let summary = under_way.finish(recorder)?;
    Ok((under_way.simulation, summary))
}

/// A run between two steps.
pub(super) struct UnderWay<const D: usize> {
    plan: RunPlan<D>,
    pub(super) simulation: Flow<D>,
    pub(super) tally: Tally,
    pace: Pace,
    /// Only where the run may end early.
    monitor: Option<Monitor>,
    /// Of a flow that settles.
    pub(super) swing: Swing,
}

impl<const D: usize> UnderWay<D> {
    /// Before the first step, the first frame recorded.
    pub(super) fn start(
        case: Case<D>,
        recorder: &mut dyn Recorder<D>,
        stopwatch: Stopwatch,
    ) -> Result<Self, RunError> {
        let Case { problem, plan } = case;
        let watches = plan.stop == Stop::Steady && !problem.method.settles();
        let monitor = watches.then(|| Monitor::new(&problem));
        let simulation = Flow::new(problem).map_err(RunError::SetUp)?;
        recorder.frame(&simulation)?;
        let this = Self {
            tally: Tally::start(&plan, &simulation, stopwatch),
            swing: Swing::new(simulation.problem().bodies.len()),
            pace: Pace {
                frames: 1,
                framed_step: 0,
                tiny_steps: 0,
                interval: plan.output.frame_interval,
                end: plan.end_time,
            },
            plan,
            simulation,
            monitor,
        };
        recorder.checkpoint(this.checkpoint())?;
        Ok(this)
    }

    /// Where a checkpoint was written.
    pub(super) fn resume(
        case: Case<D>,
        checkpoint: Checkpoint<'static, D>,
        stopwatch: Stopwatch,
    ) -> Result<Self, String> {
        let Case { problem, plan } = case;
        let simulation = Flow::resume(problem, checkpoint.simulation)?;
        Ok(Self {
            tally: Tally::resume(&plan, &simulation, checkpoint.sums, stopwatch),
            pace: Pace {
                end: plan.end_time,
                ..checkpoint.pace
            },
            monitor: checkpoint.monitor.filter(|_| plan.stop == Stop::Steady),
            plan,
            simulation,
            swing: checkpoint.swing,
        })
    }

    pub(super) fn checkpoint(&self) -> Checkpoint<'_, D> {
        Checkpoint {
            simulation: self.simulation.memory(),
            sums: self.tally.sums(),
            pace: self.pace,
            monitor: self.monitor.clone(),
            swing: self.swing.clone(),
        }
    }

    /// Goes on to the end.
    pub(super) fn finish(&mut self, recorder: &mut dyn Recorder<D>) -> Result<Summary, RunError> {
        if self.simulation.problem().method.settles() {
            self.settle(recorder)
        } else {
            self.march(recorder)
        }
    }

    /// Steps to the end time.
    fn march(&mut self, recorder: &mut dyn Recorder<D>) -> Result<Summary, RunError> {
        let end = self.plan.end_time;
        let interval = self.pace.interval;
        let tiny = self.tiny_step();
        loop {
            let due = frame_time(self.pace.frames, interval, end);
            let dt = match self.simulation.step(due) {
                Ok(dt) => dt,
                Err(failure) => return Err(self.stop(recorder, failure.to_string())),
            };
            self.tally.add(&self.simulation, dt);
            let wish = recorder.step(&self.simulation, dt)?;
            let framed = self.simulation.time() >= due;
            if framed {
                recorder.frame(&self.simulation)?;
                self.pace.framed_step = self.simulation.steps();
                self.pace.frames += 1;
            }
            self.pace.tiny_steps = if dt < tiny {
                self.pace.tiny_steps + 1
            } else {
                0
            };
            if self.pace.tiny_steps > PATIENCE {
                let reason = format!(
                    "the time step collapsed to {dt:.1e} ({}); the end is out of reach",
                    self.moment()
                );
                return Err(self.stop(recorder, reason));
            }
            let steady = self.monitor.as_mut();
            if let Some((reason, window)) = steady.and_then(|m| m.add(&self.simulation, dt)) {
                if !framed {
                    recorder.frame(&self.simulation)?;
                }
                recorder.finish()?;
                self.tally.settle(window);
                return Ok(self.tally.summary(&self.simulation, &reason));
            }
            // At the end nothing is left to go on with.
            if self.simulation.time() >= end {
                break;
            }
            if framed || wish.is_break() || recorder.is_checkpoint_due() {
                recorder.checkpoint(self.checkpoint())?;
            }
            if wish.is_break() {
                return Err(self.stop(recorder, format!("interrupted ({})", self.moment())));
            }
        }
        recorder.finish()?;
        let reason = match &self.monitor {
            Some(monitor) => monitor.verdict(),
            None => "end time reached".into(),
        };
        Ok(self.tally.summary(&self.simulation, &reason))
    }

    /// The step below which a run makes no headway: a tiny part of the time in which the stream's fastest waves cross the domain, or of
    /// the run where that is shorter. One that has to come to its end needs a step above its round-off, too.
    fn tiny_step(&self) -> f64 {
        let (problem, end) = (self.simulation.problem(), self.plan.end_time);
        let stream = &problem.free_stream;
        let sound = problem.gas.sound_speed_at(stream.density, stream.pressure);
        let crossing = problem.domain.bounds.size().max() / (stream.velocity.norm() + sound);
        let tiny = TINY_STEP * end.min(crossing);
        match self.plan.stop {
            Stop::EndTime => tiny.max(f64::EPSILON * end),
            Stop::Steady => tiny,
        }
    }

    /// Ends early, after the frame of where the run stands unless that was written already.
    pub(super) fn stop(&self, recorder: &mut dyn Recorder<D>, reason: String) -> RunError {
        let is_framed = self.simulation.steps() == self.pace.framed_step;
        let frame = if is_framed {
            Ok(())
        } else {
            recorder.frame(&self.simulation)
        };
        if let Err(error) = frame.and_then(|()| recorder.finish()) {
            return error.into();
        }
        let summary = Box::new(self.tally.summary(&self.simulation, &reason));
        RunError::Stopped { reason, summary }
    }

    pub(super) fn moment(&self) -> String {
        let (step, time) = (self.simulation.steps(), self.simulation.time());
        format!("step {step}, time {time:.3e}")
    }
}

/// Time of frame `number`; the last one is at the end, and no frame comes so shortly before it
/// that only round-off tells them apart.
fn frame_time(number: u64, interval: f64, end: f64) -> f64 {
    const ROUND_OFF: f64 = 1e-9;
    let time = number as f64 * interval;
    if time > end - ROUND_OFF * interval {
        end
    } else {
        time
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_end_exactly_at_the_end_time() {
        let interval = 0.7 / 20.0;
        let times: Vec<f64> = (1..=20).map(|n| frame_time(n, interval, 0.7)).collect();
        assert_eq!(times[19], 0.7);
        assert!(
            times
                .windows(2)
                .all(|pair| pair[1] - pair[0] > 0.5 * interval)
        );
        assert_eq!(frame_time(3, 0.3, 0.7), 0.7);
    }
}
