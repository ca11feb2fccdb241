//! From `output.field` and `output.picture` to what is shown of the gas between its particles or points.

use aero_solver::problem::Domain;
use serde::Deserialize;

use super::error::SceneError;
use super::number::Positive;
use super::region::{RegionEntry, mirrored, region, within};
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
