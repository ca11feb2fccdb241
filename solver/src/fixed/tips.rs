//! Tips in the plane: where a body ends against the stream, or in it.

use std::collections::BTreeSet;

use aero_geometry::Vector;

use super::bend::{Bend, Tip, cross};
use super::chain::{ASKEW, Chain, SMOOTH};

/// Cosine between the directions of walls below which one is not the other's way on to a tip.
const BLUNT: f64 = 0.7;

/// Walls of less than this, in spacings, are short.
const SHORT: f64 = 0.25;

/// So far from the last walls before it, in spacings, a tip may be.
const TIP: f64 = 2.5;

/// So far ahead of a tip, in spacings, gas has not met it yet.
const AHEAD_OF_TIP: f64 = 1.5;

impl<const D: usize> Chain<'_, D> {
    /// All tips: where a wall ends and another one goes back.
    pub fn tips(&self) -> Vec<Tip<D>> {
        // A short wall may stand across a tip.
        let is_last = |wall: usize, way: usize| {
            let next = self.links[way][wall].map(|next| self.way(next));
            let goes_on = next.is_some_and(|next| next.dot(&self.way(wall)) > BLUNT);
            wall < self.solid && !goes_on
        };
        let last = |way: usize| -> BTreeSet<usize> {
            let all = (0..self.walls.len()).filter(|&wall| is_last(wall, way));
            all.map(|wall| self.longer(wall, 1 - way)).collect()
        };
        let [ends, starts] = [0, 1].map(last);
        let tip_of = |end: usize| {
            let here = self.walls[end].foot;
            let away = |start: usize| (self.walls[start].foot - here).norm();
            let near = starts.iter().copied();
            let near = near.filter(|&start| away(start) < 2.0 * TIP * self.units[end]);
            let tips = near.filter_map(|start| self.tip(end, start).map(|tip| (start, tip)));
            let nearest = tips.min_by(|(a, _), (b, _)| away(*a).total_cmp(&away(*b)));
            nearest.map(|(_, tip)| tip)
        };
        ends.into_iter().filter_map(tip_of).collect()
    }

    /// The tip between a wall that ends and one of the same body that starts, if they meet in one.
    fn tip(&self, end: usize, start: usize) -> Option<Tip<D>> {
        let (to, from) = (self.way(end), self.way(start));
        let is_one = self.walls[end].owner == self.walls[start].owner;
        let turn = self.turn(end, start);
        let is_smooth = |wall: usize, way: usize| {
            let step = self.links[way][wall].map(|to| self.turn(wall, to).abs());
            step.is_some_and(|step| step < SMOOTH * turn.abs())
        };
        let is_convex = turn < 0.0 && to.dot(&from) < ASKEW;
        if !is_one || !is_convex || !is_smooth(end, 1) || !is_smooth(start, 0) {
            return None;
        }
        let unit = self.units[end].max(self.units[start]);
        let arm = self.walls[start].foot - self.walls[end].foot;
        let [past, back] = [&from, &to].map(|way| cross(&arm, way) / cross(&to, &from));
        if ![past, -back]
            .iter()
            .all(|away| (0.0..TIP * unit).contains(away))
        {
            return None;
        }
        let at = self.walls[end].foot + to * past;
        let before = (from - to).normalize();
        let donor = self.gas_at(&(at - before * (AHEAD_OF_TIP * unit)), unit)?;
        let bend = |before: Vector<D>, along: Vector<D>, wall: usize| Bend {
            at: at.into(),
            edge: [0.0; D],
            donors: vec![(donor, 1.0)],
            along: along.into(),
            before: before.into(),
            up: self.walls[wall].image.normal.map(|part| -part),
            unit,
        };
        Some(Tip {
            around: bend(to, from, end),
            bends: [bend(before, -to, end), bend(before, from, start)],
        })
    }

    /// A wall, or where it is short the one beside it that `way`: the direction of short ones is uncertain.
    fn longer(&self, wall: usize, way: usize) -> usize {
        let is_short = self.walls[wall].image.share < SHORT * self.units[wall];
        let beside = self.links[way][wall].filter(|_| is_short);
        beside.unwrap_or(wall)
    }

    /// The cell with the nearest point to a place, no farther off than this.
    fn gas_at(&self, place: &Vector<D>, farthest: f64) -> Option<u32> {
        let away = self.cells.points.iter().map(|point| (point - place).norm());
        let near = (0..).zip(away).filter(|(_, away)| *away < farthest);
        let nearest = near.min_by(|(i, a), (j, b)| a.total_cmp(b).then(i.cmp(j)));
        nearest.map(|(i, _)| i)
    }
}
