//! One cluster's search for its neighbours.

use std::ops::Range;

use aero_geometry::Vector;
use aero_geometry::kernel::SUPPORT;
use pulp::Simd;

use super::{Candidates, GROWTH, Seeker};
use crate::solver::calm::Calm;
use crate::solver::lanes::Lane;
use crate::solver::records::Near;

/// Support per sum of half smoothing lengths, with room for growth within the step.
const REACH: f64 = SUPPORT * GROWTH;

/// A cluster of seekers, and the box around it in space and in velocity.
pub struct Hull<S: Simd, const D: usize> {
    min: Vector<D>,
    max: Vector<D>,
    velocity: Vector<D>,
    /// Largest difference from `velocity` in the cluster.
    spread: f64,
    positions: [Lane<S>; D],
    /// How far the members see, half of the support.
    reaches: Lane<S>,
    /// The largest of them.
    furthest: f64,
}

impl<S: Simd, const D: usize> Hull<S, D> {
    /// The cluster of the seekers `seeker(l)`, one per lane.
    #[inline(always)]
    pub fn new(simd: S, seeker: impl Fn(usize) -> Seeker<D>) -> Self {
        let first = seeker(0);
        let (mut slowest, mut fastest) = (first.velocity, first.velocity);
        for seeker in (1..S::F64_LANES).map(&seeker) {
            slowest = slowest.inf(&seeker.velocity);
            fastest = fastest.sup(&seeker.velocity);
        }
        let mut hull = Self {
            min: first.position,
            max: first.position,
            velocity: (slowest + fastest) * 0.5,
            spread: 0.0,
            positions: std::array::from_fn(|k| Lane::gather(simd, |l| seeker(l).position[k])),
            reaches: Lane::gather(simd, |l| REACH * seeker(l).half_h),
            furthest: 0.0,
        };
        for seeker in (0..S::F64_LANES).map(seeker) {
            hull.min = hull.min.inf(&seeker.position);
            hull.max = hull.max.sup(&seeker.position);
            hull.furthest = hull.furthest.max(REACH * seeker.half_h);
            hull.spread = hull.spread.max((seeker.velocity - hull.velocity).norm());
        }
        hull
    }

    /// True where the cluster sees nothing but the undisturbed free stream.
    pub fn is_calm(&self, calm: Option<&Calm<D>>) -> bool {
        calm.is_some_and(|calm| calm.covers(&self.min, &self.max))
    }

    /// Appends the members of `set` that any of the cluster may meet until the half-step; `runs`
    /// is scratch.
    #[inline(always)]
    pub fn collect(
        &self,
        simd: S,
        set: &Candidates<'_, D>,
        half_step: f64,
        runs: &mut Vec<Range<usize>>,
        entries: &mut Vec<u32>,
    ) {
        // First the box of all that is near enough at rest, grown by the fastest approach that
        // the velocities allow.
        let approach = half_step * (self.spread + set.fastest_relative_to(&self.velocity));
        let reach = self.furthest + REACH * set.half_h_max + approach;
        // The runs first: within a closure the loop would lose the vector instructions.
        runs.clear();
        let mut most = 0;
        set.pencils
            .for_each_run_near(&self.min, &self.max, reach, |run| {
                most += run.len();
                runs.push(run);
            });
        // Every candidate is written, and overwritten by the next unless it counts: whether it does is too
        // irregular for the processor to guess.
        let mut end = entries.len();
        entries.resize(end + most, 0);
        for run in runs.iter() {
            let first = set.first + run.start;
            for (slot, near) in (first..).zip(&set.near[run.clone()]) {
                let speed = self.spread + longest(&(near.velocity - self.velocity));
                entries[end] = slot as u32;
                let reach = REACH * near.half_h + half_step * speed;
                end += usize::from(self.meets(simd, near, reach));
            }
        }
        entries.truncate(end);
    }

    /// True where any member of the cluster is nearer to the candidate than both see.
    #[inline(always)]
    fn meets(&self, simd: S, near: &Near<D>, reach: f64) -> bool {
        let mut distance = Lane::splat(simd, 0.0);
        for k in 0..D {
            let apart = self.positions[k] - Lane::splat(simd, near.position[k]);
            distance = apart.mul_add(apart, distance);
        }
        let reach = self.reaches + Lane::splat(simd, reach);
        distance.any_less(reach * reach)
    }
}

/// Length of a vector or up to an eighth more, without a root: the mean of the norms of Manhattan and of the
/// largest component. With `a >= b >= c` the square of `a + (b + c) / 2` holds `a^2 + ab + ac`, and more.
#[inline(always)]
fn longest<const D: usize>(vector: &Vector<D>) -> f64 {
    let (mut sum, mut most) = (0.0, 0.0_f64);
    for k in 0..D {
        let size = vector[k].abs();
        sum += size;
        most = most.max(size);
    }
    0.5 * (sum + most)
}
