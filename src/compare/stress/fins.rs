//! The tail of a rocket with four swept fins of 5 mm at incidence: their normal force hardly depends on how many spacings thick they are.

use aero::run::Outcome;
use aero_validation::table::Check;

use super::trial::Trial;
use crate::context::{CompareError, Context, Level};
use crate::row::Row;
use crate::scenes::{Source, scene};
use crate::surface::{Facet, as_shape, prism};
use crate::variant::{Motion, Scheme};

const TAIL: Source = scene!("stress", "finned-tail");

/// Half the thickness of a fin, m.
const HALF: f64 = 0.0025;

/// A fin along the tube and away from its axis, m: its root lies within the tube.
const FIN: [[f64; 2]; 4] = [[1.7, 0.04], [2.0, 0.04], [2.0, 0.15], [1.85, 0.15]];

/// Flies the tail by points that stay at two spacings: fins of 0.5 and 0.8 spacings, at the full level of 0.8 and 1.25.
pub(super) fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let spacings = match context.level {
        Level::Quick => [0.01, 0.006],
        Level::Full => [0.006, 0.004],
    };
    let shape = as_shape("fins", context.out, "fins", &fins())?;
    let scheme = Scheme::USUAL.by_points(Motion::Settled);
    let mut checks = Vec::new();
    let mut coarse = None;
    for spacing in spacings {
        let trial = Trial::new(TAIL, scheme)
            .called(format!("fins of 5 mm, spacing {} mm", 1e3 * spacing))
            .with([
                format!("spacing={spacing:?}"),
                shape.clone(),
                "body.fins.place={}".into(),
            ]);
        checks.extend(trial.compare(context, |outcome| {
            let found = force(outcome);
            let before = coarse.replace(found);
            let rows = before.map(|before| {
                Row::relative(
                    "normal force on the fins",
                    "the same at the coarser spacing",
                    found,
                    before,
                    5.0,
                )
            });
            Ok(rows.into_iter().collect())
        })?);
    }
    Ok(checks)
}

/// Gauge force on the fins, across the tube.
fn force(outcome: Option<&Outcome>) -> f64 {
    outcome.map_or(f64::NAN, |o| o.summary.bodies["fins"].force_gauge[1])
}

/// Four fins, two in the plane of symmetry and two across it.
fn fins() -> Vec<Facet> {
    let ends = [-HALF, HALF];
    let mut facets = Vec::new();
    for side in [1.0, -1.0] {
        let mut outline = FIN.map(|[x, r]| [x, side * r]);
        if side < 0.0 {
            outline.reverse();
        }
        facets.extend(prism(&outline, ends, |[x, r], across| [x, r, across]));
        outline.reverse();
        facets.extend(prism(&outline, ends, |[x, r], across| [x, across, r]));
    }
    facets
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The volume that facets enclose by the divergence theorem, each outward.
    #[test]
    fn fins_are_closed_and_face_outwards() {
        let dot = |a: [f64; 3], b: [f64; 3]| (0..3).map(|k| a[k] * b[k]).sum::<f64>();
        let volume = fins().into_iter().map(|[a, b, c]| {
            let cross = |i: usize, j: usize| b[i] * c[j] - b[j] * c[i];
            dot(a, [cross(1, 2), cross(2, 0), cross(0, 1)]) / 6.0
        });
        let exact = 4.0 * 2.0 * HALF * 0.11 * 0.5 * (0.3 + 0.15);
        let volume: f64 = volume.sum();
        assert!((volume / exact - 1.0).abs() < 1e-9, "{volume} {exact}");
    }
}
