//! Sharp convex edges of bodies in space, in pieces, and what lies around each piece.
//!
//! Where an edge is and how the walls beside it lie, the bodies themselves tell: cells are too coarse for either.

use std::collections::HashMap;

use aero_geometry::parallel::prelude::*;
use aero_geometry::{Bounds, Pencils, Ridge, Vector};

use super::bend::Surroundings;
use super::beside::{Beside, Piece};
use super::cells::Cells;
use super::fan::farthest;
use super::net::{Block, Net};
use crate::problem::Problem;

/// Turn from which on an edge is sharp, radians: about a degree.
const SHARP: f64 = 0.02;

/// Turn from which on no gas follows it, radians: 60 degrees.
const BLUNT: f64 = std::f64::consts::FRAC_PI_3;

/// Cosine between pieces of edges above which one goes on as the other: 30 degrees.
const ONWARDS: f64 = 0.866;

/// The pieces of all edges.
#[derive(Clone, Debug)]
pub struct Ridges<const D: usize> {
    pieces: Vec<Piece<D>>,
}

impl<const D: usize> Ridges<D> {
    /// Those of the bodies of `problem` among `cells`; none where there are none.
    pub fn of(net: &Net<D>, cells: &Cells<D>, problem: &Problem<D>) -> Option<Self> {
        let bounds = &problem.domain.bounds;
        let all = |size: f64| -> Vec<(u32, Ridge<D>)> {
            let bodies = (0_u32..).zip(&problem.bodies);
            let each = bodies.flat_map(|(number, body)| {
                let ridges = body.shape.ridges(size, bounds).into_iter();
                ridges.map(move |ridge| (number, ridge))
            });
            each.filter(|(_, ridge)| (SHARP..BLUNT).contains(&ridge.turn()))
                .collect()
        };
        if all(problem.resolution.lattice()).is_empty() {
            return None;
        }
        let beside = Beside::new(net, cells)?;
        let ridges = all(beside.finest());
        let pieces = ridges.iter().flat_map(|(owner, ridge)| {
            let inside = clipped(ridge.ends, bounds);
            let found = inside.map(|ends| beside.pieces(*owner, &Ridge { ends, ..*ridge }));
            let mut found = found.unwrap_or_default();
            for piece in &mut found {
                let is_inner = |end: &Vector<D>| end == &ridge.ends[0] || end == &ridge.ends[1];
                let is_cut = |end| inside.is_some_and(|ends| ends.contains(end)) && !is_inner(end);
                piece.goes_on = [0, 1].map(|k| is_cut(&piece.ends[k]));
            }
            found
        });
        let mut ridges = Self {
            pieces: pieces.collect(),
        };
        ridges.join();
        (!ridges.pieces.is_empty()).then_some(ridges)
    }

    /// Finds out where one piece goes on as another.
    fn join(&mut self) {
        let bits = |place: &Vector<D>| place.map(|part| (part + 0.0).to_bits());
        let mut at: HashMap<_, Vec<(usize, Vector<D>)>> = HashMap::new();
        let out = |piece: &Piece<D>, k: usize| (piece.ends[k] - piece.ends[1 - k]).normalize();
        for (number, piece) in self.pieces.iter().enumerate() {
            for k in 0..2 {
                let here = at.entry(bits(&piece.ends[k])).or_default();
                here.push((number, out(piece, k)));
            }
        }
        for (number, piece) in self.pieces.iter_mut().enumerate() {
            for k in 0..2 {
                let own = out(piece, k);
                let others = &at[&bits(&piece.ends[k])];
                let follows =
                    |(other, way): &(usize, Vector<D>)| *other != number && own.dot(way) < -ONWARDS;
                piece.goes_on[k] |= others.iter().any(follows);
            }
        }
    }

    /// What lies around each piece, of each block.
    pub fn around(&self, net: &Net<D>, cells: &Cells<D>) -> Vec<Vec<Surroundings<D>>> {
        let middle = |piece: &Piece<D>| Vector::from(piece.bends[0].at);
        let middles: Vec<Vector<D>> = self.pieces.iter().map(middle).collect();
        let most = |value: fn(&Piece<D>) -> f64| self.pieces.iter().map(value).fold(0.0, f64::max);
        let reach = most(|piece| farthest::<D>() * piece.bends[0].unit)
            + most(|piece| (piece.ends[1] - piece.ends[0]).norm());
        let by_place = Pencils::new(&middles, reach);
        let blocks = net.blocks.par_iter();
        blocks
            .map(|block| {
                let near = near(block, cells, &by_place, reach);
                if near.is_empty() {
                    Vec::new()
                } else {
                    self.around_block(net, block, cells, &near)
                }
            })
            .collect()
    }

    fn around_block(
        &self,
        net: &Net<D>,
        block: &Block<D>,
        cells: &Cells<D>,
        near: &[usize],
    ) -> Vec<Surroundings<D>> {
        let nearest = |place: &Vector<D>| {
            let mut best = (f64::INFINITY, None);
            for (k, &number) in near.iter().enumerate() {
                let (away, is_seen) = self.pieces[number].sees(place);
                if away < best.0 {
                    best = (away, is_seen.then_some(k));
                }
            }
            best.1
        };
        let mut found: Vec<Surroundings<D>> = near
            .iter()
            .map(|&number| Surroundings {
                bends: self.pieces[number].bends.clone(),
                faces: Vec::new(),
                walls: Vec::new(),
            })
            .collect();
        for (number, face) in (0_u32..).zip(&block.faces) {
            let middle = net.seen(&cells.points, &Vector::zeros(), face);
            let shape = &net.face_shapes[face.shape as usize];
            let crosses = |k: &usize| !self.pieces[near[*k]].bends[0].faces_along(shape);
            if let Some(k) = middle.and_then(|middle| nearest(&middle)).filter(crosses) {
                found[k].faces.push(number);
            }
        }
        for (number, wall) in (0_u32..).zip(&block.walls) {
            if let Some(k) = nearest(&wall.foot) {
                found[k].walls.push(number);
            }
        }
        found.retain(|around| !around.faces.is_empty() || !around.walls.is_empty());
        found
    }
}

/// The places, by number and in order, that some of a block may be within `reach` of.
fn near<const D: usize>(
    block: &Block<D>,
    cells: &Cells<D>,
    by_place: &Pencils<D>,
    reach: f64,
) -> Vec<usize> {
    let points = &cells.points[block.cells.clone()];
    let ends = (points[0], points[0]);
    let (low, high) = points
        .iter()
        .fold(ends, |(low, high), point| (low.inf(point), high.sup(point)));
    let mut near = Vec::new();
    by_place.for_each_run_near(&low, &high, reach, |run| {
        near.extend(by_place.order()[run].iter().map(|&number| number as usize));
    });
    near.sort_unstable();
    near
}

/// What of a line lies in a box [Liang & Barsky 1984, doi:10.1145/357332.357333].
fn clipped<const D: usize>(
    [from, to]: [Vector<D>; 2],
    bounds: &Bounds<D>,
) -> Option<[Vector<D>; 2]> {
    let way = to - from;
    let (mut first, mut last) = (0.0_f64, 1.0_f64);
    for k in 0..D {
        let room = [bounds.min[k] - from[k], bounds.max[k] - from[k]];
        if way[k] == 0.0 {
            if room[0] > 0.0 || room[1] < 0.0 {
                return None;
            }
            continue;
        }
        let [a, b] = room.map(|room| room / way[k]);
        (first, last) = (first.max(a.min(b)), last.min(a.max(b)));
    }
    let at = |part: f64, end: Vector<D>, whole: f64| {
        if part == whole {
            end
        } else {
            from + way * part
        }
    };
    (first < last).then(|| [at(first, from, 0.0), at(last, to, 1.0)])
}
