//! The inside of a shock.

use aero_solver::frame::Frame;
use aero_validation::exact::becker::width;
use aero_validation::table::{Check, Subject};

use super::{GAMMA, NAME};
use crate::context::{CompareError, Context, Level};
use crate::scenes::{Source, scene};

const SCENE: Source = scene!("becker");
const THEORY: &str = "Becker 1922, Prandtl number 3/4";
/// Per cent.
const ALLOWED: f64 = 1.0;

pub(super) fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let (machs, spacing): (&[f64], f64) = match context.level {
        Level::Quick => (&[2.0], 0.2),
        Level::Full => (&[2.0, 3.0], 0.1),
    };
    machs
        .iter()
        .map(|&mach| {
            let what = format!(
                "shock, M {mach}, spacing {spacing} mu/m: density from 10 to 90 %, in mu/m"
            );
            let subject = Subject::new(NAME, &what, THEORY);
            let (found, expected) = width_of(mach, &settings(mach, spacing), context)?;
            Ok(match found {
                Some(found) => subject.relative(found, expected, ALLOWED),
                None => subject.unmeasured(expected),
            })
        })
        .collect()
}

/// Width of the shock at the end of a run, none where it failed, and the exact one.
fn width_of(
    mach: f64,
    settings: &[String],
    context: &Context<'_>,
) -> Result<(Option<f64>, f64), CompareError> {
    let attempt = SCENE.attempt(settings, context)?;
    let found = attempt.outcome().map(|outcome| rise(&outcome.gas));
    Ok((found, width(mach, GAMMA)?))
}

fn settings(mach: f64, spacing: f64) -> Vec<String> {
    let square = mach * mach;
    let ahead = 1.0 / (GAMMA * square);
    let velocity = ((GAMMA - 1.0) * square + 2.0) / ((GAMMA + 1.0) * square);
    let behind = ahead + 1.0 - velocity;
    let step = format!("{:?} * (1 + tanh(x / 3)) / 2", 1.0 - velocity);
    vec![
        format!("spacing={spacing:?}"),
        format!("free_stream.pressure={ahead:?}"),
        format!(
            "domain.sides.x_max={{ free-stream = {{ density = {:?}, velocity = [{velocity:?}], pressure = {behind:?} }} }}",
            1.0 / velocity
        ),
        format!("initial.field.density=\"1 / (1 - {step})\""),
        format!("initial.field.pressure=\"{ahead:?} + {step}\""),
        format!("initial.field.velocity=[\"1 - {step}\"]"),
    ]
}

/// Distance over which the density rises from a tenth of its way to nine tenths; cells lie in the order of their places.
fn rise(gas: &Frame) -> f64 {
    let mut cells: Vec<[f64; 2]> = (0..gas.position.len())
        .map(|i| [gas.position[i][0], gas.density[i]])
        .collect();
    cells.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let (Some(first), Some(last)) = (cells.first(), cells.last()) else {
        return f64::NAN;
    };
    let at = |part: f64| {
        let level = first[1] + part * (last[1] - first[1]);
        let pair = cells.windows(2).find(|pair| pair[1][1] >= level);
        pair.map_or(f64::NAN, |pair| {
            let [[a, low], [b, high]] = [pair[0], pair[1]];
            a + (b - a) * (level - low) / (high - low)
        })
    };
    at(0.9) - at(0.1)
}
