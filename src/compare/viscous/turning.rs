//! Gas between a cylinder that turns and a round hole.

use aero::run::Outcome;
use aero_validation::exact::turning::TurningCylinder;
use aero_validation::table::{Check, Subject};

use super::NAME;
use crate::context::{CompareError, Context, Level};
use crate::scenes::{Source, scene};

const SCENE: Source = scene!("taylor-couette");
const THEORY: &str = "Taylor 1923, eq. 1";
/// As in the scene.
const CYLINDER: TurningCylinder = TurningCylinder {
    inner: 0.25,
    outer: 0.5,
    rate: 0.4,
    viscosity: 0.0025,
};
/// Per cent, on ten cells across the gap: of the speed of the cylinder, by points; of the moment.
const SPEED: f64 = 1.0;
const MOMENT: f64 = 2.0;
/// Least order of the error by points.
const ORDER: f64 = 1.5;
/// Per cent of the cylinder's speed by which all particles may lag or lead in the mean: one alone has more noise.
const LAG: f64 = 1.5;

pub(super) fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let cells: &[u32] = match context.level {
        Level::Quick => &[10],
        Level::Full => &[10, 20],
    };
    let mut checks = Vec::new();
    let mut errors = Vec::new();
    for &cells in cells {
        let (error, rows) = by_points(cells, context)?;
        errors.extend(error);
        checks.extend(rows);
    }
    if let [coarse, fine] = errors[..] {
        let what = format!(
            "turning cylinder, points, {} to {} cells: order of the error of the speed",
            cells[0], cells[1]
        );
        let order = (coarse / fine).log2();
        checks.push(Subject::new(NAME, &what, THEORY).at_least(order, ORDER));
    }
    checks.push(by_particles(cells[0], context)?);
    Ok(checks)
}

/// Root of the mean square error of the speed, and rows.
fn by_points(cells: u32, context: &Context<'_>) -> Result<(Option<f64>, [Check; 2]), CompareError> {
    let names = [
        "error of the speed (L2), per cent of the cylinder's",
        "moment on the cylinder",
    ]
    .map(|quantity| format!("turning cylinder, points, {cells} cells across: {quantity}"));
    let [speed, moment] = [&names[0], &names[1]].map(|what| Subject::new(NAME, what, THEORY));
    let attempt = SCENE.attempt(&[spacing(cells)], context)?;
    Ok(match attempt.outcome() {
        None => (None, [speed.unmeasured(SPEED), moment.unmeasured(1.0)]),
        Some(outcome) => {
            let errors = errors(outcome);
            let square = errors.iter().map(|error| error * error).sum::<f64>();
            let error = (square / errors.len() as f64).sqrt();
            let found = -outcome.summary.bodies["cylinder"].moment[2];
            let rows = [
                speed.at_most(100.0 * error, SPEED),
                moment.relative(found / CYLINDER.moment(), 1.0, MOMENT),
            ];
            (Some(error), rows)
        }
    })
}

fn by_particles(cells: u32, context: &Context<'_>) -> Result<Check, CompareError> {
    let what = format!(
        "turning cylinder, particles, {cells} cells across: mean error of the speed, per cent of the cylinder's"
    );
    let subject = Subject::new(NAME, &what, THEORY);
    let settings = [spacing(cells), "scheme.motion=with-the-gas".into()];
    let attempt = SCENE.attempt(&settings, context)?;
    Ok(match attempt.outcome() {
        None => subject.unmeasured(0.0),
        Some(outcome) => {
            let errors = errors(outcome);
            let mean = errors.iter().sum::<f64>() / errors.len() as f64;
            subject.at_most(100.0 * mean.abs(), LAG)
        }
    })
}

fn spacing(cells: u32) -> String {
    let gap = CYLINDER.outer - CYLINDER.inner;
    format!("spacing={:?}", gap / f64::from(cells))
}

/// Error of each one's speed around the axis over the cylinder's.
fn errors(outcome: &Outcome) -> Vec<f64> {
    let gas = &outcome.gas;
    let whole = CYLINDER.speed(CYLINDER.inner);
    let each = gas.position.iter().zip(&gas.velocity);
    each.map(|([x, y, _], [u, v, _])| {
        let radius = x.hypot(*y);
        ((x * v - y * u) / radius - CYLINDER.speed(radius)) / whole
    })
    .collect()
}
