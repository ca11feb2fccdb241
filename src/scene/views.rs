//! From `output.field` and `output.picture` to what is shown of the gas between its particles or points.

use aero_geometry::Bounds;
use aero_solver::problem::Domain;
use serde::Deserialize;

use super::error::SceneError;
use super::file::RegionEntry;
use super::number::Positive;
use super::output::region;
use super::vector::AXES;
use crate::case::FieldPlan;
use crate::sample::Lattice;

/// `output.field`: the gas on a lattice.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LatticeEntry {
    /// The box that it fills; the domain unless given.
    pub region: Option<RegionEntry>,
    /// About how far apart its points are; the scene's spacing unless given.
    pub spacing: Option<Positive>,
}

/// More points than this are a slip of the pen: a frame of them has 8 GB.
const MOST: f64 = 1e8;

/// The field of a scene whose gas is `spacing` apart.
pub(super) fn field<const D: usize>(
    entry: &LatticeEntry,
    (domain, mirrors): (&Domain<D>, &[(usize, f64)]),
    spacing: f64,
) -> Result<FieldPlan<D>, SceneError> {
    const PLACE: &str = "output.field";
    let region = match &entry.region {
        Some(entry) => within(&format!("{PLACE}.region"), region(PLACE, entry)?, domain)?,
        None => domain.bounds,
    };
    let spacing = entry.spacing.map_or(spacing, Positive::get);
    let points: f64 = region
        .size()
        .iter()
        .map(|size| size / spacing + 1.0)
        .product();
    if points > MOST {
        let least = (region.size().iter().product::<f64>() / MOST).powf(1.0 / D as f64);
        return Err(SceneError::value(
            PLACE,
            format!(
                "would have {points:.1e} points, more than {MOST:.0e}; give a smaller region or a spacing of {least:.2e} or more"
            ),
        ));
    }
    let mut lattice = Lattice::new(&region, spacing);
    let whole = mirrored(region, mirrors);
    for k in 0..D {
        if whole.size()[k] > region.size()[k] {
            lattice.cells[k] *= 2;
        }
    }
    lattice.origin = whole.min;
    Ok(FieldPlan { lattice })
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
