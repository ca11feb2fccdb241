//! Vortices that friction alone slows down.

use std::f64::consts::TAU;

use aero_validation::table::{Check, Subject};

use super::NAME;
use crate::context::{CompareError, Context, Level};
use crate::scenes::{Source, scene};

const SCENE: Source = scene!("taylor-green");
const THEORY: &str = "exp(-4 nu k^2 t) (Taylor & Green 1937)";
/// As in the scene.
const VISCOSITY: f64 = 0.02;
const SPEED: f64 = 0.05;
const END: f64 = 0.5;
/// Per cent.
const ALLOWED: f64 = 1.0;

pub(super) fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let cells = match context.level {
        Level::Quick => 32,
        Level::Full => 64,
    };
    let what =
        format!("vortices, {cells} cells to a period: rate at which their energy falls, 4 nu k^2");
    let subject = Subject::new(NAME, &what, THEORY);
    let spacing = 1.0 / f64::from(cells);
    let attempt = SCENE.attempt(&[format!("spacing={spacing:?}")], context)?;
    let exact = 4.0 * VISCOSITY * TAU * TAU;
    Ok(vec![match attempt.outcome() {
        None => subject.unmeasured(exact),
        Some(outcome) => {
            let gas = &outcome.gas;
            let squares = gas.velocity.iter().map(|u| u[0] * u[0] + u[1] * u[1]);
            let mean = squares.sum::<f64>() / gas.velocity.len() as f64;
            // At the start the mean of sin^2 cos^2 twice over.
            let rate = (0.5 * SPEED * SPEED / mean).ln() / END;
            subject.relative(rate, exact, ALLOWED)
        }
    }])
}
