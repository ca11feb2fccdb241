//! Vectors of a scene, as many numbers as it has dimensions.

use aero_geometry::Vector;
use aero_solver::problem::side_name;

use super::error::SceneError;
use super::number::Finite;

/// A vector of the scene's dimension.
pub(super) fn vector<const D: usize>(
    place: &str,
    numbers: &[Finite],
) -> Result<Vector<D>, SceneError> {
    if numbers.len() == D {
        return Ok(Vector::<D>::from_fn(|k, _| numbers[k].get()));
    }
    let given = numbers.len();
    Err(SceneError::value(
        place,
        format!("holds {given} numbers, but the scene has dimension {D}; give {D}"),
    ))
}

/// As [`vector`], zero where the key is absent.
pub(super) fn vector_or_zero<const D: usize>(
    place: &str,
    numbers: Option<&Vec<Finite>>,
) -> Result<Vector<D>, SceneError> {
    numbers.map_or(Ok(Vector::zeros()), |numbers| vector(place, numbers))
}

/// The key of a side.
pub(super) fn side_key(axis: usize, end: usize) -> String {
    format!("domain.sides.{}", side_name(axis, end))
}
