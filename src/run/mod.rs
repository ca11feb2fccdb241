//! Drives a run from its start to its end: when frames are due, what is recorded, what is summed
//! up. Knows neither the equations nor the formats of the files.

mod recorder;
mod steady;
mod stopwatch;
mod tally;

pub use recorder::{FileRecorder, Recorder};
pub use stopwatch::Stopwatch;

use std::path::Path;

use crate::case::{Case, Stop};
use crate::output::{self, OutputError, Summary};
use crate::solver::Simulation;
use steady::Monitor;
use tally::Tally;

/// A step this short, as a part of the whole run, makes no headway: a thousand million would be
/// needed.
const TINY_STEP: f64 = 1e-9;

/// So many tiny steps in a row are no passing trouble.
const PATIENCE: u32 = 1000;

/// How far a run is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// Steps taken.
    pub steps: u64,
    /// Time reached.
    pub time: f64,
    /// Time at which the run ends.
    pub end_time: f64,
    /// Length of the last step.
    pub dt: f64,
}

/// Why a run has no good end.
#[derive(Debug, thiserror::Error)]
pub enum RunError {
    /// The case cannot be set up.
    #[error("{0}")]
    SetUp(String),
    /// The run cannot go on; the summary tells how far it came.
    #[error("{reason}")]
    Stopped {
        /// Where and why.
        reason: String,
        /// The run up to there.
        summary: Box<Summary>,
    },
    /// A file cannot be written.
    #[error(transparent)]
    Output(#[from] OutputError),
}

/// Runs `case` to its end on the current thread pool, with frames, history and summary in the
/// folder `out`.
///
/// `stopwatch` was started where the cost of the run begins, packing included; `watch` is called
/// after every step.
///
/// # Errors
/// A run that fails leaves its last good frame and its summary in `out` all the same.
pub fn run<const D: usize>(
    case: Case<D>,
    out: &Path,
    stopwatch: Stopwatch,
    watch: &mut dyn FnMut(Progress),
) -> Result<Summary, RunError> {
    output::make_folder(out)?;
    let mut recorder = FileRecorder::create(out, &case, watch)?;
    let result = simulate(case, &mut recorder, stopwatch).map(|(_, summary)| summary);
    let summary = match &result {
        Ok(summary) => summary,
        Err(RunError::Stopped { summary, .. }) => summary.as_ref(),
        Err(_) => return result,
    };
    output::write_json(&out.join("summary.json"), summary)?;
    result
}

/// Runs `case` to its end; `recorder` sees the start, every step and every frame. Returns the
/// finished simulation for those who want to look into it.
pub fn simulate<const D: usize>(
    case: Case<D>,
    recorder: &mut dyn Recorder<D>,
    stopwatch: Stopwatch,
) -> Result<(Simulation<D>, Summary), RunError> {
    let end = case.end_time;
    let interval = case.output.frame_interval;
    let mut monitor = (case.stop == Stop::Steady).then(|| Monitor::new(&case));
    let mut simulation = Simulation::new(case).map_err(RunError::SetUp)?;
    let mut tally = Tally::start(&simulation, stopwatch);
    recorder.frame(&simulation)?;

    let mut frames = 1;
    let mut framed_step = 0;
    let mut tiny_steps = 0;
    while simulation.time() < end {
        let due = frame_time(frames, interval, end);
        let dt = match simulation.step(due) {
            Ok(dt) => dt,
            Err(failure) => {
                let framed = simulation.steps() == framed_step;
                return Err(stop(
                    &simulation,
                    recorder,
                    &tally,
                    framed,
                    failure.to_string(),
                ));
            }
        };
        tally.add(&simulation, dt);
        recorder.step(&simulation, dt)?;
        let framed = simulation.time() >= due;
        if framed {
            recorder.frame(&simulation)?;
            framed_step = simulation.steps();
            frames += 1;
        }
        tiny_steps = if dt < TINY_STEP * end {
            tiny_steps + 1
        } else {
            0
        };
        if tiny_steps > PATIENCE {
            let reason = format!(
                "the time step collapsed to {dt:.1e} (step {}, time {:.3e}); the end is out of reach",
                simulation.steps(),
                simulation.time()
            );
            return Err(stop(&simulation, recorder, &tally, framed, reason));
        }
        let steady = monitor.as_mut().and_then(|m| m.add(&simulation, dt));
        if let Some((reason, window)) = steady {
            if !framed {
                recorder.frame(&simulation)?;
            }
            tally.settle(window);
            let summary = tally.summary(&simulation, &reason);
            return Ok((simulation, summary));
        }
    }
    let reason = monitor.map_or_else(|| "end time reached".into(), |m| m.verdict());
    let summary = tally.summary(&simulation, &reason);
    Ok((simulation, summary))
}

/// Ends a run early, after the frame of where it stands unless that was written already.
fn stop<const D: usize>(
    simulation: &Simulation<D>,
    recorder: &mut dyn Recorder<D>,
    tally: &Tally,
    framed: bool,
    reason: String,
) -> RunError {
    if !framed && let Err(error) = recorder.frame(simulation) {
        return error.into();
    }
    let summary = Box::new(tally.summary(simulation, &reason));
    RunError::Stopped { reason, summary }
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
