//! A cylinder that gas creeps past, with a steady wake.

use aero_validation::table::{Check, Subject};

use super::NAME;
use crate::compare::context::{CompareError, Context};
use crate::compare::scenes::{Source, scene};

const SCENE: Source = scene!("cylinder-viscous");
const THEORY: &str = "incompressible, without bounds (Dennis & Chang 1970)";
/// Drag coefficient there at a Reynolds number of 20.
const DRAG: f64 = 2.045;
/// Per cent.
const ALLOWED: f64 = 3.0;

pub(super) fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let what = "cylinder, Re 20, M 0.1, 32 cells to its diameter: c_d";
    let subject = Subject::new(NAME, what, THEORY);
    let attempt = SCENE.attempt(&[], context)?;
    Ok(vec![match attempt.outcome() {
        None => subject.unmeasured(DRAG),
        Some(outcome) => {
            let body = &outcome.summary.bodies["cylinder"];
            subject.relative(body.cd.unwrap_or(f64::NAN), DRAG, ALLOWED)
        }
    }])
}
