//! Where the passes over pairs are done: on the processor, in its vectors.

use aero_geometry::parallel::prelude::*;

use crate::lanes::Lane;
use crate::neighbours::{Lists, Run};
use crate::pairs::law::{Basis, Law, Neighbour};
use crate::pairs::sum::Sum;
use crate::records::{Kept, Records};
use crate::vectors::{Arch, Pass, Vectors};

/// Something that passes over all pairs of a list.
pub trait Backend {
    /// Sums `laws` over the neighbours of each listed particle and writes what `basis` and they make of the sums.
    fn sweep<B: Basis<D>, L: Law<B, D>, const D: usize>(
        &self,
        lists: &Lists,
        records: &Records<D>,
        basis: &B,
        laws: &L,
        results: &mut [B::Result],
    );

    /// The same in `f64`, whatever the precision.
    fn sweep_in_double<B: Basis<D>, L: Law<B, D>, const D: usize>(
        &self,
        lists: &Lists,
        records: &Records<D>,
        basis: &B,
        laws: &L,
        results: &mut [B::Result],
    );
}

impl Backend for Arch {
    fn sweep<B: Basis<D>, L: Law<B, D>, const D: usize>(
        &self,
        lists: &Lists,
        records: &Records<D>,
        basis: &B,
        laws: &L,
        results: &mut [B::Result],
    ) {
        each_run(lists, results, |run, results| {
            self.dispatch(Sweep {
                run,
                records,
                basis,
                laws,
                results,
            });
        });
    }

    fn sweep_in_double<B: Basis<D>, L: Law<B, D>, const D: usize>(
        &self,
        lists: &Lists,
        records: &Records<D>,
        basis: &B,
        laws: &L,
        results: &mut [B::Result],
    ) {
        each_run(lists, results, |run, results| {
            self.dispatch_double(Sweep {
                run,
                records,
                basis,
                laws,
                results,
            });
        });
    }
}

/// Does `work` with each run of clusters and their results, in parallel.
fn each_run<R: Send>(
    lists: &Lists,
    results: &mut [R],
    work: impl Fn(Run<'_>, &mut [R]) + Sync + Send,
) {
    lists
        .par_runs()
        .zip(results.par_chunks_mut(lists.run_targets()))
        .for_each(|(run, results)| work(run, results));
}

/// A pass over one run of clusters.
struct Sweep<'a, B: Basis<D>, L, const D: usize> {
    run: Run<'a>,
    records: &'a Records<D>,
    basis: &'a B,
    laws: &'a L,
    results: &'a mut [B::Result],
}

impl<B: Basis<D>, L: Law<B, D>, const D: usize> Pass for Sweep<'_, B, L, D> {
    type Output = ();

    #[inline(always)]
    fn run<V: Vectors>(self, vectors: V) {
        let Self {
            run,
            records,
            basis,
            laws,
            results,
        } = self;
        let read = V::Number::of(records);
        let per_length = Lane::splat(vectors, read.per_length);
        let first = basis.first();
        let mut results = results.iter_mut();
        for cluster in run.clusters {
            let slots = first + cluster.targets.start..first + cluster.targets.end;
            let results = slots.clone().zip(results.by_ref());
            if cluster.is_calm {
                results.for_each(|(slot, result)| basis.rest(slot, result));
                continue;
            }
            let (start, last) = (slots.start, slots.end - 1);
            let slot = |l: usize| (start + l).min(last);
            let own = basis.load(vectors, read, slot);
            let laws_own = laws.load(vectors, read, slot);
            let mut sums = L::Sums::zero(vectors);
            for &j in &run.entries[cluster.gas.clone()] {
                let slot = j as usize;
                let mut pair = basis.meet(vectors, &own, read, slot);
                let j = Neighbour {
                    vectors,
                    read,
                    slot,
                };
                laws.add((&own, &laws_own), &mut pair, j, &mut sums);
            }
            let gas = laws.in_metres(sums, per_length).lanes();
            for &j in &run.entries[cluster.wall.clone()] {
                let slot = j as usize;
                let mut pair = basis.meet(vectors, &own, read, slot);
                let j = Neighbour {
                    vectors,
                    read,
                    slot,
                };
                laws.add_ghost((&own, &laws_own), &mut pair, j, &mut sums);
            }
            // Most clusters are far from walls: their sums need not be read off the lanes twice.
            let with_walls =
                (!cluster.wall.is_empty()).then(|| laws.in_metres(sums, per_length).lanes());
            let all = with_walls.as_ref().unwrap_or(&gas);
            for (l, (slot, result)) in results.enumerate() {
                let mut site = basis.open(slot, result);
                let (gas, all) = (L::Sums::number(&gas, l), L::Sums::number(all, l));
                laws.finish(gas, all, &mut site, result);
                basis.close(site, result);
            }
        }
    }
}
