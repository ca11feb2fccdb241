//! What a scene with an axis must satisfy: the flow is the same all around it.

use super::vector::side_key;
use aero_solver::problem::{Domain, Motion, Side, State, Turning};
use nalgebra::Vector3;

use super::error::SceneError;

/// Refuses an axis that is no `r = 0`, and a stream or side that is not the same all around it.
pub(super) fn check<const D: usize>(
    domain: &Domain<D>,
    free_stream: &State<D>,
) -> Result<(), SceneError> {
    let fail = |place: &str, message: &str| Err(SceneError::value(place, message));
    for k in 0..D {
        for end in 0..2 {
            if domain.sides[k][end] == Side::Axis && (D, k, end) != (2, 1, 0) {
                return fail(
                    &side_key(k, end),
                    "only `y_min` of a scene of dimension 2 can be the axis: x runs along it, y is the radius",
                );
            }
        }
    }
    if !domain.is_axisymmetric() {
        return Ok(());
    }
    if domain.bounds.min[1] != 0.0 {
        return fail(
            "domain.min",
            "y must be 0, the axis, where `y_min` is \"axis\"",
        );
    }
    if free_stream.velocity[1] != 0.0 {
        return fail(
            "free_stream.direction",
            "the stream must run along x, the axis, where `y_min` is \"axis\"",
        );
    }
    Ok(())
}

/// Refuses a body that leaves the axis.
pub(super) fn check_motion<const D: usize>(
    name: &str,
    domain: &Domain<D>,
    motion: &Motion<D>,
) -> Result<(), SceneError> {
    let turns = motion.turning != Turning::Steady(Vector3::zeros());
    let may_leave =
        (motion.free.as_ref()).is_some_and(|free| !free.is_held[1] || free.keeps_turn != [true; 3]);
    let stays = !turns
        && !may_leave
        && (1..D).all(|k| motion.velocity[k] == 0.0 && motion.acceleration[k] == 0.0);
    if domain.is_axisymmetric() && !stays {
        return Err(SceneError::value(
            format!("body.{name}.motion"),
            "a body of an axisymmetric flow can move along x alone; drop the rest (of a free one by `constraints = [\"y\", \"turn\"]`), or set dimension = 3",
        ));
    }
    Ok(())
}
