//! The surfaces as they are: segments in the plane, triangles in space, about as long as the spacing, each with the pressure that
//! the gas presses it with. What makes the pressure is in `press` for particles and in [`crate::fixed`] for points that stay.

mod bend;
pub(crate) mod cut;
mod exposed;
pub(crate) mod fit;
mod integral;
mod left;
mod loads;
mod press;
mod pressed;
mod seen;
mod show;

pub use integral::shown_forces;
pub use pressed::Pressed;
pub use show::Heated;

use aero_geometry::{Bounds, Vector};

use crate::layers::BUFFER;
use crate::problem::{Domain, Problem, Side};
use crate::walls::plane::wall_sides;
use crate::walls::rigid::pad;
use cut::{clipped, halved};

/// No panel is longer than this, in spacings of the flow where it is finest.
const LONGEST: f64 = 1.0;

/// Less of a surface than this part of a panel that is as long as the spacing is what rounding leaves of it where a side cuts it off: nothing
/// that could be seen, and at a nose in a plane of symmetry a place where pressures are drawn out to.
const SLIVER: f64 = 1e-9;

/// What lies deeper than this, in spacings, in a body is no surface; chords of arcs lie less deep.
const BURIED: f64 = 0.25;

/// A piece of a surface at time zero.
#[derive(Clone, Copy, Debug)]
pub struct Panel<const D: usize> {
    /// Its ends or corners; one point on a line.
    pub corners: [Vector<D>; D],
    /// Middle.
    pub centre: Vector<D>,
    /// Unit normal into the gas.
    pub normal: Vector<D>,
    /// Area; length in the plane, one on a line.
    pub size: f64,
    /// Number of the body, wall sides after.
    pub owner: u32,
    /// Another solid stands on it, so that no gas is in front.
    pub is_covered: bool,
}

/// The panels of all bodies and wall sides, also of what lies in the buffers of open sides.
#[derive(Clone, Debug)]
pub struct Panels<const D: usize> {
    all: Vec<Panel<D>>,
}

impl<const D: usize> Panels<D> {
    /// Those of `problem`, cut where the sides of its domain are.
    pub fn new(problem: &Problem<D>) -> Self {
        let region = region(problem);
        let mut all = Vec::new();
        for (number, body) in problem.bodies.iter().enumerate() {
            let longest = longest_of(problem, &body.shape.bounds());
            let facets = body.shape.facets(longest, &region);
            for facet in &facets {
                // What moves crosses the sides as it likes.
                let region = (!body.motion.is_moving()).then_some(&region);
                lay(problem, region, &[], longest, facet, &mut |corners| {
                    all.extend(Panel::new(corners, None, number as u32));
                });
            }
        }
        for (number, (axis, end)) in wall_sides(&problem.domain).into_iter().enumerate() {
            let mut normal = Vector::zeros();
            normal[axis] = if end == 0 { 1.0 } else { -1.0 };
            let owner = (problem.bodies.len() + number) as u32;
            let domain = &problem.domain;
            let cuts = rims(domain, axis, end);
            for facet in face(&region, axis, problem.domain.face(axis, end)) {
                lay(
                    problem,
                    Some(&region),
                    &cuts,
                    longest(problem),
                    &facet,
                    &mut |corners| {
                        let panel = Panel::new(corners, Some(normal), owner);
                        let is_wall =
                            |panel: &Panel<D>| domain.part_at(axis, end, &panel.centre).is_none();
                        all.extend(panel.filter(is_wall));
                    },
                );
            }
        }
        let mut all = exposed::part(problem, all);
        let bodies = &problem.bodies;
        let sliver = SLIVER * problem.resolution.finest().powi(D as i32 - 1);
        all.retain(|panel: &Panel<D>| {
            panel.size > sliver
                && bodies.iter().all(|body| {
                    let reach = body
                        .shape
                        .bounds()
                        .grown(problem.resolution.at(&panel.centre));
                    !reach.contains(&panel.centre)
                        || body.shape.signed_distance(&panel.centre)
                            > -BURIED * problem.resolution.at(&panel.centre)
                })
        });
        Self { all }
    }

    /// All of them.
    pub fn all(&self) -> &[Panel<D>] {
        &self.all
    }
}

impl<const D: usize> Panel<D> {
    /// None of a piece without extent. A `normal` that is given tells which way `corners` have to run.
    fn new(mut corners: [Vector<D>; D], normal: Option<Vector<D>>, owner: u32) -> Option<Self> {
        let area: Vector<D> = match D {
            1 => normal?,
            2 => {
                let along = corners[1] - corners[0];
                Vector::from_fn(|k, _| if k == 0 { along[1] } else { -along[0] })
            }
            _ => {
                let [u, v] = [1, 2].map(|n| pad(&(corners[n] - corners[0])));
                let area = u.cross(&v) * 0.5;
                Vector::from_fn(|k, _| area[k])
            }
        };
        let size = area.norm();
        let mut own = area.try_normalize(f64::MIN_POSITIVE)?;
        if normal.is_some_and(|normal| normal.dot(&own) < 0.0) {
            own = -own;
            corners.swap(0, 1);
        }
        let sum: Vector<D> = corners.iter().sum();
        Some(Self {
            corners,
            centre: sum / D as f64,
            normal: own,
            size,
            owner,
            is_covered: false,
        })
    }
}

/// Length of the longest panel. In the plane they are as fine as cells are where the spacing is halved most; in space, where most cells are
/// not, that would be too many.
fn longest<const D: usize>(problem: &Problem<D>) -> f64 {
    let points = problem.method.fixed().filter(|_| D == 2);
    let halvings = points.map_or(0, |points| points.refine.levels());
    LONGEST * problem.resolution.finest() / f64::from(1_u32 << halvings)
}

/// The same of a body that spans `bounds`. Beside one in space that is hardly larger than the lattice's spacing, as in the box of a slow stream, it is
/// that of the points which the flow may ask for, or a hundredth of the body: a wing's own triangles may be as long as its span.
fn longest_of<const D: usize>(problem: &Problem<D>, bounds: &Bounds<D>) -> f64 {
    const COARSE: f64 = 1.0 / 12.0;
    const FINEST: f64 = 1.0 / 100.0;
    let longest = longest(problem);
    let size = bounds.size().max();
    match problem.method.fixed() {
        Some(points) if D == 3 && longest > COARSE * size => {
            let halved = longest / f64::from(1_u32 << points.refine.of_flow());
            halved.max(FINEST * size).min(longest)
        }
        _ => longest,
    }
}

/// Where panels are laid: the domain, and the buffers of sides that gas or bodies pass through.
fn region<const D: usize>(problem: &Problem<D>) -> Bounds<D> {
    let domain = &problem.domain;
    let margin = |axis: usize, end: usize| {
        if domain.opens(axis, end) || domain.sides[axis][end] == Side::Body {
            BUFFER as f64 * problem.resolution.lattice()
        } else {
            0.0
        }
    };
    let mut region = domain.bounds;
    for axis in 0..D {
        region.min[axis] -= margin(axis, 0);
        region.max[axis] += margin(axis, 1);
    }
    region
}

/// Axes and places of the rims of the parts of a side.
fn rims<const D: usize>(domain: &Domain<D>, axis: usize, end: usize) -> Vec<(usize, f64)> {
    let parts = domain.parts(axis, end).filter_map(|part| part.part);
    let rims = parts.flat_map(|part| {
        let others = (0..D).filter(move |&k| k != axis);
        others.flat_map(move |k| [(k, part.min[k]), (k, part.max[k])])
    });
    rims.collect()
}

/// Hands `facet` out in pieces that are no longer than they may be; of one that does not move, what `region` holds, cut where the
/// sides of the domain are, and at `cuts`.
fn lay<const D: usize>(
    problem: &Problem<D>,
    region: Option<&Bounds<D>>,
    cuts: &[(usize, f64)],
    longest: f64,
    facet: &[Vector<D>; D],
    take: &mut impl FnMut([Vector<D>; D]),
) {
    let mut pieces = vec![*facet];
    if let Some(region) = region {
        let low = facet.iter().fold(facet[0], |low, p| low.inf(p));
        let high = facet.iter().fold(facet[0], |high, p| high.sup(p));
        if Bounds::new(low, high).intersection(region).is_empty() {
            return;
        }
        for axis in 0..D {
            for (plane, sign) in [(region.min[axis], -1.0), (region.max[axis], 1.0)] {
                pieces = clipped(&pieces, axis, plane, sign);
            }
            for end in [0, 1] {
                let plane = problem.domain.face(axis, end);
                if low[axis] < plane && plane < high[axis] {
                    let mut parts = clipped(&pieces, axis, plane, 1.0);
                    parts.extend(clipped(&pieces, axis, plane, -1.0));
                    pieces = parts;
                }
            }
        }
    }
    for &(axis, plane) in cuts {
        let mut parts = clipped(&pieces, axis, plane, 1.0);
        parts.extend(clipped(&pieces, axis, plane, -1.0));
        pieces = parts;
    }
    halved(pieces, longest, take);
}

/// The face of a box across an axis, at another place along it: a point, a segment, or two triangles.
fn face<const D: usize>(region: &Bounds<D>, axis: usize, at: f64) -> Vec<[Vector<D>; D]> {
    let corner = |high: [bool; D]| {
        Vector::<D>::from_fn(|k, _| match high[k] {
            _ if k == axis => at,
            true => region.max[k],
            false => region.min[k],
        })
    };
    let others: Vec<usize> = (0..D).filter(|&k| k != axis).collect();
    let with = |set: &[usize]| corner(std::array::from_fn(|k| set.contains(&k)));
    let corners = match others[..] {
        [] => vec![vec![with(&[])]],
        [u] => vec![vec![with(&[]), with(&[u])]],
        [u, v, ..] => vec![
            vec![with(&[]), with(&[u]), with(&[u, v])],
            vec![with(&[]), with(&[u, v]), with(&[v])],
        ],
    };
    let pieces = corners.into_iter();
    pieces
        .map(|piece| std::array::from_fn(|n| piece[n]))
        .collect()
}

/// How many bodies and wall sides there are.
fn owner_count<const D: usize>(problem: &Problem<D>) -> usize {
    problem.bodies.len() + wall_sides(&problem.domain).len()
}

/// True of a place that belongs to the domain.
fn is_shown<const D: usize>(domain: &Domain<D>, centre: &Vector<D>) -> bool {
    domain.bounds.contains(centre)
}

impl<const D: usize> Panel<D> {
    /// The point of the panel nearest to `point`.
    pub fn closest(&self, point: &Vector<D>) -> Vector<D> {
        match D {
            1 => self.corners[0],
            2 => on_segment([&self.corners[0], &self.corners[1]], point),
            _ => {
                let above = self.normal.dot(&(point - self.corners[0]));
                let foot = point - self.normal * above;
                let edges = (0..D).map(|n| [&self.corners[n], &self.corners[(n + 1) % D]]);
                let is_inside = edges.clone().all(|[a, b]| {
                    let out = pad(&(b - a)).cross(&pad(&self.normal));
                    pad(&(foot - a)).dot(&out) <= 0.0
                });
                if is_inside {
                    return foot;
                }
                let apart = |p: &Vector<D>| (p - point).norm_squared();
                edges
                    .map(|edge| on_segment(edge, point))
                    .min_by(|a, b| apart(a).total_cmp(&apart(b)))
                    .unwrap_or(self.centre)
            }
        }
    }
}

/// The point between two ends nearest to `point`.
fn on_segment<const D: usize>([a, b]: [&Vector<D>; 2], point: &Vector<D>) -> Vector<D> {
    let along = b - a;
    let part = (point - a).dot(&along) / along.norm_squared();
    a + along * part.clamp(0.0, 1.0)
}
