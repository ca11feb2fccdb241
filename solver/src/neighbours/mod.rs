//! Neighbour lists, one per cluster of particles that the processor treats at once.
//!
//! A list is built once per step. It holds every pair that can come within the kernel's support
//! up to the half-step evaluation, in both directions, so that no pair is seen from one side
//! only: that keeps the pair sums conservative to round-off.

use std::ops::Range;

use aero_geometry::Vector;
use aero_geometry::kernel::SUPPORT;
use aero_geometry::parallel::prelude::*;
use pulp::{Simd, WithSimd};

mod buffers;
mod candidates;
mod hull;
mod restrict;
mod rough;

use buffers::Chunk;
pub use buffers::Lists;
pub use candidates::Candidates;
use hull::Hull;
pub use rough::Rough;

use super::vectors::{Arch, dispatch};

/// A smoothing length may grow by this factor in one step; the lists allow for it.
pub const GROWTH: f64 = 1.03;

/// Support per sum of half smoothing lengths, with room for growth within the step.
const REACH: f64 = SUPPORT * GROWTH;

/// Clusters per parallel task.
const CLUSTERS_PER_CHUNK: usize = 32;

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

/// What the members of a cluster have in common.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Kind {
    /// Level of smoothing lengths, each of which is sorted by itself.
    pub level: u8,
    /// Needs no neighbours: all sums are zero.
    pub is_calm: bool,
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
    /// Nothing but the undisturbed free stream: no neighbours are listed, and all sums are zero.
    pub is_calm: bool,
}

/// Clusters one after the other, and the entries of all lists.
#[derive(Clone, Copy, Debug)]
pub struct Run<'a> {
    /// Clusters in order.
    pub clusters: &'a [Cluster],
    /// Slots of neighbours.
    pub entries: &'a [u32],
}

impl Lists {
    /// Number of particles per run.
    pub fn run_targets(&self) -> usize {
        self.lanes.max(1) * CLUSTERS_PER_CHUNK
    }

    /// Runs of clusters in order; each serves [`Lists::run_targets`] particles, the last one fewer.
    pub fn par_runs(&self) -> impl Parallel<Item = Run<'_>> {
        self.runs.par_windows(2).map(|ends| self.run_of(ends))
    }

    /// All clusters, as one run.
    pub fn all(&self) -> Run<'_> {
        Run {
            clusters: &self.clusters,
            entries: &self.entries,
        }
    }

    /// The cluster of target `number`; none where nothing is listed.
    pub fn cluster_of(&self, number: usize) -> Option<&Cluster> {
        let place = self
            .clusters
            .partition_point(|cluster| cluster.targets.end <= number);
        self.clusters.get(place)
    }

    fn run_of(&self, ends: &[usize]) -> Run<'_> {
        Run {
            clusters: &self.clusters[ends[0]..ends[1]],
            entries: &self.entries,
        }
    }

    /// Lists the neighbours of `count` seekers in clusters as wide as the processor's vectors,
    /// for a step whose half is at most `half_step` long. Clusters end where the `kind` of a particle is another; around calm
    /// ones nothing is listed.
    pub fn build<const D: usize>(
        &mut self,
        arch: Arch,
        count: usize,
        seeker: impl Fn(usize) -> Seeker<D> + Sync,
        sets: &[Candidates<'_, D>],
        half_step: f64,
        kind: impl Fn(usize) -> Kind + Sync,
    ) {
        let Some(rough) = sets.first().map(|set| set.rough) else {
            self.assemble(0, |_, _| {});
            return;
        };
        self.lanes = arch.lanes();
        let lanes = self.lanes;
        let per_run = self.run_targets();
        self.assemble(count.div_ceil(per_run), |number, chunk| {
            let targets = number * per_run..count.min((number + 1) * per_run);
            dispatch(
                arch.instructions,
                Build {
                    lanes,
                    chunk,
                    targets,
                    seeker: &seeker,
                    sets,
                    rough,
                    half_step,
                    kind: &kind,
                },
            );
        });
    }
}

/// Fills one chunk.
struct Build<'a, F, K, const D: usize> {
    lanes: usize,
    chunk: &'a mut Chunk,
    targets: Range<usize>,
    seeker: &'a F,
    sets: &'a [Candidates<'a, D>],
    rough: &'a Rough<D>,
    half_step: f64,
    kind: &'a K,
}

impl<F, K, const D: usize> WithSimd for Build<'_, F, K, D>
where
    F: Fn(usize) -> Seeker<D>,
    K: Fn(usize) -> Kind,
{
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Chunk { entries, clusters } = self.chunk;
        entries.clear();
        clusters.clear();
        let mut runs = Vec::new();
        let mut start = self.targets.start;
        let mut full = start;
        while start < self.targets.end {
            if start == full {
                full = self.targets.end.min(start + self.lanes);
            }
            let kind = (self.kind)(start);
            let end = (start + 1..full).find(|&i| (self.kind)(i) != kind);
            let targets = start..end.unwrap_or(full);
            let first = start;
            start = targets.end;
            let begin = entries.len();
            let is_calm = kind.is_calm;
            if is_calm {
                let (gas, wall) = (begin..begin, begin..begin);
                clusters.push(Cluster {
                    targets,
                    gas,
                    wall,
                    is_calm,
                });
                continue;
            }
            let hull = Hull::new(targets.len(), |l| (self.seeker)(first + l), self.rough);
            for set in self.sets.iter().filter(|set| !set.is_wall()) {
                hull.collect(simd, set, self.half_step, &mut runs, entries);
            }
            let middle = entries.len();
            for set in self.sets.iter().filter(|set| set.is_wall()) {
                hull.collect(simd, set, self.half_step, &mut runs, entries);
            }
            let (gas, wall) = (begin..middle, middle..entries.len());
            clusters.push(Cluster {
                targets,
                gas,
                wall,
                is_calm,
            });
        }
    }
}
