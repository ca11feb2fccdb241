//! A force at a distance that drives all gas.

use std::sync::Arc;

use aero_solver::problem::{BodyForce, Problem, Side, Source};

use super::error::SceneError;
use super::file::SceneFile;
use super::vector::{side_key, vector_or_zero};

/// That of the scene; none where it is zero.
///
/// # Errors
/// One across a plane of symmetry, and one beside a manufactured solution.
pub(super) fn source<const D: usize>(
    file: &SceneFile,
    problem: &Problem<D>,
) -> Result<Option<Arc<dyn Source<D>>>, SceneError> {
    const KEY: &str = "body_force";
    let force = vector_or_zero::<D>(KEY, file.body_force.as_ref())?;
    if force.norm_squared() == 0.0 {
        return Ok(None);
    }
    if file.manufactured.is_some() {
        return Err(SceneError::value(
            KEY,
            "stands beside [manufactured], whose sources are all that is added; leave out one of them",
        ));
    }
    for (axis, end, side, _) in problem.domain.each_side() {
        let is_mirror = matches!(side, Side::Symmetry | Side::Axis);
        if is_mirror && force[axis] != 0.0 {
            let name = side_key(axis, end);
            return Err(SceneError::value(
                KEY,
                format!(
                    "drives gas through {name}, beyond which the flow is the mirror image; \
                     let it lie along that side, or make the side a wall"
                ),
            ));
        }
    }
    Ok(Some(Arc::new(BodyForce(force))))
}
