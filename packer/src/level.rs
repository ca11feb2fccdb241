//! Points brought onto a level of the signed distance.

use aero_geometry::{Shape, Vector};

/// Steps of Newton's method before a point is left where it is (on a ridge of the distance).
const MAX_STEPS: usize = 30;

/// Moves `point` along the gradient onto `distance = level`; nothing where that does not succeed to
/// `tolerance`.
pub(crate) fn project<const D: usize>(
    shape: &dyn Shape<D>,
    point: &Vector<D>,
    level: f64,
    tolerance: f64,
) -> Option<Vector<D>> {
    let mut position = *point;
    for _ in 0..MAX_STEPS {
        let closest = shape.closest(&position);
        let error = closest.distance - level;
        if error.abs() <= tolerance {
            return Some(position);
        }
        position -= error * closest.normal;
    }
    let error = shape.signed_distance(&position) - level;
    (error.abs() <= 1e3 * tolerance).then_some(position)
}

/// As [`project`], along the coordinate axis `along` only: keeps a point on a mirror plane.
pub(crate) fn project_along<const D: usize>(
    shape: &dyn Shape<D>,
    point: &Vector<D>,
    level: f64,
    along: usize,
    tolerance: f64,
) -> Option<Vector<D>> {
    let mut position = *point;
    for _ in 0..MAX_STEPS {
        let closest = shape.closest(&position);
        let error = closest.distance - level;
        if error.abs() <= tolerance {
            return Some(position);
        }
        let slope = closest.normal[along];
        if slope.abs() < 0.02 {
            return None;
        }
        position[along] -= error / slope;
    }
    None
}
