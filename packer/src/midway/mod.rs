//! Thin parts in space: particles on the sheet mid-way between two faces.
//!
//! Where a body is thinner than the wall layers of both sides, one row lies in the middle, or two rows a quarter of the
//! thickness below either face where it is thicker than a spacing and a half; what deeper layers leave between them is filled
//! likewise. Particles are one spacing apart along the part whatever its thickness, up to its rims and tips, and each has the volume
//! of what is nearest to it: `V = t dx^2` on a plate of thickness `t`. So a fin is covered however thin it is.

mod ball;
mod seats;
mod sites;
mod spread;

use aero_geometry::Vector;
use rayon::prelude::*;

pub(crate) use ball::chord;

use crate::PackError;
use crate::cloud::{Cloud, Lock};
use crate::nearest::Nearest;
use crate::plan::Plan;
use crate::surface::Sample;
use crate::thinnest::{THINNEST, Thinnest};
use sites::{Site, sites};
use spread::spread;

/// How far, in spacings, a piece of a thin part looks for a particle of its own.
const OWN: f64 = 1.5;

/// And how far for any.
const ANY: f64 = 4.0;

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
    let bits = plan.thin_bits();
    if bits.is_empty() {
        return Ok(None);
    }
    let spacing = plan.options.spacing;
    let found = sites(plan, samples, &bits);
    let thinnest = thinnest(plan, &found)?;
    let seeds = spread(plan, &found, cloud);
    let first = cloud.len();
    for seed in &seeds {
        cloud.push(seed.place, seed.layer, Lock::Row, 0.0);
    }
    let thin = Nearest::new(&plan.mirrors, &cloud.position[first..], OWN * spacing);
    let all = Nearest::new(&plan.mirrors, &cloud.position, ANY * spacing);
    let owners: Vec<Option<usize>> = bits
        .par_iter()
        .map(|(place, _)| {
            let own = thin.find(place, OWN * spacing, |_| true);
            let own = own.map(|(n, _)| first + n as usize);
            own.or_else(|| {
                let any = all.find(place, ANY * spacing, |_| true);
                any.map(|(n, _)| n as usize)
            })
        })
        .collect();
    let mut extra = vec![0.0; cloud.len()];
    for ((_, volume), owner) in bits.iter().zip(owners) {
        if let Some(n) = owner {
            extra[n] += volume;
        }
    }
    for (n, extra) in extra.into_iter().enumerate() {
        cloud.volume[n] += extra / plan.mirrors.share(&cloud.position[n]);
    }
    // One without a volume of its own stands in a sliver that no piece has its centre in.
    let least = LEAST_VOLUME * plan.particle_volume();
    for volume in &mut cloud.volume[first..] {
        *volume = volume.max(least);
    }
    Ok(thinnest)
}

/// Thinnest place that is not the edge of something thicker; refuses a body that is no thicker anywhere.
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
    let is_edge = |site: &Site<D>| nearest.find(&site.place, reach, |_| true).is_some();
    let worst = sites
        .iter()
        .filter(|site| site.whole < limit && !is_edge(site))
        .min_by(|a, b| a.whole.total_cmp(&b.whole));
    let Some(site) = worst else {
        return Ok(None);
    };
    let found = Thinnest {
        thickness: site.whole / spacing,
        at: site.place.iter().copied().collect(),
        spacing,
    };
    if thick.is_empty() && plan.roomy_cells().next().is_none() {
        return Err(PackError::Thin {
            thickness: found.thickness,
            at: found.at,
            spacing,
        });
    }
    Ok(Some(found))
}

/// Thickness is known to this part.
const NEARLY: f64 = 0.99;

/// What is nearer than this, in spacings, to a thicker place is its edge.
const EDGE: f64 = 2.5;

/// Least volume of a ghost, of a full one's.
const LEAST_VOLUME: f64 = 1e-3;
