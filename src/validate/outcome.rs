//! One run in memory, and its result as plain arrays.

use std::ops::ControlFlow;
use std::path::Path;

use aero_geometry::kernel::SMOOTHING_RATIO;
use aero_validation::metrics::MetricError;

use super::{Context, ValidateError};
use crate::case::Case;
use crate::output::{OutputError, Summary};
use crate::run::{Recorder, RunError, Stopwatch, simulate};
use crate::scene::{AnyCase, Scene};
use aero_solver::Simulation;
use aero_solver::frame::{Frame, Kind, Load, SurfaceFrame};

/// A scene of the project, by name and text.
#[derive(Clone, Copy, Debug)]
pub struct Source {
    /// Name of the case.
    pub name: &'static str,
    /// The file.
    pub text: &'static str,
}

impl Source {
    /// The error of a flow that does not show what was to be measured.
    pub fn unread(&self, source: MetricError) -> ValidateError {
        ValidateError::Metric {
            case: self.name.into(),
            source,
        }
    }
}

/// Spacing of each particle, to draw it with.
pub fn diameters(frame: &Frame) -> Vec<f64> {
    let lengths = frame.smoothing_length.iter();
    lengths.map(|h| h / SMOOTHING_RATIO).collect()
}

/// The end of a run.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// All particles.
    pub frame: Frame,
    /// The moving gas alone, inside the domain.
    pub gas: Frame,
    /// Surfaces.
    pub surface: SurfaceFrame,
    /// Counts, loads, cost.
    pub summary: Summary,
    /// What was kept of the way there.
    pub history: History,
}

/// What is kept of a run beside its end.
#[derive(Clone, Copy, Debug, Default)]
pub struct Keep {
    /// Loads on the first body after every step.
    pub loads: bool,
    /// Frames of the scene's `[output]` in the second half of the run.
    pub frames: bool,
}

/// The way to the end of a run, as far as it was kept.
#[derive(Clone, Debug, Default)]
pub struct History {
    /// Times of `loads`.
    pub time: Vec<f64>,
    /// Loads on the first body.
    pub load: Vec<Load>,
    /// Frames, the last one included.
    pub frames: Vec<Frame>,
}

/// Runs a scene with `settings` (`section.key=value`), and those of the `context` on top, and keeps its end alone.
pub fn run(
    source: Source,
    settings: &[String],
    context: &Context<'_>,
) -> Result<Outcome, ValidateError> {
    run_keeping(Keep::default(), source, settings, context)
}

/// As [`run`], and keeps more than the end.
pub fn run_keeping(
    keep: Keep,
    source: Source,
    settings: &[String],
    context: &Context<'_>,
) -> Result<Outcome, ValidateError> {
    let settings = [settings, context.settings].concat();
    let mut scene = Scene::parse(source.text, source.name, Path::new(""))?;
    for setting in &settings {
        scene.set(setting)?;
    }
    (context.announce)(&format!("{}: {}", source.name, settings.join(" ")));
    let stopwatch = Stopwatch::start();
    let result = match scene.build_any()? {
        AnyCase::One(case) => finish(*case, keep, stopwatch),
        AnyCase::Two(case) => finish(*case, keep, stopwatch),
        AnyCase::Three(case) => finish(*case, keep, stopwatch),
    };
    result.map_err(|error| ValidateError::Run {
        case: source.name.into(),
        variant: settings.join(" "),
        source: Box::new(error),
    })
}

/// A run that came to its end or did not.
#[derive(Debug)]
pub enum Attempt {
    /// It did.
    Ended(Box<Outcome>),
    /// It stopped, and why.
    Stopped(String, Box<Summary>),
}

/// Runs a scene; only a scene that is wrong is an error.
pub fn attempt(
    source: Source,
    settings: &[String],
    context: &Context<'_>,
) -> Result<Attempt, ValidateError> {
    match run(source, settings, context) {
        Ok(outcome) => Ok(Attempt::Ended(Box::new(outcome))),
        Err(ValidateError::Run { source: error, .. }) => match *error {
            RunError::Stopped { reason, summary } => Ok(Attempt::Stopped(reason, summary)),
            other => Err(ValidateError::Run {
                case: source.name.into(),
                variant: settings.join(" "),
                source: Box::new(other),
            }),
        },
        Err(error) => Err(error),
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
    let gas = gas(&frame);
    Ok(Outcome {
        gas,
        frame,
        surface: simulation.surface(),
        summary,
        history: keeper.history,
    })
}

/// The fluid particles of a frame.
fn gas(frame: &Frame) -> Frame {
    let chosen: Vec<usize> = (0..frame.kind.len())
        .filter(|&i| frame.kind[i] == Kind::Fluid as u8)
        .collect();
    Frame {
        time: frame.time,
        step: frame.step,
        position: pick(&frame.position, &chosen),
        velocity: pick(&frame.velocity, &chosen),
        density: pick(&frame.density, &chosen),
        pressure: pick(&frame.pressure, &chosen),
        energy: pick(&frame.energy, &chosen),
        mach: pick(&frame.mach, &chosen),
        smoothing_length: pick(&frame.smoothing_length, &chosen),
        kind: pick(&frame.kind, &chosen),
        id: pick(&frame.id, &chosen),
    }
}

fn pick<T: Copy>(values: &[T], chosen: &[usize]) -> Vec<T> {
    chosen.iter().map(|&i| values[i]).collect()
}

/// Records what is to be kept.
struct Keeper {
    keep: Keep,
    frames_from: f64,
    history: History,
}

impl<const D: usize> Recorder<D> for Keeper {
    fn frame(&mut self, simulation: &Simulation<D>) -> Result<(), OutputError> {
        if self.keep.frames && simulation.time() >= self.frames_from {
            self.history.frames.push(simulation.frame());
        }
        Ok(())
    }

    fn step(&mut self, simulation: &Simulation<D>, _: f64) -> Result<ControlFlow<()>, OutputError> {
        if self.keep.loads {
            self.history.time.push(simulation.time());
            let first = simulation.loads().first().copied();
            self.history.load.push(first.unwrap_or_default());
        }
        Ok(ControlFlow::Continue(()))
    }
}
