//! Vortices that decay by friction, by each scheme, on a lattice at the start.

use std::f64::consts::{PI, TAU};

use aero_solver::frame::Frame;
use aero_validation::table::{Check, Subject};

use super::{NAME, SCHEMES};
use crate::context::{CompareError, Context, Level};
use crate::scenes::{Source, scene};

const SCENE: Source = scene!("vortices-liquid");
const THEORY: &str = "exp(-8 pi^2 t / Re) (Taylor & Green 1937)";
/// As in the scene.
const REYNOLDS: f64 = 100.0;
/// Per cent of what decays.
const ALLOWED: f64 = 1.0;

/// What the schemes of second order must show between two spacings.
const LEAST_ORDER: f64 = 1.8;
/// The scheme whose gradients are not renormalised: its error grows as particles leave their lattice, in print too.
const DIVERGES: &str = "EDAC";

pub(super) fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let (cells, end): (&[u32], f64) = match context.level {
        Level::Quick => (&[50], 0.02),
        Level::Full => (&[25, 50], 0.5),
    };
    let mut checks = Vec::new();
    for scheme in SCHEMES {
        let mut errors: Vec<(u32, f64)> = Vec::new();
        for &cells in cells {
            let settings = [
                format!("scheme.equations={scheme}"),
                format!("spacing={:?}", 1.0 / f64::from(cells)),
                format!("end_time={end:?}"),
            ];
            let label = format!("{scheme}, vortices, {cells} cells, a lattice at the start");
            let attempt = SCENE.attempt(&settings, context)?;
            let gas = attempt.outcome().map(|outcome| &outcome.gas);
            let is_judged = cells == 50 && scheme != DIVERGES;
            checks.extend(judged(&label, gas, end, is_judged));
            errors.extend(gas.map(|gas| (cells, error(gas, end))));
        }
        for pair in errors.windows(2) {
            let [(coarse, more), (fine, less)] = [pair[0], pair[1]];
            let order = (more / less).ln() / (f64::from(fine) / f64::from(coarse)).ln();
            let what =
                format!("{scheme}, vortices, {coarse} to {fine} cells: order of the velocity");
            let subject = Subject::new(NAME, &what, "second order (Negi & Ramachandran 2021)");
            checks.push(if scheme == DIVERGES {
                subject.informs(order, 2.0)
            } else {
                subject.at_least(order, LEAST_ORDER)
            });
        }
    }
    Ok(checks)
}

/// The part of its first speed that the flow has at `time`.
fn left(time: f64) -> f64 {
    (-8.0 * PI * PI / REYNOLDS * time).exp()
}

fn velocity(position: &[f64; 3], time: f64) -> [f64; 2] {
    let [x, y] = [0, 1].map(|k| TAU * position[k]);
    [
        -x.cos() * y.sin() * left(time),
        x.sin() * y.cos() * left(time),
    ]
}

/// Mean error of the velocity over the first speed.
fn error(gas: &Frame, time: f64) -> f64 {
    let each = gas
        .position
        .iter()
        .zip(&gas.velocity)
        .map(|(place, found)| {
            let [u, v] = velocity(place, time);
            (found[0] - u).hypot(found[1] - v)
        });
    each.sum::<f64>() / gas.position.len() as f64
}

/// The rows of one run: how fast the flow decays, where that is asked for, and how far off it is.
fn judged(label: &str, gas: Option<&Frame>, end: f64, is_judged: bool) -> Vec<Check> {
    let [rate, off] = [
        "rate of decay of the velocity",
        "mean error of the velocity",
    ]
    .map(|what| format!("{label}: {what}"));
    let [rate, off] = [&rate, &off].map(|what| Subject::new(NAME, what, THEORY));
    let exact = 8.0 * PI * PI / REYNOLDS;
    let Some(gas) = gas else {
        return vec![rate.unmeasured(exact)];
    };
    // What of the exact pattern is left.
    let (mut along, mut whole) = (0.0, 0.0);
    for (place, found) in gas.position.iter().zip(&gas.velocity) {
        let [u, v] = velocity(place, 0.0);
        along += found[0] * u + found[1] * v;
        whole += u * u + v * v;
    }
    let found = -(along / whole).ln() / end;
    vec![
        if is_judged {
            rate.relative(found, exact, ALLOWED)
        } else {
            rate.informs(found, exact)
        },
        off.informs(error(gas, end), 0.0),
    ]
}
