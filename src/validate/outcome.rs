//! One run in memory, and its result as plain arrays.

use std::ops::ControlFlow;
use std::path::Path;

use super::{Context, ValidateError};
use crate::case::Case;
use crate::frame::{Frame, Kind, SurfaceFrame};
use crate::output::{OutputError, Summary};
use crate::run::{Recorder, Stopwatch, simulate};
use crate::scene::{AnyCase, Scene};
use crate::solver::Simulation;

/// A scene of the project, by name and text.
#[derive(Clone, Copy, Debug)]
pub struct Source {
    /// Name of the case.
    pub name: &'static str,
    /// The file.
    pub text: &'static str,
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
}

/// Runs a scene with `settings` (`section.key=value`).
pub fn run(
    source: Source,
    settings: &[String],
    context: &Context<'_>,
) -> Result<Outcome, ValidateError> {
    (context.announce)(&format!("{}: {}", source.name, settings.join(" ")));
    let mut scene = Scene::parse(source.text, source.name, Path::new(""))?;
    for setting in settings {
        scene.set(setting)?;
    }
    let stopwatch = Stopwatch::start();
    let result = match scene.build_any()? {
        AnyCase::One(case) => finish(*case, stopwatch),
        AnyCase::Two(case) => finish(*case, stopwatch),
        AnyCase::Three(case) => finish(*case, stopwatch),
    };
    result.map_err(|error| ValidateError::Run {
        case: source.name.into(),
        variant: settings.join(" "),
        source: Box::new(error),
    })
}

fn finish<const D: usize>(
    case: Case<D>,
    stopwatch: Stopwatch,
) -> Result<Outcome, crate::run::RunError> {
    let (simulation, summary) = simulate(case, &mut Silent, stopwatch)?;
    let frame = simulation.frame();
    let gas = gas(&frame);
    Ok(Outcome {
        gas,
        frame,
        surface: simulation.surface(),
        summary,
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

/// Records nothing.
struct Silent;

impl<const D: usize> Recorder<D> for Silent {
    fn frame(&mut self, _: &Simulation<D>) -> Result<(), OutputError> {
        Ok(())
    }

    fn step(&mut self, _: &Simulation<D>, _: f64) -> Result<ControlFlow<()>, OutputError> {
        Ok(ControlFlow::Continue(()))
    }
}
