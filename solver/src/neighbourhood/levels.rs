//! Particles sorted in space, one level of smoothing lengths after the other: a search reaches as far as the widest of the
//! level that it looks through, so that one wide particle does not widen every search.

use std::ops::Range;

use aero_geometry::kernel::SMOOTHING_RATIO;
use aero_geometry::parallel::prelude::*;
use aero_geometry::{Pencils, Vector};

use crate::neighbours::{Candidates, Rough};
use crate::problem::Problem;

/// Members of the cluster that a pencil is as wide as, whatever the processor's vectors: the order of the particles, and with
/// it that of all sums, is the same on all of them.
const CLUSTER: f64 = 8.0;

/// More levels than any smoothing length asks for.
const MOST_LEVELS: u8 = 16;

/// What the domain says of how particles are sorted.
#[derive(Clone, Copy, Debug)]
pub struct Grid<const D: usize> {
    /// Where cells are counted from.
    pub corner: Vector<D>,
    /// Width of a pencil of the first level: a cluster is then about as wide as long.
    pub width: f64,
    /// Largest smoothing length of the first level; that of each further one is twice as large.
    pub first_level: f64,
}

impl<const D: usize> Grid<D> {
    /// That of `problem`.
    pub fn new(problem: &Problem<D>) -> Self {
        Self {
            corner: problem.domain.bounds.min,
            width: problem.resolution.lattice() * CLUSTER.powf(1.0 / D as f64),
            first_level: 2.0 * SMOOTHING_RATIO * problem.resolution.finest(),
        }
    }

    /// Level of a smoothing length.
    fn level(&self, h: f64) -> u8 {
        let (mut level, mut largest) = (0, self.first_level);
        while h > largest && level + 1 < MOST_LEVELS {
            level += 1;
            largest *= 2.0;
        }
        level
    }
}

/// The order of one set of particles.
#[derive(Clone, Debug, Default)]
pub struct Levels<const D: usize> {
    /// By level; those of levels without particles are empty.
    pencils: Vec<Pencils<D>>,
    order: Vec<u32>,
}

impl<const D: usize> Levels<D> {
    /// Sorts `count` particles: `particle(n)` tells where particle `n` is, and its smoothing length; ties go by `rank`.
    pub fn rebuild(
        &mut self,
        grid: &Grid<D>,
        count: usize,
        particle: impl Fn(usize) -> (Vector<D>, f64) + Sync,
        rank: impl Fn(usize) -> u64 + Sync,
    ) {
        let level = |n: usize| grid.level(particle(n).1);
        let highest = (0..count).into_par_iter().map(level).reduce(|| 0, u8::max);
        let levels = usize::from(highest) + 1;
        self.pencils.resize_with(levels, Pencils::default);
        self.order.clear();
        for (number, pencils) in self.pencils.iter_mut().enumerate() {
            let width = grid.width * f64::from(1_u32 << number);
            if levels == 1 {
                let place = |n| particle(n).0;
                pencils.rebuild_on_grid(&grid.corner, width, count, place, &rank);
                self.order.extend_from_slice(pencils.order());
                break;
            }
            let is_member = |n: &u32| usize::from(level(*n as usize)) == number;
            let members: Vec<u32> = (0..count)
                .into_par_iter()
                .map(|n| n as u32)
                .filter(is_member)
                .collect();
            let place = |m: usize| particle(members[m] as usize).0;
            let rank = |m: usize| rank(members[m] as usize);
            pencils.rebuild_on_grid(&grid.corner, width, members.len(), place, rank);
            let sorted = pencils.order().iter().map(|&m| members[m as usize]);
            self.order.extend(sorted);
        }
    }

    /// Number of the particle at each place.
    pub fn order(&self) -> &[u32] {
        &self.order
    }

    /// Level of the particle at a place.
    pub fn level(&self, place: usize) -> u8 {
        let mut end = 0;
        for (level, pencils) in (0..).zip(&self.pencils) {
            end += pencils.order().len();
            if place < end {
                return level;
            }
        }
        0
    }

    /// Places of each level.
    fn places(&self) -> impl Iterator<Item = (&Pencils<D>, Range<usize>)> {
        self.pencils.iter().scan(0, |end, pencils| {
            let start = *end;
            *end += pencils.order().len();
            Some((pencils, start..*end))
        })
    }

    /// The particles as candidates for neighbours in the gas, level by level, where the first has the slot `first`.
    pub fn candidates<'a>(
        &'a self,
        rough: &'a Rough<D>,
        first: usize,
    ) -> impl Iterator<Item = Candidates<'a, D>> {
        let levels = self.places().filter(|(_, places)| !places.is_empty());
        levels.map(move |(pencils, places)| {
            Candidates::gas(pencils, rough, first + places.start..first + places.end)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_wide_are_sorted_apart_and_nobody_is_lost() {
        let grid = Grid {
            corner: Vector::<2>::zeros(),
            width: 0.3,
            first_level: 1.0,
        };
        let h = |n: usize| [0.5, 1.5, 1.0, 7.0, 0.2, 2.0][n];
        let particle = |n: usize| (Vector::<2>::new(n as f64, 0.0), h(n));
        let mut levels = Levels::default();
        levels.rebuild(&grid, 6, particle, |n| n as u64);
        let found: Vec<u8> = (0..6).map(|place| levels.level(place)).collect();
        assert_eq!(found, [0, 0, 0, 1, 1, 3]);
        let mut order = levels.order().to_vec();
        assert_eq!(order[5], 3);
        order.sort_unstable();
        assert_eq!(order, [0, 1, 2, 3, 4, 5]);
    }
}
