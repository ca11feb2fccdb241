//! Tips in the plane: where a body ends against the stream, or in it.

use aero_geometry::Vector;

use super::bend::{Bend, Tip, cross};
use super::chain::{Chain, LOOKS, SMOOTH};

/// Cosine between the directions of walls below which one is not the other's way on to a tip.
const BLUNT: f64 = 0.7;

/// Walls of less than this, in spacings, are short: whatever way they go, they are what cells leave of a tip.
const SHORT: f64 = 0.25;

/// So far from the last walls before it, in spacings, a tip may be.
pub const FAR: f64 = 2.5;

/// So far ahead of a tip, in spacings, gas has not met it yet.
pub const AHEAD: f64 = 1.5;

impl<const D: usize> Chain<'_, D> {
    /// All tips: where a wall ends and another one goes back, sharper than a right angle.
    pub fn tips(&self) -> Vec<Tip<D>> {
        let last = |way: usize| -> Vec<usize> {
            let all = (0..self.solid).filter(|&wall| self.is_long(wall));
            all.filter(|&wall| self.is_last(wall, way)).collect()
        };
        let (ends, starts) = (last(0), last(1));
        let pairs = ends.iter().flat_map(|&end| {
            let reach = 2.0 * FAR * self.units[end];
            let away = move |start: usize| (self.walls[start].foot - self.walls[end].foot).norm();
            let near = starts.iter().filter(move |&&start| away(start) < reach);
            near.map(move |&start| (away(start), end, start))
        });
        let mut pairs: Vec<(f64, usize, usize)> = pairs.collect();
        pairs.sort_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
        let mut tips: Vec<Tip<D>> = Vec::new();
        for (_, end, start) in pairs {
            let Some(tip) = self.tip(end, start) else {
                continue;
            };
            let here = Vector::from(tip.around.at);
            let is_at = |other: &Tip<D>| (Vector::from(other.around.at) - here).norm();
            if tips.iter().all(|other| is_at(other) > tip.around.unit) {
                tips.push(tip);
            }
        }
        tips
    }

    pub(super) fn is_long(&self, wall: usize) -> bool {
        self.walls[wall].image.share >= SHORT * self.units[wall]
    }

    /// True of a wall that no long one goes on from this `way`.
    pub(super) fn is_last(&self, wall: usize, way: usize) -> bool {
        let mut here = wall;
        for _ in 0..LOOKS {
            let Some(next) = self.links[way][here] else {
                return true;
            };
            if self.is_long(next) {
                return self.way(next).dot(&self.way(wall)) <= BLUNT;
            }
            here = next;
        }
        true
    }

    /// The tip between a wall that ends and one of the same body that starts, if they meet in one.
    fn tip(&self, end: usize, start: usize) -> Option<Tip<D>> {
        let (to, from) = (self.way(end), self.way(start));
        let owner = self.walls[end].owner;
        let turn = self.turn(end, start);
        let is_smooth = |wall: usize, way: usize| {
            let step = self.links[way][wall].map(|to| self.turn(wall, to).abs());
            step.is_some_and(|step| step < SMOOTH * turn.abs())
        };
        let is_sharp = turn < 0.0 && to.dot(&from) < 0.0;
        let is_one = owner == self.walls[start].owner;
        if !is_one || !is_sharp || !is_smooth(end, 1) || !is_smooth(start, 0) {
            return None;
        }
        let unit = self.units[end].max(self.units[start]);
        let arm = self.walls[start].foot - self.walls[end].foot;
        let [past, back] = [&from, &to].map(|way| cross(&arm, way) / cross(&to, &from));
        if ![past, -back]
            .iter()
            .all(|away| (0.0..FAR * unit).contains(away))
        {
            return None;
        }
        let at = self.walls[end].foot + to * past;
        // Nothing blunts it.
        let cuts = |&other: &usize| {
            let (wall, way) = (self.walls[other], self.way(other));
            let is_near = (wall.foot - at).norm() < past.max(-back);
            let goes_on = way.dot(&to) > BLUNT || way.dot(&from) > BLUNT;
            wall.owner == owner && is_near && !goes_on && self.is_long(other)
        };
        if (0..self.solid).any(|other| cuts(&other)) {
            return None;
        }
        let before = (from - to).normalize();
        let donors = self.gas_at(&(at - before * (AHEAD * unit)), unit)?;
        let bend = |before: Vector<D>, along: Vector<D>, wall: usize| Bend {
            at: at.into(),
            edge: [0.0; D],
            donors: donors.clone(),
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

    /// The cell with the nearest point to a place, no farther off than this; in equal parts all that are as near, as those on both sides of a
    /// line of symmetry are.
    pub(super) fn gas_at(&self, place: &Vector<D>, farthest: f64) -> Option<Vec<(u32, f64)>> {
        const ALIKE: f64 = 1e-6;
        let away = |point: &Vector<D>| (point - place).norm();
        let all = || self.cells.points.iter().map(away);
        let least = all().fold(f64::INFINITY, f64::min) + ALIKE * farthest;
        let near = (0..).zip(all()).filter(|(_, away)| *away <= least);
        let near: Vec<u32> = near.map(|(i, _)| i).collect();
        let part = 1.0 / near.len() as f64;
        (least < farthest).then(|| near.into_iter().map(|i| (i, part)).collect())
    }
}
