//! Where outputs are: boxes in a scene's domain, and their images.

use aero_geometry::Bounds;
use aero_solver::problem::{AXES, Domain, State};
use serde::Deserialize;

use super::error::SceneError;
use super::number::Finite;
use super::vector::vector;

/// What outputs are to fit.
pub(super) struct Surroundings<'a, const D: usize> {
    pub(super) domain: &'a Domain<D>,
    pub(super) spacing: f64,
    pub(super) stream: &'a State<D>,
    pub(super) gas_constant: Option<f64>,
}

/// `output.region`: a box.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RegionEntry {
    /// Lowest corner.
    pub min: Vec<Finite>,
    /// Highest corner.
    pub max: Vec<Finite>,
}

/// The box that `place.region` gives.
pub(super) fn region<const D: usize>(
    place: &str,
    entry: &RegionEntry,
) -> Result<Bounds<D>, SceneError> {
    let bounds = Bounds::new(
        vector(&format!("{place}.region.min"), &entry.min)?,
        vector(&format!("{place}.region.max"), &entry.max)?,
    );
    match (0..D).find(|&k| bounds.min[k] >= bounds.max[k]) {
        None => Ok(bounds),
        Some(k) => Err(SceneError::value(
            format!("{place}.region"),
            format!("is empty along {}; give a `max` above its `min`", AXES[k]),
        )),
    }
}

/// The planes that a scene is mirrored at, `(axis, place)`.
pub(super) fn mirrors<const D: usize>(domain: &Domain<D>) -> Result<Vec<(usize, f64)>, SceneError> {
    let sides = domain
        .each_side()
        .filter(|(_, _, side, _)| side.is_mirror());
    let mirrors: Vec<(usize, f64)> = sides.map(|(axis, _, _, face)| (axis, face)).collect();
    if mirrors.is_empty() {
        return Err(SceneError::value(
            "output.mirror",
            "the scene has no symmetry side and no axis, and is whole already; leave it out",
        ));
    }
    if mirrors.windows(2).any(|pair| pair[0].0 == pair[1].0) {
        return Err(SceneError::value(
            "output.mirror",
            "both sides of an axis are mirrors, and images would have no end; leave it out",
        ));
    }
    Ok(mirrors)
}

/// A box with its images at those of `mirrors` that it touches.
pub(super) fn mirrored<const D: usize>(
    mut bounds: Bounds<D>,
    mirrors: &[(usize, f64)],
) -> Bounds<D> {
    for &(axis, face) in mirrors {
        if bounds.min[axis] == face {
            bounds.min[axis] = 2.0 * face - bounds.max[axis];
        } else if bounds.max[axis] == face {
            bounds.max[axis] = 2.0 * face - bounds.min[axis];
        }
    }
    bounds
}

/// `bounds`, which must lie in the domain.
pub(super) fn within<const D: usize>(
    place: &str,
    bounds: Bounds<D>,
    domain: &Domain<D>,
) -> Result<Bounds<D>, SceneError> {
    /// Round-off of decimal fractions, in sizes of the domain.
    const ROUND_OFF: f64 = 1e-9;
    let size = domain.bounds.size();
    let beyond = (0..D).find(|&k| {
        let slack = ROUND_OFF * size[k];
        bounds.min[k] < domain.bounds.min[k] - slack || bounds.max[k] > domain.bounds.max[k] + slack
    });
    match beyond {
        None => Ok(bounds),
        Some(k) => Err(SceneError::value(
            place,
            format!(
                "reaches beyond the domain, where there is no gas; along {} keep it between {} and {}",
                AXES[k], domain.bounds.min[k], domain.bounds.max[k]
            ),
        )),
    }
}
