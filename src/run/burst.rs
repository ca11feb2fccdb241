//! A run for a moment: how fast this machine is, and what there is at the start.

use std::time::Instant;

use super::error::RunError;
use crate::case::{AnyCase, Case};
use crate::output::peak_memory;
use aero_solver::Flow;
use aero_solver::frame::Frame;
use aero_solver::method::{Refine, Time};

/// So many steps at least, whatever they take.
const LEAST: u32 = 3;

/// Iterations that flows of fixed points take to settle, roughly.
const ITERATIONS: f64 = 400.0;

/// Part of a budget that is planned: the rest is for what is not foreseen.
const PLANNED: f64 = 0.7;

/// What a point of a flow that settles and is refined meanwhile costs, over one of a flow that is not.
const REFINED: f64 = 2.0;

/// Cells across a wave at each level of points that are added to it.
const BAND: f64 = 8.0;

/// What a moment of running has shown.
#[derive(Clone, Debug)]
pub struct Burst {
    /// Particles of gas, or points.
    pub gas: usize,
    /// Ghosts.
    pub ghosts: usize,
    /// Steps taken.
    pub steps: u32,
    /// Seconds until the first step.
    pub seconds_before: f64,
    /// Seconds a step takes.
    pub seconds_per_step: f64,
    /// Steps of this length to the end, or iterations that settling may take.
    pub steps_to_go: f64,
    /// The run settles, and its steps are iterations.
    pub settles: bool,
    /// The most memory that the process held, bytes; none where the system does not tell.
    pub peak_memory: Option<u64>,
    /// What there is after these steps.
    pub frame: Frame,
}

impl Burst {
    /// How far a run that would take so long as this burst shows, without points added to it, may be refined within `seconds`,
    /// in so many dimensions; none where it takes longer as it is.
    pub fn refine_within(&self, seconds: f64, dimension: usize) -> Option<Refine> {
        let times = PLANNED * seconds / (self.seconds_per_step * self.steps_to_go);
        if times < 1.0 {
            return None;
        }
        let gas = self.gas as f64;
        Some(if self.settles {
            let points = gas * (times / REFINED).max(1.0);
            Refine::Points(points as u64)
        } else {
            let fits = |levels: &u8| marched(gas, *levels, dimension) <= times;
            Refine::Levels(
                (0..=Refine::DEEPEST_OF_POINTS)
                    .take_while(fits)
                    .last()
                    .unwrap_or(0),
            )
        })
    }
}

/// What a run in time costs with so many halvings, over what it costs without: its waves are bands of the width of `BAND` cells
/// across the box at every level, and all points go by the shortest step.
fn marched(gas: f64, levels: u8, dimension: usize) -> f64 {
    let across = dimension as i32 - 1;
    let wave = BAND * gas.powf(f64::from(across) / dimension as f64);
    let bands: f64 = (1..=i32::from(levels))
        .map(|level| 2_f64.powi(level * across))
        .sum();
    (1.0 + bands * wave / gas) * 2_f64.powi(i32::from(levels))
}

/// Runs a case of any dimension for about `seconds` and writes nothing.
///
/// # Errors
/// A case that cannot be set up, or fails at once.
pub fn burst(case: AnyCase, seconds: f64) -> Result<Burst, RunError> {
    match case {
        AnyCase::One(case) => run(*case, seconds),
        AnyCase::Two(case) => run(*case, seconds),
        AnyCase::Three(case) => run(*case, seconds),
    }
}

fn run<const D: usize>(case: Case<D>, seconds: f64) -> Result<Burst, RunError> {
    let end = case.plan.end_time;
    let method = case.problem.method;
    let settles = method
        .fixed()
        .is_some_and(|points| points.time == Time::Settle);
    let begun = Instant::now();
    let mut flow = Flow::new(case.problem).map_err(RunError::SetUp)?;
    let seconds_before = begun.elapsed().as_secs_f64();
    let start = Instant::now();
    let mut steps = 0;
    while steps < LEAST || (start.elapsed().as_secs_f64() < seconds && flow.time() < end) {
        let step = match settles.then(|| flow.settle_step()).flatten() {
            Some(settled) => settled.map(|_| 0.0),
            None if flow.time() >= end => break,
            None => flow.step(end),
        };
        step.map_err(|failure| RunError::SetUp(failure.to_string()))?;
        steps += 1;
    }
    let seconds_per_step = start.elapsed().as_secs_f64() / f64::from(steps.max(1));
    let steps_to_go = if settles {
        ITERATIONS
    } else {
        f64::from(steps) * end / flow.time().max(f64::MIN_POSITIVE)
    };
    let counts = flow.statistics();
    Ok(Burst {
        gas: counts.fluid,
        ghosts: counts.ghost,
        steps,
        seconds_before,
        seconds_per_step,
        steps_to_go,
        settles,
        peak_memory: peak_memory(),
        frame: flow.frame(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(settles: bool) -> Burst {
        Burst {
            gas: 1000,
            ghosts: 0,
            steps: 10,
            seconds_before: 0.0,
            seconds_per_step: 0.01,
            steps_to_go: 100.0,
            settles,
            peak_memory: None,
            frame: Frame::default(),
        }
    }

    #[test]
    fn points_grow_as_the_time_that_they_may_take() {
        let points = |seconds| shown(true).refine_within(seconds, 2);
        assert_eq!(points(1.0), None);
        assert_eq!(points(2.0), Some(Refine::Points(1000)));
        assert_eq!(points(20.0), Some(Refine::Points(7000)));
        assert_eq!(points(200.0), Some(Refine::Points(70_000)));
    }

    #[test]
    fn halvings_of_a_run_in_time_cost_more_than_points_and_steps_at_the_waves() {
        let halvings = |seconds| shown(false).refine_within(seconds, 2);
        assert_eq!(halvings(1.0), None);
        assert_eq!(halvings(2.0), Some(Refine::Levels(0)));
        assert_eq!(halvings(6.0), Some(Refine::Levels(1)));
        assert!(marched(1000.0, 2, 3) > 2.0 * marched(1000.0, 1, 3));
    }
}
