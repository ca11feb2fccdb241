//! The cell of a point: all that is nearer to it than to any other point, within the sides of the domain (Voronoi 1908),
//! cut out of a box by the planes half way to its neighbours, nearest first, until none can reach it any more.

use aero_geometry::Vector;

use super::cloud::Cloud;
use super::nearby::Nearby;
use super::plot::Plot;
use super::polytope::Polytope;
use crate::problem::{Domain, Side};

/// Half of the first box, in spacings.
const BOX: f64 = 6.0;

/// How far, in spacings, a cell is followed into the body below its point's foot: it may come out again behind a thin part.
const DEPTH: f64 = 1.6;

/// Radius of the first search, in spacings.
const SEARCH: f64 = 2.3;

/// Label of the plane that bounds a cell within a body.
pub const IN_BODY: u32 = u32::MAX;

/// Neighbour of a point.
#[derive(Clone, Copy, Debug)]
pub struct Link<const D: usize> {
    /// The neighbour.
    pub to: u32,
    /// Where it, or its periodic image, is from the point.
    pub apart: Vector<D>,
}

/// Finds cells.
#[derive(Clone, Debug)]
pub struct Voronoi<'a, const D: usize> {
    plot: Plot<'a, D>,
    cloud: &'a Cloud<D>,
    nearby: Nearby<'a, D>,
    /// Where the periodic images are, the points themselves first.
    shifts: Vec<Vector<D>>,
}

/// A candidate for a neighbour: distance squared, number, and its image.
type Candidate = (f64, u32, u32);

/// Where the periodic images of a place are from it, the place itself first.
pub fn shifts<const D: usize>(domain: &Domain<D>) -> Vec<Vector<D>> {
    let size = domain.bounds.size();
    let mut shifts = vec![Vector::<D>::zeros()];
    for k in 0..D {
        if domain.sides[k][0] != Side::Periodic {
            continue;
        }
        for known in shifts.clone() {
            for sign in [-1.0, 1.0] {
                let mut shift = known;
                shift[k] = sign * size[k];
                shifts.push(shift);
            }
        }
    }
    shifts
}

impl<'a, const D: usize> Voronoi<'a, D> {
    /// Of the cloud, whose `positions` are listed once more.
    pub fn new(plot: Plot<'a, D>, cloud: &'a Cloud<D>, positions: &'a [Vector<D>]) -> Self {
        Self {
            plot,
            cloud,
            nearby: Nearby::new(positions),
            shifts: shifts(plot.domain),
        }
    }

    /// The cell of a point, measured from it, and its neighbours: facets are labelled by twice the axis plus the end
    /// where they lie on a side, and by the number of the link plus `2 D` otherwise.
    pub fn cell(&self, number: usize) -> (Polytope<D>, Vec<Link<D>>) {
        let place = &self.cloud.places[number];
        let unit = place.spacing;
        let mut cell = self.first_box(number);
        let mut links = Vec::new();
        self.cut_in_body(number, &mut cell);
        let mut found: Vec<Candidate> = Vec::new();
        let (mut done, mut radius) = (0.0, SEARCH * unit);
        loop {
            self.candidates(number, done, radius, &mut found);
            for &(squared, other, image) in &found {
                if squared > 4.0 * cell.reach_squared() * (1.0 + 1e-9) {
                    return (cell, links);
                }
                let apart = self.cloud.places[other as usize].position
                    + self.shifts[image as usize]
                    - place.position;
                let distance = squared.sqrt();
                let label = (2 * D + links.len()) as u32;
                if cell.clip(&(apart / distance), 0.5 * distance, label, unit) {
                    links.push(Link { to: other, apart });
                }
            }
            let needed = 2.0 * cell.reach_squared().sqrt() * (1.0 + 1e-9);
            if needed <= radius {
                return (cell, links);
            }
            done = radius;
            radius = needed.min(1.6 * radius);
        }
    }

    /// Half of the first box or what the sides leave of it.
    fn first_box(&self, number: usize) -> Polytope<D> {
        let place = &self.cloud.places[number];
        let bounds = &self.plot.domain.bounds;
        let half = BOX * place.spacing;
        let (mut low, mut high) = (Vector::repeat(-half), Vector::repeat(half));
        for k in 0..D {
            if self.plot.domain.sides[k][0] != Side::Periodic {
                low[k] = low[k].max(bounds.min[k] - place.position[k]);
                high[k] = high[k].min(bounds.max[k] - place.position[k]);
            }
        }
        Polytope::block(&low, &high)
    }

    fn cut_in_body(&self, number: usize, cell: &mut Polytope<D>) {
        let place = &self.cloud.places[number];
        if place.distance > BOX * place.spacing {
            return;
        }
        if let Some((_, closest)) = self.plot.solids.closest(&place.position) {
            let depth = closest.distance + DEPTH * place.spacing;
            cell.clip(&-closest.normal, depth, IN_BODY, place.spacing);
        }
    }

    /// Points at `done` to `radius` from a point, nearest first.
    fn candidates(&self, number: usize, done: f64, radius: f64, found: &mut Vec<Candidate>) {
        found.clear();
        let position = self.cloud.places[number].position;
        let mut near = Vec::new();
        for (image, shift) in self.shifts.iter().enumerate() {
            near.clear();
            self.nearby.within(&(position - shift), radius, &mut near);
            let itself = |other: u32| image == 0 && other as usize == number;
            let fresh = near
                .iter()
                .filter(|&&(squared, other)| squared > done * done && !itself(other));
            found.extend(fresh.map(|&(squared, other)| (squared, other, image as u32)));
        }
        found.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
    }
}
