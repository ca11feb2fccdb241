//! Sides that a body is to close: is there one everywhere?

use super::vector::side_key;
use aero_geometry::{Shape, Vector};

use super::error::SceneError;

use aero_solver::problem::{Domain, Side};

/// A side that is to be closed by a body must be inside one everywhere, or gas would leave there.
pub(super) fn check_covered_sides<const D: usize>(
    domain: &Domain<D>,
    surfaces: &[&dyn Shape<D>],
    spacing: f64,
) -> Result<(), SceneError> {
    for k in 0..D {
        for end in 0..2 {
            if domain.sides[k][end] != Side::Body {
                continue;
            }
            let open = open_point(domain, surfaces, spacing, [k, end]);
            if let Some(point) = open {
                return Err(SceneError::value(
                    side_key(k, end),
                    format!(
                        "is closed by a body, but no body is near ({}); choose another side there or extend the body",
                        list(&point)
                    ),
                ));
            }
        }
    }
    Ok(())
}

/// A point of one side, half a spacing outside of all bodies or farther; none if there is none.
fn open_point<const D: usize>(
    domain: &Domain<D>,
    surfaces: &[&dyn Shape<D>],
    spacing: f64,
    [axis, end]: [usize; 2],
) -> Option<Vector<D>> {
    /// Enough to find a gap that matters; a finer one shows as a leak.
    const MOST: usize = 200;
    let bounds = &domain.bounds;
    let counts: [usize; D] = std::array::from_fn(|k| {
        let count = (bounds.size()[k] / spacing).ceil() as usize;
        if k == axis { 1 } else { count.clamp(1, MOST) }
    });
    let total: usize = counts.iter().product();
    (0..total).find_map(|number| {
        let mut rest = number;
        let mut point = Vector::<D>::zeros();
        for k in 0..D {
            let part = (rest % counts[k]) as f64 + 0.5;
            rest /= counts[k];
            point[k] = bounds.min[k] + bounds.size()[k] * part / counts[k] as f64;
        }
        point[axis] = if end == 0 { bounds.min } else { bounds.max }[axis];
        let covered = surfaces
            .iter()
            .any(|surface| surface.signed_distance(&point) <= 0.5 * spacing);
        (!covered).then_some(point)
    })
}

fn list<const D: usize>(point: &Vector<D>) -> String {
    let numbers: Vec<String> = point.iter().map(|x| format!("{x:.4}")).collect();
    numbers.join(", ")
}
