//! Sharp edges of bodies in space, in pieces, and what lies around each piece at which a fan may stand.
//!
//! Where an edge is and how the walls beside it lie, the bodies themselves tell: cells are too coarse for either.

use std::collections::HashMap;

use aero_geometry::parallel::prelude::*;
use aero_geometry::{Bounds, Crease, Pencils, Vector};

use super::bend::{Bend, Surroundings};
use super::beside::{Beside, PARTING};
use super::cells::Cells;
use super::edge::{Edge, Kind, Piece};
use super::fan::farthest;
use super::net::{Block, Net};
use super::seams::{MIRROR, seams};
use crate::problem::Problem;

/// Turn from which on an edge is sharp, radians: about a degree.
const SHARP: f64 = 0.02;

/// Turn from which on no gas follows a convex one, radians: 60 degrees.
const BLUNT: f64 = std::f64::consts::FRAC_PI_3;

/// Cosine between pieces of edges above which one goes on as the other: 30 degrees.
const ONWARDS: f64 = 0.866;

/// The pieces of all edges.
#[derive(Clone, Debug)]
pub struct Ridges<const D: usize> {
    /// In the order of the bodies' creases.
    pub pieces: Vec<Piece<D>>,
}

impl<const D: usize> Ridges<D> {
    /// Those of the bodies of `problem` among `cells`, and of where these meet the planes that close the domain; none where there are none.
    pub fn of(net: &Net<D>, cells: &Cells<D>, problem: &Problem<D>) -> Option<Self> {
        let bounds = &problem.domain.bounds;
        let all = |size: f64| -> Vec<Edge<D>> {
            let bodies = (0_u32..).zip(&problem.bodies);
            let each = bodies.flat_map(|(number, body)| {
                let creases = body.shape.creases(size, bounds).into_iter();
                creases.map(move |crease| Edge {
                    owners: [number; 2],
                    crease,
                })
            });
            let all = each.chain(seams(problem, size));
            all.filter(|edge| is_met(&edge.crease)).collect()
        };
        let roughly = all(problem.resolution.lattice());
        if roughly.is_empty() {
            return None;
        }
        let mirrors = if roughly.iter().any(|edge| edge.owners.contains(&MIRROR)) {
            net.mirrors(cells)
        } else {
            Vec::new()
        };
        let beside = Beside::new(net, cells, &mirrors)?;
        let edges = all(beside.finest());
        let stream = &problem.free_stream.velocity;
        let pieces = edges.iter().flat_map(|edge| {
            let crease = &edge.crease;
            let inside = clipped(crease.ends, bounds);
            let found = inside.map(|ends| beside.pieces(&edge.part(ends), stream));
            let mut found = found.unwrap_or_default();
            for piece in &mut found {
                let is_inner = |end: &Vector<D>| end == &crease.ends[0] || end == &crease.ends[1];
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

    /// Finds out where one piece goes on as another, and what edges they make.
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
        let mut pairs = Vec::new();
        for (number, piece) in self.pieces.iter_mut().enumerate() {
            for k in 0..2 {
                let own = out(piece, k);
                let others = at[&bits(&piece.ends[k])].iter();
                let follows = |(other, way): &&(usize, Vector<D>)| {
                    *other != number && own.dot(way) < -ONWARDS
                };
                let mut others = others.filter(follows).map(|(other, _)| *other).peekable();
                piece.goes_on[k] |= others.peek().is_some();
                pairs.extend(others.map(|other| [number, other]));
            }
        }
        let mut edges = Joints::new(self.pieces.len());
        for [one, other] in pairs {
            edges.join(one, other);
        }
        for (number, piece) in self.pieces.iter_mut().enumerate() {
            piece.edge = edges.first(number);
        }
    }

    /// What lies around each piece at which a fan may stand, of each block.
    pub fn around(&self, net: &Net<D>, cells: &Cells<D>) -> Vec<Vec<Surroundings<D>>> {
        let places = self.places(farthest::<D>(), |piece| piece.kind != Kind::Hollow);
        let blocks = net.blocks.par_iter();
        blocks
            .map(|block| {
                let near = places.near(block, cells);
                if near.is_empty() {
                    Vec::new()
                } else {
                    self.around_block(net, block, cells, &near)
                }
            })
            .collect()
    }

    /// Where the pieces are that are wanted, to be looked for up to so many spacings from each.
    pub fn places(&self, farthest: f64, is_wanted: impl Fn(&Piece<D>) -> bool) -> Places<D> {
        let numbers = (0..self.pieces.len()).filter(|&number| is_wanted(&self.pieces[number]));
        let numbers: Vec<usize> = numbers.collect();
        let wanted = || numbers.iter().map(|&number| &self.pieces[number]);
        let reach = wanted().map(|piece| farthest * piece.walls.unit);
        let long = wanted().map(|piece| (piece.ends[1] - piece.ends[0]).norm());
        let reach = reach.fold(0.0, f64::max) + long.fold(0.0, f64::max);
        let middles: Vec<Vector<D>> = wanted().map(|piece| Vector::from(piece.walls.at)).collect();
        Places {
            by_place: Pencils::new(&middles, reach),
            numbers,
            reach,
        }
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
                let (away, is_seen) = self.pieces[number].sees(place, farthest::<D>());
                if away < best.0 {
                    best = (away, is_seen.then_some(k));
                }
            }
            best.1
        };
        let mut found: Vec<Vec<Surroundings<D>>> = near
            .iter()
            .map(|&number| self.pieces[number].surroundings())
            .collect();
        for (number, face) in (0_u32..).zip(&block.faces) {
            let middle = net.seen(&cells.points, &Vector::zeros(), face);
            let shape = &net.face_shapes[face.shape as usize];
            let crosses = |k: &usize| !self.pieces[near[*k]].walls.faces_along(shape);
            let Some(middle) = middle else {
                continue;
            };
            if let Some(k) = nearest(&middle).filter(crosses) {
                let around = found[k].iter_mut();
                let around = around.filter(|around| around.is_before(&middle));
                around.for_each(|around| around.faces.push(number));
            }
        }
        for (number, wall) in (0_u32..).zip(&block.walls) {
            if let Some(k) = nearest(&wall.foot) {
                let around = found[k].iter_mut();
                let around = around.filter(|around| around.is_before(&wall.foot));
                around.for_each(|around| around.walls.push(number));
            }
        }
        let mut found: Vec<Surroundings<D>> = found.into_iter().flatten().collect();
        found.retain(|around| !around.faces.is_empty() || !around.walls.is_empty());
        found
    }
}

impl<const D: usize> Piece<D> {
    /// Nothing around it yet: once for a ridge, which gas passes from one side or the other, and for each side of a tip.
    fn surroundings(&self) -> Vec<Surroundings<D>> {
        let around = |bends: &[Bend<D>]| Surroundings {
            bends: bends.to_vec(),
            faces: Vec::new(),
            walls: Vec::new(),
        };
        if self.kind == Kind::Tip {
            self.bends.chunks(1).map(around).collect()
        } else {
            vec![around(&self.bends)]
        }
    }
}

impl<const D: usize> Surroundings<D> {
    /// True of a place on one of the sides from which its bends are met.
    fn is_before(&self, place: &Vector<D>) -> bool {
        let mut bends = self.bends.iter();
        bends.any(|bend| bend.opens_to(&(place - Vector::from(bend.at))))
    }
}

/// Where some pieces are.
pub struct Places<const D: usize> {
    numbers: Vec<usize>,
    by_place: Pencils<D>,
    reach: f64,
}

impl<const D: usize> Places<D> {
    /// Numbers of the pieces, in order, that some of a block may be near to.
    pub fn near(&self, block: &Block<D>, cells: &Cells<D>) -> Vec<usize> {
        let (low, high) = bounds(&cells.points[block.cells.clone()]);
        let mut near = Vec::new();
        self.by_place
            .for_each_run_near(&low, &high, self.reach, |run| {
                let found = self.by_place.order()[run].iter();
                near.extend(found.map(|&number| self.numbers[number as usize]));
            });
        near.sort_unstable();
        near
    }
}

/// The box around some points.
pub fn bounds<const D: usize>(points: &[Vector<D>]) -> (Vector<D>, Vector<D>) {
    let ends = (points[0], points[0]);
    points
        .iter()
        .fold(ends, |(low, high), point| (low.inf(point), high.sup(point)))
}

/// Which things have come to be joined, directly or through others.
struct Joints {
    before: Vec<usize>,
}

impl Joints {
    /// So many, none joined to another.
    fn new(count: usize) -> Self {
        Self {
            before: (0..count).collect(),
        }
    }

    /// The first of those that one is joined to.
    fn first(&self, mut one: usize) -> usize {
        while self.before[one] != one {
            one = self.before[one];
        }
        one
    }

    fn join(&mut self, one: usize, other: usize) {
        let [a, b] = [one, other].map(|one| self.first(one));
        self.before[a.max(b)] = a.min(b);
        // So that ways stay short.
        self.before[one] = a.min(b);
        self.before[other] = a.min(b);
    }
}

/// True of an edge that gas in a stream may know of: one that it can follow, one that it is turned at, and one that parts it.
fn is_met<const D: usize>(crease: &Crease<D>) -> bool {
    let turn = crease.turn();
    turn >= SHARP && (!crease.is_convex || !(BLUNT..=PARTING).contains(&turn))
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
