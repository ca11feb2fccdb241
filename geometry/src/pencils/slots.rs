//! Slots of the neighbour grid, column by column: no dimension changes them, and they are compiled once.

use crate::parallel::prelude::*;

/// What a point is sorted by.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Key {
    /// Coordinate along the pencil, sign flipped in odd columns.
    pub along: f64,
    pub rank: u64,
    pub column: u32,
    pub point: u32,
}

/// Points in the order of their columns.
#[derive(Clone, Debug)]
pub(super) struct Slots {
    /// First slot of each column, and the end.
    pub start: Vec<u32>,
    /// Coordinate along the pencil per slot.
    pub along: Vec<f64>,
    /// Point number per slot.
    pub order: Vec<u32>,
    /// As the points are given.
    pub keys: Vec<Key>,
    sorted: Vec<Key>,
}

impl Default for Slots {
    fn default() -> Self {
        Self {
            start: vec![0, 0],
            along: Vec::new(),
            order: Vec::new(),
            keys: Vec::new(),
            sorted: Vec::new(),
        }
    }
}

impl Slots {
    /// Sorts the keys by column, of which there are so many, and those of each column by coordinate, rank and number.
    pub fn sort(&mut self, columns: usize) {
        let (keys, sorted) = (&self.keys, &mut self.sorted);
        self.start.clear();
        self.start.resize(columns + 1, 0);
        for key in keys {
            self.start[key.column as usize + 1] += 1;
        }
        for column in 1..self.start.len() {
            self.start[column] += self.start[column - 1];
        }
        sorted.clear();
        sorted.resize(keys.len(), Key::default());
        let mut next = self.start.clone();
        for key in keys {
            let slot = &mut next[key.column as usize];
            sorted[*slot as usize] = *key;
            *slot += 1;
        }
        // The point's number breaks what ties are left, so the order is unique for any number of threads.
        let columns = sorted.chunk_by_mut(|a, b| a.column == b.column);
        let mut columns: Vec<_> = columns.collect();
        columns.par_iter_mut().for_each(|column| {
            column.sort_unstable_by(|a, b| {
                (a.along.total_cmp(&b.along))
                    .then(a.rank.cmp(&b.rank))
                    .then(a.point.cmp(&b.point))
            });
        });
        let order = sorted.par_iter().map(|key| key.point);
        order.collect_into_vec(&mut self.order);
        let along = sorted.par_iter().map(|key| key.along);
        along.collect_into_vec(&mut self.along);
    }
}
