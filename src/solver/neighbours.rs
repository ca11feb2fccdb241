//! Neighbour lists, one per cluster of particles that the processor treats at once.
//!
//! A list is built once per step. It holds every pair that can come within the kernel's support
//! up to the half-step evaluation, in both directions, so that no pair is seen from one side
//! only: that keeps the pair sums conservative to round-off.

use std::ops::Range;

use aero_geometry::kernel::SUPPORT;
use aero_geometry::{Bounds, Pencils, Vector};
use rayon::prelude::*;

use super::records::{GHOSTS, Near, Records, State};

/// A smoothing length may grow by this factor in one step; the lists allow for it.
pub const GROWTH: f64 = 1.03;

/// Clusters per parallel task.
const CLUSTERS_PER_CHUNK: usize = 32;

/// A set of particles that can be neighbours.
#[derive(Clone, Copy, Debug)]
pub struct Candidates<'a, const D: usize> {
    pencils: &'a Pencils<D>,
    /// First slot in the records.
    first: usize,
    near: &'a [Near<D>],
    state: &'a [State<D>],
    half_h_max: f64,
    velocity: Bounds<D>,
    /// Ghosts, listed after the gas.
    wall: bool,
}

impl<'a, const D: usize> Candidates<'a, D> {
    /// The particles of one segment of `records`, sorted by `pencils`.
    pub fn new(pencils: &'a Pencils<D>, records: &'a Records<D>, segment: usize) -> Self {
        let slots = records.segment(segment);
        let near = &records.near[slots.clone()];
        let state = &records.state[slots.clone()];
        let nowhere = Vector::<D>::repeat(f64::INFINITY);
        let mut velocity = Bounds::new(nowhere, -nowhere);
        for state in state {
            velocity.min = velocity.min.inf(&state.velocity);
            velocity.max = velocity.max.sup(&state.velocity);
        }
        let half_h_max = near
            .iter()
            .fold(0.0, |most: f64, near| most.max(near.half_h));
        Self {
            pencils,
            first: slots.start,
            near,
            state,
            half_h_max,
            velocity,
            wall: segment >= GHOSTS,
        }
    }

    /// True of ghosts.
    pub fn is_wall(&self) -> bool {
        self.wall
    }

    /// Upper bound of the speed of any member relative to `velocity`.
    fn fastest_relative_to(&self, velocity: &Vector<D>) -> f64 {
        let below = (velocity - self.velocity.min).abs();
        let above = (self.velocity.max - velocity).abs();
        below.sup(&above).norm()
    }
}

/// A particle, or a mirror point, that looks for neighbours.
#[derive(Clone, Copy, Debug)]
pub struct Seeker<const D: usize> {
    /// Position.
    pub position: Vector<D>,
    /// Half the smoothing length.
    pub half_h: f64,
    /// Velocity.
    pub velocity: Vector<D>,
}

/// The neighbours of one cluster, as ranges of its chunk's entries.
#[derive(Clone, Debug)]
pub struct Cluster {
    /// The cluster's particles.
    pub targets: Range<usize>,
    /// Neighbours in the gas.
    pub gas: Range<usize>,
    /// Neighbours among the ghosts.
    pub wall: Range<usize>,
}

/// Neighbour lists of a run of clusters.
#[derive(Clone, Debug, Default)]
pub struct Chunk {
    /// Slots of neighbours, cluster after cluster.
    pub entries: Vec<u32>,
    /// Clusters in order.
    pub clusters: Vec<Cluster>,
}

/// Neighbour lists of all clusters.
#[derive(Clone, Debug, Default)]
pub struct Lists {
    /// Chunks in order; each serves [`Lists::chunk_targets`] particles, the last one fewer.
    pub chunks: Vec<Chunk>,
    lanes: usize,
}

impl Lists {
    /// Number of particles per chunk.
    pub fn chunk_targets(&self) -> usize {
        self.lanes.max(1) * CLUSTERS_PER_CHUNK
    }

    /// Lists the neighbours of `count` seekers in clusters of `lanes`, for a step whose half is
    /// at most `half_step` long.
    pub fn build<const D: usize>(
        &mut self,
        lanes: usize,
        count: usize,
        seeker: impl Fn(usize) -> Seeker<D> + Sync,
        sets: &[Candidates<'_, D>],
        half_step: f64,
    ) {
        self.lanes = lanes;
        let per_chunk = self.chunk_targets();
        self.chunks
            .resize_with(count.div_ceil(per_chunk), Chunk::default);
        self.chunks
            .par_iter_mut()
            .enumerate()
            .for_each(|(number, chunk)| {
                let first = number * per_chunk;
                chunk.entries.clear();
                chunk.clusters.clear();
                let mut seekers = Vec::with_capacity(lanes);
                for start in (first..count.min(first + per_chunk)).step_by(lanes) {
                    let targets = start..count.min(start + lanes);
                    seekers.clear();
                    seekers.extend(targets.clone().map(&seeker));
                    let hull = Hull::new(&seekers);
                    let begin = chunk.entries.len();
                    for set in sets.iter().filter(|set| !set.wall) {
                        hull.collect(&seekers, set, half_step, &mut chunk.entries);
                    }
                    let middle = chunk.entries.len();
                    for set in sets.iter().filter(|set| set.wall) {
                        hull.collect(&seekers, set, half_step, &mut chunk.entries);
                    }
                    let end = chunk.entries.len();
                    chunk.clusters.push(Cluster {
                        targets,
                        gas: begin..middle,
                        wall: middle..end,
                    });
                }
            });
    }
}

/// Box around a cluster, in space and in velocity.
struct Hull<const D: usize> {
    min: Vector<D>,
    max: Vector<D>,
    half_h: f64,
    velocity: Vector<D>,
    /// Largest difference from `velocity` in the cluster.
    spread: f64,
}

impl<const D: usize> Hull<D> {
    fn new(seekers: &[Seeker<D>]) -> Self {
        let mut hull = Self {
            min: seekers[0].position,
            max: seekers[0].position,
            half_h: 0.0,
            velocity: seekers[0].velocity,
            spread: 0.0,
        };
        for seeker in seekers {
            hull.min = hull.min.inf(&seeker.position);
            hull.max = hull.max.sup(&seeker.position);
            hull.half_h = hull.half_h.max(seeker.half_h);
            hull.spread = hull.spread.max((seeker.velocity - hull.velocity).norm());
        }
        hull
    }

    fn collect(
        &self,
        seekers: &[Seeker<D>],
        set: &Candidates<'_, D>,
        half_step: f64,
        entries: &mut Vec<u32>,
    ) {
        const REACH: f64 = SUPPORT * GROWTH;
        // First the box of all that is near enough at rest, grown by the fastest approach that
        // the neighbouring velocities allow.
        let reach = REACH * (self.half_h + set.half_h_max) + half_step * self.spread;
        let reach = reach + half_step * set.fastest_relative_to(&self.velocity);
        set.pencils.for_each_run(
            &self.min.add_scalar(-reach),
            &self.max.add_scalar(reach),
            |run| {
                for slot in run {
                    let near = &set.near[slot];
                    let state = &set.state[slot];
                    let outside = near.position - near.position.sup(&self.min).inf(&self.max);
                    let approach =
                        half_step * ((state.velocity - self.velocity).norm() + self.spread);
                    let reach = REACH * (self.half_h + near.half_h) + approach;
                    if outside.norm_squared() < reach * reach
                        && seekers.iter().any(|seeker| {
                            let approach = half_step * (state.velocity - seeker.velocity).norm();
                            let reach = REACH * (seeker.half_h + near.half_h) + approach;
                            (seeker.position - near.position).norm_squared() < reach * reach
                        })
                    {
                        entries.push((set.first + slot) as u32);
                    }
                }
            },
        );
    }
}
