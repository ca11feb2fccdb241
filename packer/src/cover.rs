//! How well the ghosts cover the true surface.

use aero_geometry::Vector;

use crate::cloud::{Cloud, Lock};
use crate::level::project;
use crate::nearest::Nearest;
use crate::plan::Plan;
use crate::sheets::Touched;
use crate::sources::Sources;
use crate::surface::Sample;

/// Surface farther than this, in spacings, from every ghost is not covered: gas may enter the body there.
pub(crate) const COVERED: f64 = 1.25;

/// Farther than this, in spacings, a place gets a ghost of its own: samples stand a third of a spacing apart.
const MENDED: f64 = 1.22;

/// Rounds of mending.
const MENDINGS: usize = 6;

/// A ghost that is added has no other nearer than this, in spacings.
const ROOM: f64 = 0.6;

/// And one nearer than this, whose volume it shares.
const LENDS: f64 = 4.0;

/// Depth of a ghost that is added at an edge, in spacings.
const AT_EDGES: f64 = 0.25;

/// A place this near to a mirror plane, in spacings, is put on it.
const ON_PLANE: f64 = 0.3;

/// What of the surface inside the region is covered.
#[derive(Clone, Debug, Default)]
pub(crate) struct Cover {
    /// Area of the surface, images included.
    pub area: f64,
    /// Part of it that is farther than [`COVERED`] from every ghost, per cent.
    pub uncovered_percent: f64,
    /// Largest distance from a sample to a ghost, in spacings.
    pub hole: f64,
    /// Where that is.
    pub hole_at: Vec<f64>,
}

/// Measures the distance from each sample to the nearest ghost; `ghosts` are those above the mirror planes.
pub(crate) fn cover<const D: usize>(
    plan: &Plan<'_, D>,
    samples: &[Sample<D>],
    ghosts: &[Vector<D>],
) -> Option<Cover> {
    let kept: Vec<(&Sample<D>, f64)> = samples
        .iter()
        .map(|sample| (sample, sample.area * copies(plan, &sample.point)))
        .filter(|&(_, area)| area > 0.0)
        .collect();
    let places: Vec<Vector<D>> = kept.iter().map(|(sample, _)| sample.point).collect();
    let gaps = gaps(plan, &places, ghosts);
    let limit = COVERED * plan.options.spacing;
    let area: f64 = kept.iter().map(|&(_, area)| area).sum();
    let far = kept.iter().zip(&gaps).filter(|&(_, &gap)| gap > limit);
    let uncovered: f64 = far.map(|((_, area), _)| area).sum();
    let worst = (0..gaps.len()).max_by(|&a, &b| gaps[a].total_cmp(&gaps[b]).then(b.cmp(&a)))?;
    Some(Cover {
        area,
        // The sum of no areas is a negative zero.
        uncovered_percent: 100.0 * (uncovered + 0.0) / area,
        hole: gaps[worst] / plan.options.spacing,
        hole_at: places[worst].iter().copied().collect(),
    })
}

/// How many times a place of the packed part of space occurs inside the region.
fn copies<const D: usize>(plan: &Plan<'_, D>, point: &Vector<D>) -> f64 {
    let mut count = usize::from(plan.keeps(point));
    plan.mirrors
        .images(point, |_, image| count += usize::from(plan.keeps(&image)));
    count as f64
}

/// Distance from each place to the nearest of `ghosts` or their images, however far.
fn gaps<const D: usize>(
    plan: &Plan<'_, D>,
    places: &[Vector<D>],
    ghosts: &[Vector<D>],
) -> Vec<f64> {
    let mut gaps = vec![f64::INFINITY; places.len()];
    let mut open: Vec<usize> = (0..places.len()).collect();
    let size = plan.bounds.size().norm();
    let mut reach = 2.0 * plan.options.spacing;
    while !open.is_empty() {
        let all = ghosts.iter().map(|&place| (place, 0.0));
        let sources = Sources::new(&plan.mirrors, all, reach);
        let asked: Vec<Vector<D>> = open.iter().map(|&n| places[n]).collect();
        for (&n, gap) in open.iter().zip(sources.nearest(&asked, reach, false)) {
            gaps[n] = gap;
        }
        open.retain(|&n| gaps[n] >= reach);
        if reach > 2.0 * size {
            break;
        }
        reach *= 2.0;
    }
    gaps
}

/// Puts ghosts below places of the surface that none covers; a new one shares the volume of the nearest, images of both included, so that
/// one on the axis of a body does not take a half from each of four. Gives their number.
pub(crate) fn mend<const D: usize>(
    plan: &Plan<'_, D>,
    cloud: &mut Cloud<D>,
    samples: &[Sample<D>],
) -> usize {
    let spacing = plan.options.spacing;
    let before = cloud.len();
    for _ in 0..MENDINGS {
        let places: Vec<Vector<D>> = samples.iter().map(|sample| sample.point).collect();
        let gaps = gaps(plan, &places, &cloud.position);
        let mut open: Vec<usize> = (0..samples.len())
            .filter(|&n| gaps[n] > MENDED * spacing)
            .collect();
        open.sort_by(|&a, &b| gaps[b].total_cmp(&gaps[a]).then(a.cmp(&b)));
        let nearest = Nearest::new(&plan.mirrors, &cloud.position, LENDS * spacing);
        let mut touched = Touched::new(2.0 * spacing);
        let mut added = false;
        for sample in open.into_iter().map(|n| &samples[n]) {
            let Some(place) = place_below(plan, sample) else {
                continue;
            };
            let Some((lender, gap)) = nearest.find(&place, LENDS * spacing, |_| true) else {
                continue;
            };
            if gap < ROOM * spacing || !touched.claim(&place) {
                continue;
            }
            let lender = lender as usize;
            let volume = cloud.volume[lender] * part_kept(plan, &cloud.position[lender], &place);
            cloud.volume[lender] = volume;
            cloud.push(place, 0, Lock::Row, volume);
            added = true;
        }
        if !added {
            break;
        }
    }
    cloud.len() - before
}

/// The part of its volume that a ghost keeps when it shares that with one at `place`: all of them, images included, then have the same.
fn part_kept<const D: usize>(plan: &Plan<'_, D>, own: &Vector<D>, place: &Vector<D>) -> f64 {
    let [own, new] = [own, place].map(|point| plan.mirrors.share(point));
    own / (own + new)
}

/// A place inside of the body below a sample, half a spacing deep or in the middle of what is thinner; at an edge, where the way down leads
/// out of the body, beside that way.
fn place_below<const D: usize>(plan: &Plan<'_, D>, sample: &Sample<D>) -> Option<Vector<D>> {
    let spacing = plan.options.spacing;
    let below = sample.point - depth_below(plan, sample) * sample.normal;
    let inside = if plan.shape.signed_distance(&below) < 0.0 {
        below
    } else {
        project(plan.shape, &below, -AT_EDGES * spacing, plan.tolerance)?
    };
    let place = plan.mirrors.snapped(inside, ON_PLANE * spacing);
    let is_inside = plan.shape.signed_distance(&place) < 0.0 && plan.mirrors.above(&place);
    is_inside.then_some(place)
}

/// Depth of the wall layer below a sample: half a spacing, or half of a thinner body.
fn depth_below<const D: usize>(plan: &Plan<'_, D>, sample: &Sample<D>) -> f64 {
    let half = 0.5 * plan.options.spacing;
    let deep = |depth: f64| {
        -plan
            .shape
            .signed_distance(&(sample.point - depth * sample.normal))
    };
    // Where the body is thinner, depth falls again beyond its middle.
    (1..=8)
        .map(|n| half * f64::from(n) / 8.0)
        .max_by(|&a, &b| deep(a).total_cmp(&deep(b)))
        .unwrap_or(half)
}
