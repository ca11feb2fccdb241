//! A shock that runs over a cylinder of helium.

use aero::run::Keep;
use aero_solver::frame::Frame;
use aero_validation::table::{Check, Subject};

use super::{NAME, places};
use crate::context::{CompareError, Context, Level};
use crate::scenes::{Source, scene};

const SCENE: Source = scene!("helium-bubble");
const EXPERIMENT: &str =
    "measured, within a tenth (Haas & Sturtevant 1987, as later computations quote them)";

/// Speeds of the side that looks downstream and of the jet that comes in from upstream, m/s.
const MEASURED: [f64; 2] = [145.0, 230.0];

/// Height above the axis below which gas is on it, in spacings.
const ON_AXIS: f64 = 1.6;

/// Only at the full level: the scene as it is.
pub(super) fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    if context.level == Level::Quick {
        return Ok(Vec::new());
    }
    let outcome = SCENE.run(&[], Keep::Frames, context)?;
    let frames = &outcome.history.frames;
    let speed = |place: fn(&Frame) -> f64| {
        let (first, last) = (frames.first()?, frames.last()?);
        let time = last.time - first.time;
        (time > 0.0).then(|| (place(last) - place(first)) / time)
    };
    let found = [speed(downstream), speed(upstream)];
    let names = [
        "speed of the downstream side, m/s",
        "speed of the jet on the axis, m/s",
    ];
    let checks = (0..2).map(|k| {
        let what = format!("shock of Mach 1.22 on a bubble: {}", names[k]);
        let subject = Subject::new(NAME, &what, EXPERIMENT);
        match found[k] {
            None => subject.unmeasured(MEASURED[k]),
            Some(found) => subject.informs(found, MEASURED[k]),
        }
    });
    Ok(checks.collect())
}

fn downstream(gas: &Frame) -> f64 {
    let all = places(gas, true, |_| true);
    all.into_iter()
        .map(|i| gas.position[i][0])
        .fold(f64::NEG_INFINITY, f64::max)
}

fn upstream(gas: &Frame) -> f64 {
    let least = |place: &[f64; 3]| place[1] < ON_AXIS * 1e-3;
    let near = places(gas, true, least);
    near.into_iter()
        .map(|i| gas.position[i][0])
        .fold(f64::INFINITY, f64::min)
}
