//! A run in memory: its end as plain arrays, and of the way there what was asked for.

use std::ops::ControlFlow;

use super::error::RunError;
use super::recorder::Recorder;
use super::stopwatch::Stopwatch;
use super::under_way::simulate;
use crate::case::{AnyCase, Case};
use crate::output::{BodyMotion, OutputError, Summary};
use aero_solver::Flow;
use aero_solver::frame::{Frame, Kind, Load, PanelFrame, SurfaceFrame};

/// The end of a run.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// All particles.
    pub frame: Frame,
    /// The moving gas alone, inside the domain.
    pub gas: Frame,
    /// Surfaces, one point per ghost of the wall layer.
    pub surface: SurfaceFrame,
    /// The surfaces themselves.
    pub panels: PanelFrame,
    /// Counts, loads, cost.
    pub summary: Summary,
    /// What was kept of the way there.
    pub history: History,
}

/// What is kept of a run beside its end.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Keep {
    /// Nothing.
    #[default]
    End,
    /// Loads on the first body after every step.
    Loads,
    /// Frames of the scene's `[output]` in the second half of the run; at the end alone of a run that settles.
    Frames,
    /// What panels show at the same times; at the end alone of a run that settles.
    Panels,
}

/// The way to the end of a run, as far as it was kept.
#[derive(Clone, Debug, Default)]
pub struct History {
    /// Times of `loads`.
    pub time: Vec<f64>,
    /// Loads on the first body.
    pub load: Vec<Load>,
    /// How the gas moves the first body; none if it does not.
    pub motion: Vec<BodyMotion>,
    /// Frames, the last one included.
    pub frames: Vec<Frame>,
    /// What panels show, the last frame's included.
    pub panels: Vec<PanelFrame>,
}

/// Runs a case of any dimension to its end and writes nothing.
///
/// # Errors
/// A case that cannot be set up, and a run that stops before its end.
pub fn run_in_memory(case: AnyCase, keep: Keep, stopwatch: Stopwatch) -> Result<Outcome, RunError> {
    match case {
        AnyCase::One(case) => finish(*case, keep, stopwatch),
        AnyCase::Two(case) => finish(*case, keep, stopwatch),
        AnyCase::Three(case) => finish(*case, keep, stopwatch),
    }
}

fn finish<const D: usize>(
    case: Case<D>,
    keep: Keep,
    stopwatch: Stopwatch,
) -> Result<Outcome, RunError> {
    let mut keeper = Keeper {
        keep,
        frames_from: 0.5 * case.plan.end_time,
        history: History::default(),
    };
    let (simulation, summary) = simulate(case, &mut keeper, stopwatch)?;
    let frame = simulation.frame();
    let gas = frame.chosen(|kind| kind == Kind::Fluid as u8);
    let panels = simulation.panels();
    let mut history = keeper.history;
    // A run that settles has passed no frame by the time.
    if keep == Keep::Panels && history.panels.is_empty() {
        history.panels.push(panels.clone());
    }
    if keep == Keep::Frames && history.frames.is_empty() {
        history.frames.push(frame.clone());
    }
    Ok(Outcome {
        gas,
        frame,
        surface: simulation.surface(),
        panels,
        summary,
        history,
    })
}

/// Records what is to be kept.
struct Keeper {
    keep: Keep,
    frames_from: f64,
    history: History,
}

impl<const D: usize> Recorder<D> for Keeper {
    fn frame(&mut self, simulation: &Flow<D>) -> Result<(), OutputError> {
        if simulation.time() >= self.frames_from {
            match self.keep {
                Keep::Frames => self.history.frames.push(simulation.frame()),
                Keep::Panels => self.history.panels.push(simulation.panels()),
                Keep::End | Keep::Loads => {}
            }
        }
        Ok(())
    }

    fn step(&mut self, simulation: &Flow<D>, _: f64) -> Result<ControlFlow<()>, OutputError> {
        if self.keep == Keep::Loads {
            self.history.time.push(simulation.time());
            let first = simulation.loads().first().copied();
            self.history.load.push(first.unwrap_or_default());
            let has_bodies = !simulation.problem().bodies.is_empty();
            let motion = has_bodies.then(|| BodyMotion::of(simulation, 0)).flatten();
            self.history.motion.extend(motion);
        }
        Ok(ControlFlow::Continue(()))
    }
}
