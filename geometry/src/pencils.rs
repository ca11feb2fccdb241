//! The neighbour grid: points sorted into pencils (columns along the last axis), so that every
//! search is a few contiguous runs, and consecutive points form compact clusters.
//!
//! Columns are visited in serpentine order: odd columns run backwards, so that the order has no
//! jumps and may be cut anywhere.

mod search;
mod slots;
#[cfg(test)]
mod tests;

use crate::Vector;
use crate::parallel::prelude::*;

use self::slots::{Key, Slots};

/// Points of one set, sorted into pencils. A *slot* is a place in the sorted order.
#[derive(Clone, Debug)]
pub struct Pencils<const D: usize> {
    origin: [f64; D],
    /// Cell of the first column per axis, counted from the origin.
    first: [i64; D],
    inverse_width: f64,
    /// Number of columns per axis; one for the last axis.
    columns: [usize; D],
    slots: Slots,
}

impl<const D: usize> Default for Pencils<D> {
    fn default() -> Self {
        Self {
            origin: [0.0; D],
            first: [0; D],
            inverse_width: 0.0,
            columns: [1; D],
            slots: Slots::default(),
        }
    }
}

impl<const D: usize> Pencils<D> {
    /// Sorts `points` into columns of about `width`; a point whose coordinates are not finite is
    /// never found again.
    pub fn new(points: &[Vector<D>], width: f64) -> Self {
        let mut pencils = Self::default();
        pencils.rebuild(points, width);
        pencils
    }

    /// Sorts `points` anew, reusing memory; fast where they are nearly in order already.
    pub fn rebuild(&mut self, points: &[Vector<D>], width: f64) {
        self.rebuild_from(points.len(), |point| points[point], width);
    }

    /// As [`Self::rebuild`] of the points `position(n)` for `n` below `count`.
    pub fn rebuild_from(
        &mut self,
        count: usize,
        position: impl Fn(usize) -> Vector<D> + Sync,
        width: f64,
    ) {
        self.frame(None, count, &position, width);
        self.sort(count, &position, |point| point as u64);
    }

    /// As [`Self::rebuild_from`], in cells that are counted from `corner`, and with ties, where points share a column and the
    /// coordinate along it, by `rank`: the order of any of the points depends on no other point, nor on the order in which
    /// they are given.
    pub fn rebuild_on_grid(
        &mut self,
        corner: &Vector<D>,
        width: f64,
        count: usize,
        position: impl Fn(usize) -> Vector<D> + Sync,
        rank: impl Fn(usize) -> u64 + Sync,
    ) {
        self.frame(Some(corner), count, &position, width);
        self.sort(count, &position, rank);
    }

    /// Sorts the points into the columns that there are.
    fn sort(
        &mut self,
        count: usize,
        position: &(impl Fn(usize) -> Vector<D> + Sync),
        rank: impl Fn(usize) -> u64 + Sync,
    ) {
        let mut keys = std::mem::take(&mut self.slots.keys);
        let key = |point| self.key(point, &position(point), rank(point));
        (0..count)
            .into_par_iter()
            .map(key)
            .collect_into_vec(&mut keys);
        self.slots.keys = keys;
        self.slots.sort(self.columns.iter().product());
    }

    /// Point number at each slot.
    pub fn order(&self) -> &[u32] {
        &self.slots.order
    }

    /// Places the origin, at `corner` or at the lowest coordinates of all points, and chooses the number of columns, no more
    /// than a few per point.
    fn frame(
        &mut self,
        corner: Option<&Vector<D>>,
        count: usize,
        position: &(impl Fn(usize) -> Vector<D> + Sync),
        mut width: f64,
    ) {
        let nowhere = [[f64::INFINITY; D], [f64::NEG_INFINITY; D]];
        let wider = |[a, b]: [[f64; D]; 2], [c, d]: [[f64; D]; 2]| {
            [
                std::array::from_fn(|k| a[k].min(c[k])),
                std::array::from_fn(|k| b[k].max(d[k])),
            ]
        };
        let [min, max] = (0..count)
            .into_par_iter()
            .map(|point| [position(point).into(); 2])
            .reduce(|| nowhere, wider);
        self.columns = [1; D];
        self.first = [0; D];
        self.origin = corner.map_or(min, |&corner| corner.into());
        self.inverse_width = 1.0 / width;
        if count == 0 {
            self.origin = [0.0; D];
            return;
        }
        let most = 4.0 * count as f64 + 64.0;
        loop {
            let first = |k: usize| match corner {
                Some(_) => self.cell(k, min[k]).clamp(-FURTHEST, FURTHEST),
                None => 0.0,
            };
            let span = |k: usize| match corner {
                Some(_) => self.cell(k, max[k]) - first(k),
                None => ((max[k] - min[k]) / width).floor(),
            };
            // One where coordinates that are not finite leave no number at all.
            let count = |k: usize| (span(k) + 1.0).max(1.0);
            let total: f64 = (0..D - 1).map(count).product();
            if total <= most {
                let columns =
                    std::array::from_fn(|k| if k < D - 1 { count(k) as usize } else { 1 });
                self.first = std::array::from_fn(|k| if k < D - 1 { first(k) as i64 } else { 0 });
                self.columns = columns;
                return;
            }
            width *= 2.0;
            self.inverse_width = 1.0 / width;
        }
    }

    /// Cell of a coordinate along axis `k`, counted from the origin.
    fn cell(&self, k: usize, coordinate: f64) -> f64 {
        ((coordinate - self.origin[k]) * self.inverse_width).floor()
    }

    fn key(&self, point: usize, position: &Vector<D>, rank: u64) -> Key {
        let mut cell = [0; D];
        for k in 0..D - 1 {
            let across = self.cell(k, position[k]) - self.first[k] as f64;
            cell[k] = (across.max(0.0) as usize).min(self.columns[k] - 1);
        }
        let along = position[D - 1];
        Key {
            column: self.column(&cell) as u32,
            along: if self.is_backwards(&cell) {
                -along
            } else {
                along
            },
            rank,
            point: point as u32,
        }
    }

    /// Column number of a cell; in 3D the second axis is serpentine too.
    fn column(&self, cell: &[usize; D]) -> usize {
        if D < 3 {
            return if D == 2 { cell[0] } else { 0 };
        }
        let across = if self.is_odd(0, cell) {
            self.columns[1] - 1 - cell[1]
        } else {
            cell[1]
        };
        cell[0] * self.columns[1] + across
    }

    /// True where the cell's number along axis `k` is odd.
    fn is_odd(&self, k: usize, cell: &[usize; D]) -> bool {
        (self.first[k] + cell[k] as i64) % 2 != 0
    }

    /// True of columns that run backwards, every other one.
    fn is_backwards(&self, cell: &[usize; D]) -> bool {
        (0..D - 1).fold(false, |odd, k| odd != self.is_odd(k, cell))
    }
}

/// Cells are numbered exactly up to here.
const FURTHEST: f64 = (1_u64 << 52) as f64;
