//! Searching the neighbour grid: the runs of points in a box, and near one.

use std::ops::Range;

use super::Pencils;
use crate::Vector;

impl<const D: usize> Pencils<D> {
    /// Calls `visit` with every run of slots that may hold points inside the box `min..=max`;
    /// along the last axis the runs are exact, across it they are whole columns.
    pub fn for_each_run(
        &self,
        min: &Vector<D>,
        max: &Vector<D>,
        mut visit: impl FnMut(Range<usize>),
    ) {
        self.for_each_column(min, max, |this, cell| {
            let run = this.run(cell, min[D - 1], max[D - 1]);
            if !run.is_empty() {
                visit(run);
            }
        });
    }

    /// As [`Self::for_each_run`] for the points nearer than `reach` to the box: at its edges and
    /// corners the runs are shorter than those of the box grown by `reach`.
    pub fn for_each_run_near(
        &self,
        min: &Vector<D>,
        max: &Vector<D>,
        reach: f64,
        mut visit: impl FnMut(Range<usize>),
    ) {
        // Columns know their points' places to round-off only.
        let reach = reach * (1.0 + 1e-9);
        let (low, high) = (min.add_scalar(-reach), max.add_scalar(reach));
        self.for_each_column(&low, &high, |this, cell| {
            let mut across = 0.0;
            for k in 0..D - 1 {
                let number = this.first[k] + cell[k] as i64;
                let begin = this.origin[k] + number as f64 / this.inverse_width;
                let end = begin + 1.0 / this.inverse_width;
                let gap = (begin - max[k]).max(min[k] - end).max(0.0);
                across += gap * gap;
            }
            let along = reach * reach - across;
            if along <= 0.0 {
                return;
            }
            let along = along.sqrt();
            let run = this.run(cell, min[D - 1] - along, max[D - 1] + along);
            if !run.is_empty() {
                visit(run);
            }
        });
    }

    /// Calls `visit` with every column that the box `min..=max` meets.
    #[inline(always)]
    fn for_each_column(
        &self,
        min: &Vector<D>,
        max: &Vector<D>,
        mut visit: impl FnMut(&Self, &[usize; D]),
    ) {
        if self.slots.order.is_empty() {
            return;
        }
        let mut low = [0; D];
        let mut high = [0; D];
        for k in 0..D - 1 {
            let last = self.columns[k] as f64 - 1.0;
            let first = self.first[k] as f64;
            let from = (min[k] - self.origin[k]) * self.inverse_width - first;
            let to = (max[k] - self.origin[k]) * self.inverse_width - first;
            if to < 0.0 || from >= last + 1.0 {
                return;
            }
            low[k] = from.floor().clamp(0.0, last) as usize;
            high[k] = to.floor().clamp(0.0, last) as usize;
        }
        let mut cell = low;
        loop {
            visit(self, &cell);
            // Next column of the box, odometer fashion over all axes but the last.
            let mut axis = 0;
            loop {
                if axis + 1 >= D {
                    return;
                }
                if cell[axis] < high[axis] {
                    cell[axis] += 1;
                    break;
                }
                cell[axis] = low[axis];
                axis += 1;
            }
        }
    }

    /// Slots of the column of `cell` whose coordinate along the pencil lies in `from..=to`.
    fn run(&self, cell: &[usize; D], from: f64, to: f64) -> Range<usize> {
        let column = self.column(cell);
        let first = self.slots.start[column] as usize;
        let along = &self.slots.along[first..self.slots.start[column + 1] as usize];
        let (from, to) = if self.is_backwards(cell) {
            (-to, -from)
        } else {
            (from, to)
        };
        // Points are spread evenly more often than not.
        let guess = match along {
            [begin, .., end] => (from - begin) / (end - begin) * along.len() as f64,
            _ => 0.0,
        };
        let low = partition_point_near(along, guess as usize, |a| a < from);
        let high = partition_point_near(along, low + RUN, |a| a <= to);
        first + low..first + high
    }
}

/// Usual length of a run.
const RUN: usize = 32;

/// As [`slice::partition_point`], faster where the answer is near `guess`.
fn partition_point_near(sorted: &[f64], guess: usize, before: impl Fn(f64) -> bool) -> usize {
    let guess = guess.min(sorted.len());
    let (mut low, mut high, mut stride) = (guess, guess, FEW);
    while low > 0 && !before(sorted[low - 1]) {
        high = low;
        low = low.saturating_sub(stride);
        stride *= 4;
    }
    while high < sorted.len() && before(sorted[high]) {
        low = high;
        high = (high + stride).min(sorted.len());
        stride *= 4;
    }
    let window = &sorted[low..high];
    if window.len() > FEW {
        return low + window.partition_point(|&a| before(a));
    }
    // To count them all takes less than to guess wrong once.
    low + window
        .iter()
        .map(|&a| usize::from(before(a)))
        .sum::<usize>()
}

/// As many numbers are compared faster than searched.
const FEW: usize = 8;
