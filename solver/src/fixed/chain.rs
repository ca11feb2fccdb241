//! Walls in the plane one after another, and where they bend.

use aero_geometry::Vector;

use super::bend::{Bend, Kink, cross, turned};
use super::cells::Cells;
use super::net::Net;
use super::walls::Wall;

/// Angle between neighbouring walls from which on a bend is sharp, radians: about a degree.
const SHARP: f64 = 0.02;

/// Walls next to a sharp bend turn by less than this part of it: those of a curve turn alike.
pub(super) const SMOOTH: f64 = 1.0 / 3.0;

/// Cosine between the directions of walls below which they do not follow each other.
const ASKEW: f64 = 0.3;

/// Walls of less than this, in spacings, are what is left where a body touches the corner of a cell, and point anywhere.
const SPECK: f64 = 1e-6;

/// Distance from a bend, in spacings, at which gas has not met it yet.
const AHEAD: f64 = 1.0;

/// Walls that are looked at for such gas.
pub(super) const LOOKS: usize = 6;

/// The walls in the plane, each with those that follow it, the gas to the left.
pub struct Chain<'a, const D: usize> {
    pub(super) cells: &'a Cells<D>,
    pub(super) walls: Vec<&'a Wall<D>>,
    /// How many of them are walls; mirrors, which planes of symmetry are to gas that slides along, come after.
    pub(super) solid: usize,
    /// Mean distance to the neighbours of the cell of each.
    pub(super) units: Vec<f64>,
    /// What follows each, and what goes before it.
    pub(super) links: [Vec<Option<usize>>; 2],
}

impl<'a, const D: usize> Chain<'a, D> {
    /// The walls of `net`, which are those of `cells`, and `mirrors`.
    pub fn new(net: &'a Net<D>, cells: &'a Cells<D>, mirrors: &'a [Wall<D>]) -> Self {
        let mut walls: Vec<&Wall<D>> = net.blocks.iter().flat_map(|block| &block.walls).collect();
        let solid = walls.len();
        walls.extend(mirrors);
        let spacings = cells.spacings();
        let is_speck = |wall: &Wall<D>| wall.image.share < SPECK * spacings[wall.i as usize];
        let mut of_cell: Vec<Vec<usize>> = vec![Vec::new(); cells.points.len()];
        for (number, wall) in walls.iter().enumerate() {
            if !is_speck(wall) {
                of_cell[wall.i as usize].push(number);
            }
        }
        let mut nearby = vec![Vec::new(); walls.len()];
        for face in cells.faces.iter() {
            for (i, j) in [(face.i, face.j), (face.j, face.i)] {
                let (own, others) = (&of_cell[i as usize], &of_cell[j as usize]);
                if own.is_empty() {
                    continue;
                }
                for &number in own {
                    nearby[number].extend(others);
                }
            }
        }
        for (wall, near) in walls.iter().zip(&mut nearby) {
            if !is_speck(wall) {
                near.extend(&of_cell[wall.i as usize]);
            }
        }
        let mut chain = Self {
            cells,
            units: walls.iter().map(|wall| spacings[wall.i as usize]).collect(),
            walls,
            solid,
            links: [Vec::new(), Vec::new()],
        };
        chain.links = [1.0, -1.0].map(|way| {
            let each = (0..chain.walls.len()).zip(&nearby);
            each.map(|(number, near)| chain.beside(number, near, way))
                .collect()
        });
        chain
    }

    /// Direction of a wall, the gas to its left.
    pub(super) fn way(&self, number: usize) -> Vector<D> {
        turned(&self.walls[number].image.normal.into())
    }

    /// The nearest of the walls `near` wall `number` that goes on along its `way`. One of another body, or of a side, does where they meet in a
    /// concave bend.
    fn beside(&self, number: usize, near: &[usize], way: f64) -> Option<usize> {
        let wall = self.walls[number];
        let along = self.way(number) * way;
        let follows = |other: &usize| {
            let arm = self.walls[*other].foot - wall.foot;
            let beyond = self.way(*other) * way;
            let turn = if way > 0.0 {
                self.turn(number, *other)
            } else {
                self.turn(*other, number)
            };
            *other != number
                && (self.walls[*other].owner == wall.owner || turn > SHARP)
                && beyond.dot(&along) > ASKEW
                && arm.dot(&(along + beyond)) > 0.0
        };
        let away = |other: &usize| (self.walls[*other].foot - wall.foot).norm();
        let follow = near.iter().copied().filter(follows);
        follow.min_by(|a, b| away(a).total_cmp(&away(b)).then(a.cmp(b)))
    }

    /// By how much the wall turns to the left from one to the next.
    pub(super) fn turn(&self, from: usize, to: usize) -> f64 {
        let (a, b) = (self.way(from), self.way(to));
        cross(&a, &b).atan2(a.dot(&b))
    }

    /// All sharp convex bends, each met from both sides.
    pub fn bends(&self) -> Vec<Bend<D>> {
        self.bends_to(-1.0)
    }

    /// All sharp concave bends, each met from both sides.
    pub fn hollows(&self) -> Vec<Bend<D>> {
        self.bends_to(1.0)
    }

    /// All sharp bends to the left, `way` one, or to the right, less one, each met from both sides.
    fn bends_to(&self, way: f64) -> Vec<Bend<D>> {
        let mut bends = Vec::new();
        for first in 0..self.walls.len() {
            let Some(next) = self.links[0][first] else {
                continue;
            };
            // The wall of a cell that holds the bend may stand between those before and behind.
            let is_sharp = |from: usize, to: usize| way * self.turn(from, to) > SHARP;
            let goes_on = |before: usize| is_sharp(before, first);
            if !is_sharp(first, next) || self.links[1][first].is_some_and(goes_on) {
                continue;
            }
            let last = self.links[0][next].filter(|&last| is_sharp(next, last));
            let last = last.unwrap_or(next);
            let turn = self.turn(first, last);
            let is_smooth = |from: usize, way: usize| {
                let step = self.links[way][from].map(|to| self.turn(from, to).abs());
                step.is_some_and(|step| step < SMOOTH * turn.abs())
            };
            if is_smooth(first, 1) && is_smooth(last, 0) {
                bends.extend(self.bend(first, last, 1));
                bends.extend(self.bend(last, first, 0));
            }
        }
        bends
    }

    /// The walls ahead of sharp concave bends within the cells that hold these, each with its number.
    pub fn kinks(&self) -> Vec<(usize, Kink<D>)> {
        let mut kinks = Vec::new();
        for first in 0..self.walls.len() {
            let Some(next) = self.links[0][first] else {
                continue;
            };
            let turn = self.turn(first, next);
            let is_smooth = |from: usize, way: usize| {
                let step = self.links[way][from].map(|to| self.turn(from, to).abs());
                step.is_some_and(|step| step < SMOOTH * turn)
            };
            if turn > SHARP && self.is_within_a_cell(first, next) {
                for (from, to, back) in [(first, next, 1), (next, first, 0)] {
                    if is_smooth(from, back) {
                        kinks.extend(self.ahead(from, to, back));
                    }
                }
            }
        }
        kinks.retain(|(number, _)| *number < self.solid);
        kinks
    }

    fn is_within_a_cell(&self, one: usize, other: usize) -> bool {
        self.walls[one].i == self.walls[other].i
    }

    /// The walls of a cell ahead of the bend between the walls `from` and `to` in it; `back` is the link that leads away from the bend.
    fn ahead(&self, from: usize, to: usize, back: usize) -> Vec<(usize, Kink<D>)> {
        let way = if back == 1 { 1.0 } else { -1.0 };
        let mut held = vec![from];
        let mut here = from;
        while let Some(next) = self.links[back][here] {
            if self.turn(here, next).abs() > SHARP {
                break;
            }
            if !self.is_within_a_cell(from, next) {
                let kink = |wall: usize| Kink {
                    wall,
                    donor: self.walls[next].i,
                    pressed: None,
                    before: (self.way(wall) * way).into(),
                    edge: [0.0; D],
                    along: Some((self.way(to) * way).into()),
                };
                return held.into_iter().map(|wall| (wall, kink(wall))).collect();
            }
            held.push(next);
            here = next;
        }
        Vec::new()
    }

    /// The bend between two walls, met from the side of the wall `from`; `back` is the link that leads away from it there.
    fn bend(&self, from: usize, to: usize, back: usize) -> Option<Bend<D>> {
        let way = if back == 1 { 1.0 } else { -1.0 };
        let (before, along) = (self.way(from) * way, self.way(to) * way);
        let (foot, unit) = (self.walls[from].foot, self.units[from]);
        let arm = self.walls[to].foot - foot;
        let at = foot + before * (cross(&arm, &along) / cross(&before, &along));
        let mut here = from;
        for _ in 0..LOOKS {
            let wall = self.walls[here];
            let point = self.cells.points[wall.i as usize];
            let away = |place: &Vector<D>| (at - place).dot(&before);
            let least = away(&wall.foot).min(away(&point));
            if least > AHEAD * unit {
                return Some(Bend {
                    at: at.into(),
                    edge: [0.0; D],
                    donors: vec![(wall.i, 1.0)],
                    along: along.into(),
                    before: before.into(),
                    up: wall.image.normal.map(|part| -part),
                    unit,
                });
            }
            let next = self.links[back][here]?;
            if self.turn(here, next).abs() > SHARP {
                return None;
            }
            here = next;
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use aero_geometry::{Outline, Placed, Placement, bodies};

    use super::*;
    use crate::fixed::FixedSimulation;
    use crate::fixed::tests::flows::stream;
    use crate::fixed::tests::lattice::WALL;

    /// The bends of a wall that is moved and turned, in a box.
    fn bends(outline: Outline, moved: [f64; 2], turned: f64) -> Vec<Bend<2>> {
        let place = Placement::default().rotated(turned).moved(moved.into());
        let body = Arc::new(Placed::new(Arc::new(outline), place));
        let mut problem = stream(2.0, [[-0.5, -0.6], [1.0, 0.8]], 0.05, vec![body]);
        // Below some of the walls gas is left.
        problem.domain.sides[1][0] = WALL;
        let flow = FixedSimulation::new(problem).unwrap();
        let mut bends: Vec<Bend<2>> = Vec::new();
        for around in flow.net.blocks.iter().flat_map(|block| &block.bends) {
            for bend in &around.bends {
                if !bends.contains(bend) {
                    bends.push(bend.clone());
                }
            }
        }
        bends
    }

    /// Wherever in its cell it lies, and whatever way the walls go.
    #[test]
    fn a_convex_corner_is_found_from_both_sides() {
        for (moved, turned) in [
            ([0.0, 0.0], 0.0),
            ([0.013, 0.031], 0.1),
            ([0.04, 0.02], -0.2),
        ] {
            let corner = bodies::expansion_corner(0.0, 20.0).unwrap();
            let bends = bends(corner, moved, turned);
            assert_eq!(bends.len(), 2, "{bends:?}");
            for bend in &bends {
                for k in 0..2 {
                    assert!((bend.at[k] - moved[k]).abs() < 1e-6, "{bend:?}");
                }
                let [before, along] = [bend.before, bend.along].map(Vector::<2>::from);
                let turn = f64::to_radians(20.0);
                assert!((before.dot(&along) - turn.cos()).abs() < 1e-6);
                assert!((Vector::<2>::from(bend.up).dot(&along) + turn.sin()).abs() < 1e-6);
            }
            let towards = Vector::<2>::new(turned.cos(), turned.sin());
            let is_met = |bend: &Bend<2>| Vector::from(bend.before).dot(&towards) > 0.999_999;
            assert_eq!(bends.iter().filter(|bend| is_met(bend)).count(), 1);
        }
    }

    /// A polygon whose corner is taken for a part of a curve has walls between both sides of it.
    #[test]
    fn a_corner_that_a_wall_rounds_off_is_found() {
        let points = [
            [-2.0, -0.2],
            [0.0, 0.08],
            [2.0, -0.2],
            [2.0, -2.0],
            [-2.0, -2.0],
        ];
        let outline = bodies::polygon(&points.map(Vector::from)).unwrap();
        let bends = bends(outline, [0.23, 0.0], 0.0);
        assert_eq!(bends.len(), 2, "{bends:?}");
        for bend in bends {
            assert!((bend.at[0] - 0.23).abs() < 1e-6 && (bend.at[1] - 0.08).abs() < 1e-6);
        }
    }

    #[test]
    fn ramps_and_curves_have_no_sharp_convex_bend() {
        assert!(
            bends(
                bodies::compression_corner(0.0, 20.0).unwrap(),
                [0.0; 2],
                0.0
            )
            .is_empty()
        );
        assert!(bends(bodies::circle(0.7).unwrap(), [0.2, -0.6], 0.0).is_empty());
        assert!(bends(bodies::wall(0.03).unwrap(), [0.0; 2], 0.05).is_empty());
    }
}
