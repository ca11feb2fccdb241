//! Thin parts: particles on the sheet mid-way between two faces.
//!
//! Where a body is thinner than the wall layers of both sides, one row lies in the middle, or two rows a quarter of the
//! thickness below either face where it is thicker than a spacing and a half; in space, what deeper layers leave between them is filled
//! likewise. Particles are one spacing apart along the part whatever its thickness, up to its rims and tips, and each has the volume
//! of what is nearest to it: `V = t dx^(D-1)` on a plate of thickness `t`, and no more than a row a spacing and a half thick gives. So a fin is
//! covered however thin it is.

mod ball;
mod seats;
mod shares;
mod sites;
mod spread;

use aero_geometry::Vector;
use aero_geometry::parallel::prelude::*;

pub(crate) use ball::chord;

use crate::PackError;
use crate::cloud::{Cloud, Lock};
use crate::nearest::Nearest;
use crate::plan::Plan;
use crate::surface::Sample;
use crate::thinnest::{THINNEST, Thinnest};
use shares::share_out;
use sites::{Site, sites};
use spread::spread;

/// Adds the particles of the thin parts below `samples` of the surface, and gives the volume of the thin parts to them, or to
/// those of the layers beside where too little is left for a row.
///
/// Gives the thinnest part, if it is too thin to be relied on.
///
/// # Errors
/// A body that is too thin everywhere.
pub(crate) fn lay<const D: usize>(
    plan: &Plan<'_, D>,
    cloud: &mut Cloud<D>,
    samples: &[Sample<D>],
) -> Result<Option<Thinnest>, PackError> {
    let bits = plan.row_bits();
    if bits.is_empty() {
        return Ok(None);
    }
    let found = sites(plan, samples, &bits);
    let thinnest = thinnest(plan, &found)?;
    let seeds = spread(plan, &found, cloud);
    let first = cloud.len();
    for seed in &seeds {
        cloud.push(seed.place, seed.layer, Lock::Row, 0.0);
    }
    share_out(plan, cloud, first, &bits);
    // One without a volume of its own stands in a sliver that no piece has its centre in.
    let least = LEAST_VOLUME * plan.particle_volume();
    for volume in &mut cloud.volume[first..] {
        *volume = volume.max(least);
    }
    Ok(thinnest)
}

/// Thinnest place that is neither the edge of something thicker nor one where two faces meet; refuses a body that is no thicker anywhere.
fn thinnest<const D: usize>(
    plan: &Plan<'_, D>,
    sites: &[Site<D>],
) -> Result<Option<Thinnest>, PackError> {
    let spacing = plan.options.spacing;
    let limit = NEARLY * THINNEST * spacing;
    let thick: Vec<Vector<D>> = sites
        .iter()
        .filter(|site| site.whole >= limit)
        .map(|site| site.place)
        .collect();
    let reach = EDGE * spacing;
    let nearest = Nearest::new(&plan.mirrors, &thick, reach);
    let found = |site: &Site<D>| Thinnest {
        thickness: site.whole / spacing,
        at: site.place.iter().copied().collect(),
        spacing,
    };
    let thin: Vec<&Site<D>> = sites
        .iter()
        .filter(|site| site.whole < limit)
        .filter(|site| nearest.find(&site.place, reach, |_| true).is_none())
        .collect();
    let is_plate: Vec<bool> = thin
        .par_iter()
        .map(|site| !ends_in_an_edge(plan, site))
        .collect();
    let plates = thin.iter().zip(is_plate).filter(|plate| plate.1);
    let by_thickness = |a: &&Site<D>, b: &&Site<D>| a.whole.total_cmp(&b.whole);
    let thinnest = plates.map(|plate| *plate.0).min_by(by_thickness);
    if thick.is_empty() && plan.roomy_cells().next().is_none() {
        // What is nothing but edges is kept as far as its thickest place asks for.
        let thickest = || thin.iter().copied().max_by(by_thickness);
        if let Some(found) = thinnest.or_else(thickest).map(found) {
            return Err(PackError::Thin {
                thickness: found.thickness,
                at: found.at,
                spacing,
            });
        }
    }
    Ok(thinnest.map(found))
}

/// True on a wedge that is as thin as wanted near its edge: the planes of both faces meet where the body ends. Sites on rims count as edges; those on faces
/// beside them know better.
fn ends_in_an_edge<const D: usize>(plan: &Plan<'_, D>, site: &Site<D>) -> bool {
    if site.area <= 0.0 {
        return true;
    }
    let opposite = site.place - 0.5 * site.whole * site.normal;
    let lean = site.normal + plan.shape.closest(&opposite).normal;
    if lean.norm() > ASKEW {
        // The way through ends at a face beside this one.
        return true;
    }
    let way = site.whole / lean.norm();
    let apex = site.place + way * lean.normalize();
    let beyond = BEYOND_EDGE * way + AT_THE_EDGE * plan.options.spacing;
    way.is_finite() && plan.shape.signed_distance(&apex) < beyond
}

/// Thickness is known to this part.
const NEARLY: f64 = 0.99;

/// What is nearer than this, in spacings, to a thicker place is its edge.
const EDGE: f64 = 2.5;

/// Sum of the normals of two faces that are no longer opposite: 60 degrees between them.
const ASKEW: f64 = 1.0;

/// Where faces bend, their planes meet beyond the edge by less than this part of the way to it.
const BEYOND_EDGE: f64 = 0.5;

/// And by these spacings more: right at an edge thickness is known too roughly to tell the way to it.
const AT_THE_EDGE: f64 = 0.02;

/// Least volume of a ghost, of a full one's.
const LEAST_VOLUME: f64 = 1e-3;
