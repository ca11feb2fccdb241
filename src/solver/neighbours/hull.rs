//! One cluster's search for its neighbours.

use std::ops::Range;

use aero_geometry::Vector;
use aero_geometry::kernel::SUPPORT;
use pulp::Simd;

use super::{Candidates, GROWTH, Seeker};
use crate::solver::lanes::Lane;
use crate::solver::records::Near;

/// Support per sum of half smoothing lengths, with room for growth within the step.
const REACH: f64 = SUPPORT * GROWTH;

/// A cluster of seekers, and the box around it in space and in velocity.
pub struct Hull<S: Simd, const D: usize> {
    min: Vector<D>,
    max: Vector<D>,
    half_h: f64,
    velocity: Vector<D>,
    /// Largest difference from `velocity` in the cluster.
    spread: f64,
    positions: [Lane<S>; D],
    velocities: [Lane<S>; D],
    half_hs: Lane<S>,
}

impl<S: Simd, const D: usize> Hull<S, D> {
    /// The cluster of the seekers `seeker(l)`, one per lane.
    #[inline(always)]
    pub fn new(simd: S, seeker: impl Fn(usize) -> Seeker<D>) -> Self {
        let first = seeker(0);
        let mut hull = Self {
            min: first.position,
            max: first.position,
            half_h: 0.0,
            velocity: first.velocity,
            spread: 0.0,
            positions: std::array::from_fn(|k| Lane::gather(simd, |l| seeker(l).position[k])),
            velocities: std::array::from_fn(|k| Lane::gather(simd, |l| seeker(l).velocity[k])),
            half_hs: Lane::gather(simd, |l| seeker(l).half_h),
        };
        for seeker in (0..S::F64_LANES).map(seeker) {
            hull.min = hull.min.inf(&seeker.position);
            hull.max = hull.max.sup(&seeker.position);
            hull.half_h = hull.half_h.max(seeker.half_h);
            hull.spread = hull.spread.max((seeker.velocity - hull.velocity).norm());
        }
        hull
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
        let reach = REACH * (self.half_h + set.half_h_max) + approach;
        let half_step = Lane::splat(simd, half_step);
        // The runs first: within a closure the loop would lose the vector instructions.
        runs.clear();
        let mut most = 0;
        set.pencils.for_each_run_near(&self.min, &self.max, reach, |run| {
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
                entries[end] = slot as u32;
                end += usize::from(self.meets(simd, near, half_step));
            }
        }
        entries.truncate(end);
    }

    /// True where any member of the cluster may meet the candidate.
    #[inline(always)]
    fn meets(&self, simd: S, near: &Near<D>, half_step: Lane<S>) -> bool {
        let mut distance = Lane::splat(simd, 0.0);
        let mut speed = Lane::splat(simd, 0.0);
        for k in 0..D {
            let apart = self.positions[k] - Lane::splat(simd, near.position[k]);
            distance = apart.mul_add(apart, distance);
            let relative = self.velocities[k] - Lane::splat(simd, near.velocity[k]);
            speed = relative.mul_add(relative, speed);
        }
        let still = Lane::splat(simd, REACH) * (self.half_hs + Lane::splat(simd, near.half_h));
        let reach = speed.sqrt().mul_add(half_step, still);
        distance.any_less(reach * reach)
    }
}
