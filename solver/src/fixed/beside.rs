//! The walls beside a sharp edge in space: how fine cells are there, and where the gas is that comes to it.

use std::cell::OnceCell;

use aero_geometry::{Crease, Pencils, Vector};

use super::bend::Bend;
use super::cells::Cells;
use super::edge::{Edge, Kind, Piece};
use super::net::Net;
use super::polytope::cross;
use super::walls::Wall;

/// No piece of an edge is longer than this, in spacings.
const LONGEST: f64 = 2.0;

/// Distance from an edge, in spacings, at which gas has not met it yet.
const AHEAD: f64 = 1.0;

/// Gas is looked for up to so much farther from there, and from the ends of a piece, in spacings.
const LOOK: f64 = 1.5;

/// Sine of the angle, across the edge, up to which a wall goes on as another: three degrees.
const STRAIGHT: f64 = 0.05;

/// The same along the edge, where it may be round.
const ROUND: f64 = 0.2;

/// Walls that are farther off a plane than this, in spacings, do not lie in it.
const OFF: f64 = 0.5;

/// Least turn of an edge that parts gas, radians: both walls go back from it, which those of a box do not.
pub const PARTING: f64 = 1.6;

/// So far ahead of an edge that parts it, in spacings, gas has not met it yet.
const CLEAR: f64 = 1.5;

/// The walls of all cells.
pub struct Beside<'a, const D: usize> {
    cells: &'a Cells<D>,
    walls: Vec<&'a Wall<D>>,
    /// Spacing of the points there, wall by wall.
    units: Vec<f64>,
    by_foot: Pencils<D>,
    /// Points of all cells, where edges part gas.
    by_point: OnceCell<Pencils<D>>,
    /// Least and largest spacing.
    range: [f64; 2],
}

impl<'a, const D: usize> Beside<'a, D> {
    /// Those of `net`, whose cells are `cells`, and `mirrors`; none where there are none.
    pub fn new(net: &'a Net<D>, cells: &'a Cells<D>, mirrors: &'a [Wall<D>]) -> Option<Self> {
        let walls = net.blocks.iter().flat_map(|block| &block.walls);
        let walls: Vec<&Wall<D>> = walls.chain(mirrors).collect();
        let spacings = cells.spacings();
        let units: Vec<f64> = walls.iter().map(|wall| spacings[wall.i as usize]).collect();
        let range = units.iter().fold([f64::INFINITY, 0.0], |[a, b], unit| {
            [unit.min(a), unit.max(b)]
        });
        // No walls, or none of cells with neighbours.
        if range[1] <= 0.0 {
            return None;
        }
        let feet: Vec<Vector<D>> = walls.iter().map(|wall| wall.foot).collect();
        Some(Self {
            cells,
            by_foot: Pencils::new(&feet, LONGEST * range[0].max(1e-3 * range[1])),
            by_point: OnceCell::new(),
            walls,
            units,
            range,
        })
    }

    /// Least spacing on the walls.
    pub fn finest(&self) -> f64 {
        self.range[0]
    }

    /// Hands out all walls of these owners with their feet within `reach` of a place.
    fn for_each(
        &self,
        owners: [u32; 2],
        place: &Vector<D>,
        reach: f64,
        mut take: impl FnMut(usize, &Wall<D>),
    ) {
        self.by_foot.for_each_run_near(place, place, reach, |run| {
            for &number in &self.by_foot.order()[run] {
                let wall = self.walls[number as usize];
                if owners.contains(&wall.owner) && (wall.foot - place).norm() < reach {
                    take(number as usize, wall);
                }
            }
        });
    }

    /// Spacing of the points at the nearest wall; none where there is none near.
    fn unit(&self, owners: [u32; 2], place: &Vector<D>) -> Option<f64> {
        let mut reach = LONGEST * self.range[0];
        while reach < 2.0 * LONGEST * self.range[1] {
            let mut best: Option<(f64, usize)> = None;
            self.for_each(owners, place, reach, |number, wall| {
                let found = ((wall.foot - place).norm(), number);
                if best.is_none_or(|best| found < best) {
                    best = Some(found);
                }
            });
            if let Some((_, number)) = best {
                return Some(self.units[number]);
            }
            reach *= 2.0;
        }
        None
    }

    /// The pieces of an edge that gas can meet in a `stream`.
    pub fn pieces(&self, edge: &Edge<D>, stream: &Vector<D>) -> Vec<Piece<D>> {
        let Edge { owners, crease } = *edge;
        let mut found = Vec::new();
        let mut left = vec![crease.ends];
        while let Some(ends) = left.pop() {
            let [from, to] = ends;
            let middle = 0.5 * (from + to);
            let unit = self.unit(owners, &middle);
            if (to - from).norm() > LONGEST * unit.unwrap_or(self.range[1]) {
                left.extend([[middle, to], [from, middle]]);
                continue;
            }
            let Some(unit) = unit else {
                continue;
            };
            let piece = edge.part(ends);
            found.extend(if crease.is_convex && crease.turn() > PARTING {
                self.tip(&piece, unit, stream)
            } else {
                self.bent(&piece, unit)
            });
        }
        found
    }

    /// A piece of an edge that gas turns at.
    fn bent(&self, edge: &Edge<D>, unit: f64) -> Option<Piece<D>> {
        let piece = &edge.crease;
        let [a, b] = piece.normals;
        let bend = |normals: [Vector<D>; 2]| {
            let bend = lying(piece, normals, unit);
            let donors = self.donors(edge, &bend);
            let way = turned_back(&bend);
            (!donors.is_empty() && !self.donors(edge, &way).is_empty())
                .then_some(Bend { donors, ..bend })
        };
        let bends: Vec<Bend<D>> = [[a, b], [b, a]].into_iter().filter_map(bend).collect();
        let kind = if piece.is_convex {
            Kind::Ridge
        } else {
            Kind::Hollow
        };
        Some(Piece {
            kind,
            ends: piece.ends,
            walls: bends.first()?.clone(),
            bends,
            goes_on: [false; 2],
            edge: 0,
        })
    }

    /// A piece of an edge that parts a `stream`: what it leaves, as a trailing edge, parts nothing.
    fn tip(&self, edge: &Edge<D>, unit: f64, stream: &Vector<D>) -> Option<Piece<D>> {
        let piece = &edge.crease;
        let [a, b] = piece.normals;
        let walls = lying(piece, [a, b], unit);
        let (to, from) = (Vector::from(walls.before), Vector::from(walls.along));
        let before = (from - to).normalize();
        let both = [&walls, &turned_back(&walls)];
        let has_both = both.iter().all(|wall| !self.donors(edge, wall).is_empty());
        if !has_both || stream.dot(&before) < 0.0 {
            return None;
        }
        let at = Vector::from(walls.at);
        let donors = self.gas_at(&(at - before * (CLEAR * unit)), unit)?;
        let bend = |along: Vector<D>, up: Vector<D>| Bend {
            donors: donors.clone(),
            along: along.into(),
            before: before.into(),
            up: up.into(),
            ..walls.clone()
        };
        Some(Piece {
            kind: Kind::Tip,
            ends: piece.ends,
            bends: vec![bend(-to, a), bend(from, b)],
            walls,
            goes_on: [false; 2],
            edge: 0,
        })
    }

    /// The cell with the nearest point to a place, no farther off than this; in equal parts all that are as near.
    fn gas_at(&self, place: &Vector<D>, farthest: f64) -> Option<Vec<(u32, f64)>> {
        const ALIKE: f64 = 1e-6;
        let points = &self.cells.points;
        let by_point = self
            .by_point
            .get_or_init(|| Pencils::new(points, LONGEST * self.range[0]));
        let mut near: Vec<(f64, u32)> = Vec::new();
        by_point.for_each_run_near(place, place, farthest, |run| {
            let numbers = by_point.order()[run].iter();
            near.extend(numbers.map(|&i| ((points[i as usize] - place).norm(), i)));
        });
        let least = near.iter().fold(farthest, |least, near| near.0.min(least));
        near.retain(|(away, _)| *away < farthest && *away <= least + ALIKE * farthest);
        near.sort_by_key(|(_, i)| *i);
        let part = 1.0 / near.len() as f64;
        (!near.is_empty()).then(|| near.into_iter().map(|(_, i)| (i, part)).collect())
    }

    /// The cells that gas comes from which meets a piece of an edge as `bend` has it.
    fn donors(&self, edge: &Edge<D>, bend: &Bend<D>) -> Vec<(u32, f64)> {
        let [from, to] = edge.crease.ends;
        let half = 0.5 * (to - from).norm() + LOOK * bend.unit;
        let at = Vector::from(bend.at);
        let ways = [bend.edge, bend.before, bend.up].map(Vector::from);
        self.lying(edge.owners, &at, bend.unit, half, ways.each_ref())
    }

    /// Cells on the wall of the normal `up` that goes `towards` the `edge`, and what each counts, in all one: those next to the
    /// piece that lie wholly before it.
    fn lying(
        &self,
        owners: [u32; 2],
        at: &Vector<D>,
        unit: f64,
        half: f64,
        [edge, towards, up]: [&Vector<D>; 3],
    ) -> Vec<(u32, f64)> {
        let mut found = Vec::new();
        let reach = half + (AHEAD + LOOK + 1.0) * unit;
        self.for_each(owners, at, reach, |number, wall| {
            let normal = -Vector::from(wall.image.normal);
            let is_one = normal.dot(up) > 0.0
                && normal.dot(towards).abs() < STRAIGHT
                && normal.dot(edge).abs() < ROUND;
            let arm = wall.foot - at;
            let point = self.cells.points[wall.i as usize] - at;
            let away = -towards.dot(&arm).max(towards.dot(&point)) / unit - AHEAD;
            let beside = edge.dot(&arm).abs() / half;
            if is_one && arm.dot(up).abs() < OFF * unit && away > 0.0 && away < LOOK && beside < 1.0
            {
                let near = (1.0 - away / LOOK) * (1.0 - beside);
                found.push((number, wall.i, near * wall.image.size));
            }
        });
        found.sort_by_key(|(number, ..)| *number);
        let sum: f64 = found.iter().map(|(.., part)| part).sum();
        found
            .into_iter()
            .map(|(_, i, part)| (i, part / sum))
            .collect()
    }
}

/// How the walls of a piece of an edge lie for gas that comes along that of the first normal and leaves along that of the second.
fn lying<const D: usize>(piece: &Crease<D>, [up, beyond]: [Vector<D>; 2], unit: f64) -> Bend<D> {
    let [from, to] = piece.ends;
    let cosine = up.dot(&beyond);
    let way = if piece.is_convex { 1.0 } else { -1.0 };
    let before = (beyond - up * cosine).normalize() * way;
    let along = (before * cosine - up * before.dot(&beyond)).normalize();
    Bend {
        at: (0.5 * (from + to)).into(),
        edge: cross(&up, &before).into(),
        donors: Vec::new(),
        along: along.into(),
        before: before.into(),
        up: up.into(),
        unit,
    }
}

/// A bend as it is met from behind.
fn turned_back<const D: usize>(bend: &Bend<D>) -> Bend<D> {
    let back = |way: &[f64; D]| way.map(|part| -part);
    Bend {
        donors: Vec::new(),
        along: back(&bend.before),
        before: back(&bend.along),
        up: bend.up_behind(),
        ..*bend
    }
}
