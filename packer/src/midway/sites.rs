//! Where particles of thin parts may stand: below every sample of their surface one place.

use aero_geometry::Vector;
use aero_geometry::parallel::prelude::*;

use super::ball::{chord, climbed};
use crate::level::project;
use crate::nearest::Nearest;
use crate::plan::Plan;
use crate::plan::to_rows::Bit;
use crate::room_inside::layers_with_room;
use crate::surface::Sample;

/// Thickness, in spacings, from which two rows fit better than one.
const TWO_ROWS: f64 = 1.5;

/// Less than this, in spacings, between two layers is no room for a row.
const NO_ROW: f64 = 0.3;

/// A place this near to a mirror plane, in spacings, is put on it.
const ON_PLANE: f64 = 0.05;

/// How far a piece of a thin part looks for its site, in spacings.
const REACH: f64 = 2.0;

/// So far from the middle of the ball that touches a rim, in spacings, its faces are nearer than the rim.
const INWARDS: f64 = 0.1;

/// What would stand outside next to a sharp edge stands so deep inside, in spacings.
const INSIDE: f64 = 0.05;

/// Sine of the angle between a rim and its faces above which these are told apart.
const SQUARE: f64 = 0.8;

/// A place for a particle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Site<const D: usize> {
    /// In the middle of the part, or of its half.
    pub place: Vector<D>,
    /// Normal of the face that it belongs to; of either where there is one row.
    pub normal: Vector<D>,
    /// Thickness of its row.
    pub thickness: f64,
    /// Thickness of the whole part.
    pub whole: f64,
    /// True where another row lies on the other side.
    pub is_paired: bool,
    /// Layer that it counts in.
    pub layer: u32,
    /// Area of the surface for which it stands.
    pub area: f64,
    /// Number of particles for which it stands.
    pub count: f64,
}

impl<const D: usize> Site<D> {
    /// True where the two cannot be of one row: they belong to opposite faces.
    pub fn is_across(&self, other: &Self) -> bool {
        self.is_paired && other.is_paired && self.normal.dot(&other.normal) < -0.5
    }
}

/// The sites below those samples of the surface where the part is thin.
pub(super) fn sites<const D: usize>(
    plan: &Plan<'_, D>,
    samples: &[Sample<D>],
    bits: &[Bit<D>],
) -> Vec<Site<D>> {
    let spacing = plan.options.spacing;
    let mut found: Vec<Site<D>> = samples
        .par_iter()
        .filter_map(|sample| site(plan, sample))
        .collect();
    let places: Vec<Vector<D>> = found.iter().map(|site| site.place).collect();
    let nearest = Nearest::new(&plan.mirrors, &places, REACH * spacing);
    let owners: Vec<Option<u32>> = bits
        .par_iter()
        .map(|(place, _)| {
            let owner = nearest.find(place, REACH * spacing, |_| true);
            owner.map(|(n, _)| n)
        })
        .collect();
    for ((_, volume), owner) in bits.iter().zip(owners) {
        if let Some(n) = owner {
            let site = &mut found[n as usize];
            site.count += volume / (site.thickness * spacing.powi(D as i32 - 1));
        }
    }
    found
}

/// The site below a sample; none where the layers fit or fill the part.
fn site<const D: usize>(plan: &Plan<'_, D>, sample: &Sample<D>) -> Option<Site<D>> {
    let spacing = plan.options.spacing;
    let seen = (&sample.point, &sample.normal);
    if !plan.may_have_rows_below(&sample.point, &sample.normal) {
        return None;
    }
    let full = layers_with_room(plan.shape, seen, plan.layers, spacing);
    if full == plan.layers || !Plan::<D>::has_rows_below(full) {
        return None;
    }
    let filled = full as f64 * spacing;
    let widest = 2.0 * (filled + spacing);
    let chord = chord(plan.shape, seen, widest, spacing);
    let (whole, faces, rim) = if let Some(chord) = chord {
        (chord, 1.0, None)
    } else {
        // On the rim of a plate, which has no area of its own.
        let (middle, radius) = climbed(plan.shape, &sample.point, (spacing, 0.5 * widest));
        (2.0 * radius, 0.0, Some(middle))
    };
    let left = whole - 2.0 * filled;
    if full > 0 && left < NO_ROW * spacing {
        return None;
    }
    let is_paired = left >= TWO_ROWS * spacing;
    let depth = filled + left * if is_paired { 0.25 } else { 0.5 };
    let below = sample.point - depth * sample.normal;
    let (place, normal) = match rim {
        // A single row ends in the middle of the rim, whatever height the sample has on it, and two rows a quarter off that.
        Some(middle) if !is_paired => (middle, sample.normal),
        Some(middle) => beside_rim(plan, (&middle, &below, sample), 0.25 * left),
        None => (below, sample.normal),
    };
    let place = plan.mirrors.snapped(place, ON_PLANE * spacing);
    // Right at a sharp edge the ball that fits is as good as none, and its middle may be outside.
    let place = if plan.shape.signed_distance(&place) < 0.0 {
        place
    } else {
        project(plan.shape, &place, -INSIDE * spacing, plan.tolerance)?
    };
    Some(Site {
        place,
        normal,
        thickness: if is_paired { 0.5 * left } else { left },
        whole,
        is_paired,
        layer: full as u32,
        area: faces * sample.area,
        count: 0.0,
    })
}

/// A place `below` a sample on the rim of a plate with two rows, brought to that of the nearer face, `off` the `middle` of the thickness; and the normal of that
/// face. A rim that is too round to have faces beside it leaves the place as it is.
fn beside_rim<const D: usize>(
    plan: &Plan<'_, D>,
    (middle, below, sample): (&Vector<D>, &Vector<D>, &Sample<D>),
    off: f64,
) -> (Vector<D>, Vector<D>) {
    // Farther in than the middle of the ball that touches the rim, faces alone are near.
    let inside = middle - INWARDS * plan.options.spacing * sample.normal;
    let face = plan.shape.closest(&inside).normal;
    let across = face - face.dot(&sample.normal) * sample.normal;
    let height = (sample.point - middle).dot(&face);
    if across.norm() < SQUARE || plan.shape.signed_distance(&inside) >= 0.0 {
        return (*below, sample.normal);
    }
    let face = if height < 0.0 { -face } else { face };
    let flat = below - (below - middle).dot(&face) * face;
    (flat + off * face, face)
}
