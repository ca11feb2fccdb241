//! A run for a moment: how fast this machine is, and what there is at the start.

use std::time::Instant;

use super::error::RunError;
use crate::case::{AnyCase, Case};
use crate::output::peak_memory;
use aero_solver::Flow;
use aero_solver::frame::Frame;
use aero_solver::method::Time;

/// So many steps at least, whatever they take.
const LEAST: u32 = 3;

/// Iterations that flows of fixed points take to settle, roughly.
const ITERATIONS: f64 = 400.0;

/// What a moment of running has shown.
#[derive(Clone, Debug)]
pub struct Burst {
    /// Particles of gas, or points.
    pub gas: usize,
    /// Ghosts.
    pub ghosts: usize,
    /// Steps taken.
    pub steps: u32,
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
    let mut flow = Flow::new(case.problem).map_err(RunError::SetUp)?;
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
        seconds_per_step,
        steps_to_go,
        settles,
        peak_memory: peak_memory(),
        frame: flow.frame(),
    })
}
