//! One cluster's search for its neighbours.

use std::ops::Range;

use aero_geometry::Vector;
use pulp::Simd;

use super::rough::{BLOCK, Block, LOSS, Rough};
use super::{Candidates, REACH, Seeker};
use crate::each::each;
use crate::vectors::MAX_LANES;

/// A cluster of seekers, and the box around it in space and in velocity.
pub struct Hull<const D: usize> {
    min: Vector<D>,
    max: Vector<D>,
    velocity: Vector<D>,
    /// Largest difference from `velocity` in the cluster.
    spread: f64,
    /// The largest of the members' reaches.
    furthest: f64,
    members: [Member<D>; MAX_LANES],
    count: usize,
    /// How much single precision may lose of a reach.
    slack: f64,
}

/// A seeker in single precision.
#[derive(Clone, Copy)]
struct Member<const D: usize> {
    position: [f32; D],
    /// How far it sees, half of the support.
    reach: f32,
}

impl<const D: usize> Hull<D> {
    /// The cluster of the seekers `seeker(l)` for `l` below `count`, among records whose copies are `rough`.
    #[inline(always)]
    pub fn new(count: usize, seeker: impl Fn(usize) -> Seeker<D>, rough: &Rough<D>) -> Self {
        let first = seeker(0);
        let (mut slowest, mut fastest) = (first.velocity, first.velocity);
        for seeker in (1..count).map(&seeker) {
            slowest = slowest.inf(&seeker.velocity);
            fastest = fastest.sup(&seeker.velocity);
        }
        let nowhere = Member {
            position: [0.0; D],
            reach: 0.0,
        };
        let mut hull = Self {
            min: first.position,
            max: first.position,
            velocity: (slowest + fastest) * 0.5,
            spread: 0.0,
            furthest: 0.0,
            members: [nowhere; MAX_LANES],
            count,
            slack: 0.0,
        };
        for (member, seeker) in hull.members.iter_mut().zip((0..count).map(seeker)) {
            hull.min = hull.min.inf(&seeker.position);
            hull.max = hull.max.sup(&seeker.position);
            hull.furthest = hull.furthest.max(REACH * seeker.half_h);
            hull.spread = hull.spread.max((seeker.velocity - hull.velocity).norm());
            let place = seeker.position - rough.origin;
            *member = Member {
                position: each(|k| place[k] as f32),
                reach: (REACH * seeker.half_h) as f32,
            };
        }
        let far = (hull.min - rough.origin).abs() + (hull.max - rough.origin).abs();
        hull.slack = LOSS * (far.sum() + hull.furthest);
        hull
    }

    /// Appends the members of `set` that any of the cluster may meet until the half-step; `runs`
    /// is scratch.
    #[inline(always)]
    pub fn collect<S: Simd>(
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
        let reach = self.furthest + set.furthest + approach;
        let slack = self.slack + LOSS * (reach + half_step * self.velocity.norm());
        // The runs first: within a closure the loop would lose the vector instructions.
        runs.clear();
        let mut most = 0;
        set.pencils
            .for_each_run_near(&self.min, &self.max, reach + slack, |run| {
                most += run.len();
                runs.push(set.first + run.start..set.first + run.end);
            });
        let lost = (slack + half_step * self.spread) as f32;
        // Every candidate is written, and overwritten by the next unless it counts: whether it does is too
        // irregular for the processor to guess.
        let mut end = entries.len();
        entries.resize(end + most, 0);
        for run in runs.iter() {
            for number in run.start / BLOCK..run.end.div_ceil(BLOCK) {
                let first = number * BLOCK;
                let beyond = self.beyond(simd, &set.rough.blocks[number], half_step as f32, lost);
                let lanes = run.start.max(first) - first..run.end.min(first + BLOCK) - first;
                for (slot, beyond) in (first + lanes.start..).zip(&beyond[lanes]) {
                    entries[end] = slot as u32;
                    end += usize::from(beyond.is_sign_negative());
                }
            }
        }
        entries.truncate(end);
    }

    /// Negative for each candidate that is nearer to a member of the cluster than both see: the difference of the squares of
    /// distance and reach, the smallest of all members'. `more` adds to every reach.
    #[inline(always)]
    fn beyond<S: Simd>(
        &self,
        simd: S,
        block: &Block<D>,
        half_step: f32,
        more: f32,
    ) -> [f32; BLOCK] {
        let mut beyond = [0.0; BLOCK];
        let (results, _) = S::as_mut_simd_f32s(&mut beyond);
        let (sights, _) = S::as_simd_f32s(&block.sight);
        let positions = block.position.each_ref().map(|x| S::as_simd_f32s(x).0);
        let velocities = block.velocity.each_ref().map(|u| S::as_simd_f32s(u).0);
        let zero = simd.splat_f32s(0.0);
        for (v, result) in results.iter_mut().enumerate() {
            let (mut sum, mut most) = (zero, zero);
            for k in 0..D {
                let mean = simd.splat_f32s(self.velocity[k] as f32);
                let size = simd.abs_f32s(simd.sub_f32s(velocities[k][v], mean));
                sum = simd.add_f32s(sum, size);
                most = simd.max_f32s(most, size);
            }
            // The length of the difference of velocities, or up to an eighth more, without a root: the mean of the
            // norms of Manhattan and of the largest component. With `a >= b >= c` the square of `a + (b + c) / 2` holds
            // `a^2 + ab + ac`, and more.
            let speed = simd.add_f32s(sum, most);
            let sight = simd.add_f32s(sights[v], simd.splat_f32s(more));
            let sight = simd.mul_add_e_f32s(speed, simd.splat_f32s(0.5 * half_step), sight);
            let mut least = simd.splat_f32s(f32::INFINITY);
            for member in &self.members[..self.count] {
                let mut square = zero;
                for k in 0..D {
                    let apart = simd.sub_f32s(positions[k][v], simd.splat_f32s(member.position[k]));
                    square = simd.mul_add_e_f32s(apart, apart, square);
                }
                let reach = simd.add_f32s(sight, simd.splat_f32s(member.reach));
                let excess = simd.negate_mul_add_e_f32s(reach, reach, square);
                least = simd.min_f32s(least, excess);
            }
            *result = least;
        }
        beyond
    }
}
