//! The walls beside a sharp edge in space: how fine cells are there, and where the gas is that comes to it.

use aero_geometry::{Pencils, Ridge, Vector};

use super::bend::Bend;
use super::cells::Cells;
use super::fan::farthest;
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

/// A straight piece of an edge.
#[derive(Clone, Debug)]
pub struct Piece<const D: usize> {
    /// Its ends.
    pub ends: [Vector<D>; 2],
    /// The edge as gas meets it from either side, where it can.
    pub bends: Vec<Bend<D>>,
    /// Whether the edge goes on beyond each end.
    pub goes_on: [bool; 2],
}

impl<const D: usize> Piece<D> {
    /// Square of the distance of a place, and whether that is neither too far across the edge nor beyond an end of it.
    pub fn sees(&self, place: &Vector<D>) -> (f64, bool) {
        let unit = self.bends[0].unit;
        let [from, to] = self.ends;
        let half = 0.5 * (to - from).norm();
        let way = (to - from) / (2.0 * half);
        let arm = place - 0.5 * (from + to);
        let along = way.dot(&arm);
        let beyond = (along.abs() - half).max(0.0);
        let across = (arm - way * along).norm();
        let is_beside = beyond <= 1e-6 * unit || self.goes_on[usize::from(along > 0.0)];
        let is_near = across < farthest::<D>() * unit;
        let from_here = place - Vector::from(self.bends[0].at);
        let is_open = self.bends.iter().any(|bend| bend.opens_to(&from_here));
        (
            across * across + beyond * beyond,
            is_beside && is_near && is_open,
        )
    }
}

/// The walls of all cells.
pub struct Beside<'a, const D: usize> {
    cells: &'a Cells<D>,
    walls: Vec<&'a Wall<D>>,
    /// Spacing of the points there, wall by wall.
    units: Vec<f64>,
    by_foot: Pencils<D>,
    /// Least and largest spacing.
    range: [f64; 2],
}

impl<'a, const D: usize> Beside<'a, D> {
    /// Those of `net`, whose cells are `cells`; none where there are none.
    pub fn new(net: &'a Net<D>, cells: &'a Cells<D>) -> Option<Self> {
        let walls: Vec<&Wall<D>> = net.blocks.iter().flat_map(|block| &block.walls).collect();
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
            walls,
            units,
            range,
        })
    }

    /// Least spacing on the walls.
    pub fn finest(&self) -> f64 {
        self.range[0]
    }

    /// Hands out all walls with their feet within `reach` of a place that are not another's.
    fn for_each(
        &self,
        owner: u32,
        place: &Vector<D>,
        reach: f64,
        mut take: impl FnMut(usize, &Wall<D>),
    ) {
        self.by_foot.for_each_run_near(place, place, reach, |run| {
            for &number in &self.by_foot.order()[run] {
                let wall = self.walls[number as usize];
                if wall.owner == owner && (wall.foot - place).norm() < reach {
                    take(number as usize, wall);
                }
            }
        });
    }

    /// Spacing of the points at the nearest wall; none where there is none near.
    fn unit(&self, owner: u32, place: &Vector<D>) -> Option<f64> {
        let mut reach = LONGEST * self.range[0];
        while reach < 2.0 * LONGEST * self.range[1] {
            let mut best: Option<(f64, usize)> = None;
            self.for_each(owner, place, reach, |number, wall| {
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

    /// The pieces of an edge of body `owner` that gas can meet.
    pub fn pieces(&self, owner: u32, ridge: &Ridge<D>) -> Vec<Piece<D>> {
        let mut found = Vec::new();
        let mut left = vec![ridge.ends];
        while let Some(ends) = left.pop() {
            let [from, to] = ends;
            let middle = 0.5 * (from + to);
            let unit = self.unit(owner, &middle);
            if (to - from).norm() > LONGEST * unit.unwrap_or(self.range[1]) {
                left.extend([[middle, to], [from, middle]]);
                continue;
            }
            let Some(unit) = unit else {
                continue;
            };
            let [a, b] = ridge.normals;
            let sides = [[a, b], [b, a]].into_iter();
            let bends: Vec<Bend<D>> = sides
                .filter_map(|normals| self.bend(owner, ends, normals, unit))
                .collect();
            if !bends.is_empty() {
                found.push(Piece {
                    ends,
                    bends,
                    goes_on: [false; 2],
                });
            }
        }
        found
    }

    /// A piece of an edge as gas meets it that comes along the wall of the first normal and leaves along that of the second.
    fn bend(
        &self,
        owner: u32,
        [from, to]: [Vector<D>; 2],
        [up, beyond]: [Vector<D>; 2],
        unit: f64,
    ) -> Option<Bend<D>> {
        let (cosine, at) = (up.dot(&beyond), 0.5 * (from + to));
        let before = (beyond - up * cosine).normalize();
        let along = (before * cosine - up * before.dot(&beyond)).normalize();
        let edge = cross(&up, &before);
        let half = 0.5 * (to - from).norm() + LOOK * unit;
        let donors = self.lying(owner, &at, unit, half, [&edge, &before, &up]);
        let away = -along;
        let leaving = self.lying(owner, &at, unit, half, [&edge, &away, &beyond]);
        if donors.is_empty() || leaving.is_empty() {
            return None;
        }
        Some(Bend {
            at: at.into(),
            edge: edge.into(),
            donors,
            along: along.into(),
            before: before.into(),
            up: up.into(),
            unit,
        })
    }

    /// Cells on the wall of the normal `up` that goes `towards` the `edge`, and what each counts, in all one: those next to the
    /// piece that lie wholly before it.
    fn lying(
        &self,
        owner: u32,
        at: &Vector<D>,
        unit: f64,
        half: f64,
        [edge, towards, up]: [&Vector<D>; 3],
    ) -> Vec<(u32, f64)> {
        let mut found = Vec::new();
        let reach = half + (AHEAD + LOOK + 1.0) * unit;
        self.for_each(owner, at, reach, |number, wall| {
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
