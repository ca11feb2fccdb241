//! The neighbour grid: points sorted into pencils (columns along the last axis), so that every
//! search is a few contiguous runs, and consecutive points form compact clusters.
//!
//! Columns are visited in serpentine order: odd columns run backwards, so that the order has no
//! jumps and may be cut anywhere.

use std::ops::Range;

use rayon::prelude::*;

use crate::Vector;

/// Points of one set, sorted into pencils. A *slot* is a place in the sorted order.
#[derive(Clone, Debug)]
pub struct Pencils<const D: usize> {
    origin: [f64; D],
    /// Cell of the first column per axis, counted from the origin.
    first: [i64; D],
    inverse_width: f64,
    /// Number of columns per axis; one for the last axis.
    columns: [usize; D],
    /// First slot of each column, and the end.
    start: Vec<u32>,
    /// Coordinate along the pencil per slot.
    along: Vec<f64>,
    order: Vec<u32>,
    keys: Vec<Key>,
}

#[derive(Clone, Copy, Debug)]
struct Key {
    column: u32,
    /// Coordinate along the pencil, sign flipped in odd columns.
    along: f64,
    point: u32,
}

impl<const D: usize> Default for Pencils<D> {
    fn default() -> Self {
        Self {
            origin: [0.0; D],
            first: [0; D],
            inverse_width: 0.0,
            columns: [1; D],
            start: vec![0, 0],
            along: Vec::new(),
            order: Vec::new(),
            keys: Vec::new(),
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
        let mut keys = std::mem::take(&mut self.keys);
        let key = |point| self.key(point, &position(point));
        (0..count)
            .into_par_iter()
            .map(key)
            .collect_into_vec(&mut keys);
        // The point's number breaks what ties are left, so the order is unique for any number of threads.
        keys.par_sort_unstable_by(|a, b| {
            a.column
                .cmp(&b.column)
                .then(a.along.total_cmp(&b.along))
                .then_with(|| rank(a.point as usize).cmp(&rank(b.point as usize)))
                .then(a.point.cmp(&b.point))
        });
        let sorted = keys.par_iter();
        let order = sorted.clone().map(|key| key.point);
        order.collect_into_vec(&mut self.order);
        sorted
            .map(|key| key.along)
            .collect_into_vec(&mut self.along);
        let columns: usize = self.columns.iter().product();
        (0..columns + 1)
            .into_par_iter()
            .map(|column| keys.partition_point(|key| (key.column as usize) < column) as u32)
            .collect_into_vec(&mut self.start);
        self.keys = keys;
    }

    /// Point number at each slot.
    pub fn order(&self) -> &[u32] {
        &self.order
    }

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
        if self.order.is_empty() {
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

    fn key(&self, point: usize, position: &Vector<D>) -> Key {
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

    /// Slots of the column of `cell` whose coordinate along the pencil lies in `from..=to`.
    fn run(&self, cell: &[usize; D], from: f64, to: f64) -> Range<usize> {
        let column = self.column(cell);
        let first = self.start[column] as usize;
        let along = &self.along[first..self.start[column + 1] as usize];
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

/// Cells are numbered exactly up to here.
const FURTHEST: f64 = (1_u64 << 52) as f64;

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

#[cfg(test)]
mod tests {
    use super::*;

    fn scattered<const D: usize>(count: usize) -> Vec<Vector<D>> {
        let mut seed = 7_u64;
        let mut next = || {
            seed = seed
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (seed >> 33) as f64 / f64::from(1_u32 << 31)
        };
        (0..count).map(|_| Vector::from_fn(|_, _| next())).collect()
    }

    fn finds_what_brute_force_finds<const D: usize>() {
        let points = scattered::<D>(500);
        let pencils = Pencils::new(&points, 0.13);
        let radius = 0.2;
        for centre in &points[..50] {
            let mut found: Vec<u32> = Vec::new();
            pencils.for_each_run(
                &centre.add_scalar(-radius),
                &centre.add_scalar(radius),
                |run| {
                    found.extend(
                        pencils.order()[run]
                            .iter()
                            .filter(|&&p| (points[p as usize] - centre).norm() < radius),
                    );
                },
            );
            found.sort_unstable();
            let expected: Vec<u32> = (0..500)
                .filter(|&p| (points[p as usize] - centre).norm() < radius)
                .collect();
            assert_eq!(found, expected);
        }
    }

    fn near_a_box_finds_what_brute_force_finds<const D: usize>() {
        let points = scattered::<D>(500);
        let pencils = Pencils::new(&points, 0.13);
        let (reach, size) = (0.2, 0.1);
        for min in &points[..50] {
            let max = min.add_scalar(size);
            let near = |point: &Vector<D>| {
                let outside = point - point.sup(min).inf(&max);
                outside.norm() < reach
            };
            let mut found: Vec<u32> = Vec::new();
            pencils.for_each_run_near(min, &max, reach, |run| {
                found.extend(
                    pencils.order()[run]
                        .iter()
                        .filter(|&&p| near(&points[p as usize])),
                );
            });
            found.sort_unstable();
            let expected: Vec<u32> = (0..500).filter(|&p| near(&points[p as usize])).collect();
            assert_eq!(found, expected);
        }
    }

    #[test]
    fn on_a_grid_the_order_of_points_depends_on_no_others() {
        let points = scattered::<3>(600);
        let corner = Vector::repeat(-0.37);
        let mut pencils = Pencils::default();
        let mut order = |kept: &[usize]| -> Vec<usize> {
            let rank = |n: usize| kept[n] as u64;
            // Ties everywhere: all points of a column at few heights.
            let place = |n: usize| {
                points[kept[n]].map_with_location(
                    |k, _, x: f64| {
                        if k == 2 { (x * 4.0).floor() } else { x }
                    },
                )
            };
            pencils.rebuild_on_grid(&corner, 0.13, kept.len(), place, rank);
            pencils.order().iter().map(|&n| kept[n as usize]).collect()
        };
        let all: Vec<usize> = (0..600).collect();
        let whole = order(&all);
        let backwards: Vec<usize> = all.iter().rev().copied().collect();
        assert_eq!(order(&backwards), whole);
        let part: Vec<usize> = all
            .iter()
            .copied()
            .filter(|&n| points[n][0] > 0.5)
            .collect();
        let expected: Vec<usize> = whole.iter().copied().filter(|n| part.contains(n)).collect();
        assert_eq!(order(&part), expected);
    }

    #[test]
    fn a_search_around_a_box_finds_what_brute_force_finds_in_every_dimension() {
        near_a_box_finds_what_brute_force_finds::<1>();
        near_a_box_finds_what_brute_force_finds::<2>();
        near_a_box_finds_what_brute_force_finds::<3>();
    }

    #[test]
    fn a_search_finds_what_brute_force_finds_in_every_dimension() {
        finds_what_brute_force_finds::<1>();
        finds_what_brute_force_finds::<2>();
        finds_what_brute_force_finds::<3>();
    }

    #[test]
    fn an_empty_set_has_no_runs() {
        let pencils = Pencils::<2>::new(&[], 1.0);
        pencils.for_each_run(&Vector::zeros(), &Vector::repeat(1.0), |_| {
            panic!("no run expected")
        });
    }

    #[test]
    fn points_that_are_nowhere_do_no_harm() {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let mut points = scattered::<3>(10);
            points.push(Vector::repeat(bad));
            assert_eq!(Pencils::new(&points, 0.1).order().len(), 11);
            assert_eq!(Pencils::<2>::new(&[Vector::repeat(bad)], 0.1).order(), [0]);
        }
    }

    #[test]
    fn a_far_outlier_does_not_exhaust_memory() {
        let mut points = scattered::<3>(100);
        points.push(Vector::repeat(1e12));
        let pencils = Pencils::new(&points, 0.1);
        assert!(pencils.start.len() < 10_000);
    }
}
