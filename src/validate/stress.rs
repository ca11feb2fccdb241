//! Flows on which particle methods and finite volumes are known to fail, each against an exact or
//! agreed answer.
//!
//! A run that stops is a row that fails, not the end of the comparison: the table is there to show
//! where the method ends.

/// A scene of `cases/stress/` by its name.
macro_rules! source {
    ($name:literal) => {
        Source {
            name: $name,
            text: include_str!(concat!("../../../cases/stress/", $name, ".toml")),
        }
    };
}

mod base;
mod bodies;
mod edge;
mod line;
mod radial;
mod rows;
mod smooth;
mod tubes;

use std::path::Path;

use aero_validation::table::{Check, Subject};

use super::outcome::{Attempt, Source};
use super::{Context, Level, ValidateError};
use crate::scene::Scene;

/// A scheme with an extrapolation, and from which level on it is compared.
const VARIANTS: [(&str, &str, Level); 4] = [
    ("conservative", "wom", Level::Quick),
    ("conservative", "wm", Level::Quick),
    ("paper", "wom", Level::Full),
    ("paper", "wm", Level::Full),
];

/// Largest drift of mass, momentum and energy: what is left when no law loses anything but the
/// time step's error.
const DRIFT: f64 = 1e-3;

const GAMMA: f64 = 1.4;
/// Pressure of the stream past bodies where lengths, densities and speeds are of order one, `1 / gamma`.
const PRESSURE: f64 = 1.0 / GAMMA;

/// Runs the suite.
pub fn compare(context: &Context<'_>) -> Result<Vec<Check>, ValidateError> {
    let mut checks = tubes(context)?;
    checks.extend(balls(context)?);
    checks.extend(smooth(context)?);
    checks.extend(bodies(context)?);
    Ok(checks)
}

/// Runs the flows along a line.
pub fn tubes(context: &Context<'_>) -> Result<Vec<Check>, ValidateError> {
    let mut checks = line::compare(context)?;
    checks.extend(line::convergence(context)?);
    Ok(checks)
}

/// Runs the implosions and explosions.
pub fn balls(context: &Context<'_>) -> Result<Vec<Check>, ValidateError> {
    radial::compare(context)
}

/// Runs the flows without shocks.
pub fn smooth(context: &Context<'_>) -> Result<Vec<Check>, ValidateError> {
    smooth::compare(context)
}

/// Runs the flows around bodies.
pub fn bodies(context: &Context<'_>) -> Result<Vec<Check>, ValidateError> {
    bodies::compare(context)
}

/// Rows that every run gets: whether it came to its end, what it lost, and its extremes.
fn common_rows(name: &str, label: &str, strict: bool, attempt: &Attempt) -> Vec<Check> {
    let row = |quantity: &str, source: &str, measured: f64, bound: Option<f64>| {
        let quantity = format!("{label}: {quantity}");
        let subject = Subject::new(name, &quantity, source);
        match bound.filter(|_| strict) {
            Some(bound) => subject.at_most(measured, bound),
            None => subject.informs(measured, bound.unwrap_or(0.0)),
        }
    };
    let (summary, end) = match attempt {
        Attempt::Ended(outcome) => (&outcome.summary, "comes to its end".to_owned()),
        Attempt::Stopped(reason, summary) => (summary.as_ref(), format!("stops: {reason}")),
    };
    let stopped = f64::from(u8::from(matches!(attempt, Attempt::Stopped(..))));
    let drift = summary.conservation;
    let drift = drift.mass.abs().max(drift.momentum).max(drift.energy.abs());
    vec![
        row(&end, "a run must", stopped, Some(0.0)),
        row(
            "drift of mass, momentum, energy",
            "conservation",
            drift,
            Some(DRIFT),
        ),
        // A run stops where they are not positive, so they inform.
        row("smallest density", "positive", summary.min_density, None),
        row("smallest energy", "positive", summary.min_energy, None),
    ]
}

/// The scene of a source with its settings, for what the comparison needs of it.
fn scene(source: Source, settings: &[String]) -> Result<Scene, ValidateError> {
    let mut scene = Scene::parse(source.text, source.name, Path::new(""))?;
    for setting in settings {
        scene.set(setting)?;
    }
    Ok(scene)
}

/// Settings of a variant.
fn variant(equations: &str, extrapolation: &str) -> Vec<String> {
    vec![
        format!("scheme.equations={equations}"),
        format!("scheme.extrapolation={extrapolation}"),
    ]
}
