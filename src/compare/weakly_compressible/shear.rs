//! Liquid that a wall sets in motion: Couette's flow as it starts.

use std::f64::consts::PI;

use aero_validation::table::{Check, Subject};

use super::NAME;
use crate::compare::context::{CompareError, Context, Level};
use crate::compare::scenes::{Source, scene};

const SCENE: Source = scene!("cavity");
const THEORY: &str = "Couette's flow as it starts (Morris, Fox & Zhu 1997, eq. 36)";
const VISCOSITY: f64 = 1.0;
/// By then the far wall has felt it.
const END: f64 = 0.1;
/// Cells along the walls; particles would meet their own images on fewer.
const WIDTH: u32 = 12;
/// Largest error over the speed of the wall, per cent.
const ALLOWED: f64 = 1.0;

pub(super) fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let (schemes, cells): (&[&str], &[u32]) = match context.level {
        Level::Quick => (&["L-IPST-C", "EDAC"], &[20]),
        Level::Full => (
            &[
                "L-IPST-C",
                "PE-IPST-C",
                "TV-C",
                "E-C",
                "EDAC",
                "conservative",
            ],
            &[20, 40],
        ),
    };
    let mut checks = Vec::new();
    for scheme in schemes {
        for &cells in cells {
            let spacing = 1.0 / f64::from(cells);
            let settings = [
                format!("scheme.equations={scheme}"),
                format!("spacing={spacing:?}"),
                format!("end_time={END:?}"),
                format!("gas.viscosity={VISCOSITY:?}"),
                format!("domain.max=[{:?}, 1.0]", f64::from(WIDTH) * spacing),
                "domain.sides.x_min=periodic".into(),
                "domain.sides.x_max=periodic".into(),
            ];
            let what = format!(
                "{scheme}, shear that starts, {cells} cells: largest error of the velocity, per cent"
            );
            let subject = Subject::new(NAME, &what, THEORY);
            let attempt = SCENE.attempt(&settings, context)?;
            checks.push(match attempt.outcome() {
                None => subject.unmeasured(ALLOWED),
                Some(outcome) => {
                    let gas = &outcome.gas;
                    let errors = gas.position.iter().zip(&gas.velocity);
                    let errors = errors.map(|(place, found)| (found[0] - speed(place[1])).abs());
                    subject.at_most(100.0 * errors.fold(0.0, f64::max), ALLOWED)
                }
            });
        }
    }
    Ok(checks)
}

/// `u = y + sum 2 / (n pi) (-1)^n sin(n pi y) exp(-nu n^2 pi^2 t)` at the end.
fn speed(y: f64) -> f64 {
    let term = |n: u32| {
        let n = f64::from(n);
        let sign = if n % 2.0 == 0.0 { 1.0 } else { -1.0 };
        2.0 / (n * PI) * sign * (n * PI * y).sin() * (-VISCOSITY * n * n * PI * PI * END).exp()
    };
    y + (1..40).map(term).sum::<f64>()
}
