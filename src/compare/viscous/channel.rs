//! Gas that a force drives between two walls, from rest: how fast the error of its velocity falls.

use aero_validation::exact::channel::Channel;
use aero_validation::table::{Check, Subject};

use super::NAME;
use crate::context::{CompareError, Context, Level};
use crate::scenes::{Source, scene};

const SCENE: Source = scene!("poiseuille");
const THEORY: &str = "Poiseuille flow from rest (Morris, Fox & Zhu 1997, eq. 35)";
/// As the scene has it.
const CHANNEL: Channel = Channel {
    height: 1.0,
    viscosity: 0.1,
};
const FORCE: f64 = 0.8;
const END: f64 = 1.0;
/// Spacings along the walls; particles would meet their own images on fewer.
const WIDTH: u32 = 12;
/// Least order of the error.
const ORDER: f64 = 1.8;
/// Largest error on the finer of two, per cent of the end's greatest speed.
const ALLOWED: f64 = 1.0;

pub(super) fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let cells = match context.level {
        Level::Quick => [12, 24],
        Level::Full => [24, 48],
    };
    let mut checks = Vec::new();
    for (who, motion) in [("points", "fixed"), ("particles", "with-the-gas")] {
        let [coarse, fine] = cells;
        let errors = [
            error(motion, coarse, context)?,
            error(motion, fine, context)?,
        ];
        let what =
            format!("{who}, driven from rest, {fine} cells: error of the velocity (L2), per cent");
        let subject = Subject::new(NAME, &what, THEORY);
        checks.push(match errors[1] {
            Some(error) => subject.at_most(100.0 * error, ALLOWED),
            None => subject.unmeasured(ALLOWED),
        });
        let what = format!("{who}, driven from rest, {coarse} to {fine} cells: order of the error");
        let subject = Subject::new(NAME, &what, THEORY);
        checks.push(match errors {
            [Some(first), Some(second)] => subject.at_least((first / second).log2(), ORDER),
            _ => subject.unmeasured(ORDER),
        });
    }
    Ok(checks)
}

/// Root of the mean square error of the velocity at the end; none of a run that fails.
fn error(motion: &str, cells: u32, context: &Context<'_>) -> Result<Option<f64>, CompareError> {
    let spacing = CHANNEL.height / f64::from(cells);
    let settings = [
        format!("scheme.motion={motion}"),
        format!("spacing={spacing:?}"),
        format!("domain.max=[{:?}, 1.0]", f64::from(WIDTH) * spacing),
    ];
    let attempt = SCENE.attempt(&settings, context)?;
    Ok(attempt.outcome().map(|outcome| {
        let gas = &outcome.gas;
        let errors = gas.position.iter().zip(&gas.velocity);
        let errors =
            errors.map(|(place, found)| (found[0] - CHANNEL.driven(FORCE, place[1], END)).powi(2));
        (errors.sum::<f64>() / gas.position.len() as f64).sqrt()
    }))
}
