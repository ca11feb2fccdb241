//! Density read off the particles.

use rayon::prelude::*;

use super::super::lanes::Lane;
use super::super::neighbours::{Chunk, Lists};
use super::super::records::{Near, Number, Records};
use super::super::vectors::{Arch, MAX_LANES, Pass, Vectors};
use super::{Separation, Target, kernel_value};

/// The walls' share of the kernel is never taken above this, so that a particle squeezed among
/// ghosts keeps a finite density.
const LARGEST_WALL_SHARE: f64 = 0.7;

/// Density of each particle by summation, `rho_i = sum_gas m_j W_ij / (1 - phi_i)`, where
/// `phi_i = sum_ghosts V_g W_ig` is the walls' share of the kernel. Writes one density per
/// listed particle; `lattice` is the same sum over a perfect lattice of unit density.
pub fn densities<const D: usize>(
    arch: Arch,
    lists: &Lists,
    records: &Records<D>,
    lattice: f64,
    densities: &mut [f64],
) {
    lists
        .chunks
        .par_iter()
        .zip(densities.par_chunks_mut(lists.chunk_targets()))
        .for_each(|(chunk, densities)| {
            arch.dispatch(Summation {
                chunk,
                records,
                lattice,
                densities,
            });
        });
}

struct Summation<'a, const D: usize> {
    chunk: &'a Chunk,
    records: &'a Records<D>,
    lattice: f64,
    densities: &'a mut [f64],
}

impl<const D: usize> Pass for Summation<'_, D> {
    type Output = ();

    #[inline(always)]
    fn run<V: Vectors>(self, vectors: V) {
        let near = V::Number::of(self.records).near;
        let mut results = self.densities.iter_mut();
        for cluster in &self.chunk.clusters {
            let last = cluster.targets.end - 1;
            let first = cluster.targets.start;
            if cluster.is_calm {
                for i in cluster.targets.clone() {
                    if let Some(density) = results.next() {
                        *density = self.records.near[i].density();
                    }
                }
                continue;
            }
            let target = Target::load(vectors, |l| &near[(first + l).min(last)]);
            let mass: [f64; MAX_LANES] = {
                let mut sum = Lane::splat(vectors, 0.0);
                for &j in &self.chunk.entries[cluster.gas.clone()] {
                    let j = &near[j as usize];
                    sum = weight(vectors, &target, j).mul_add(Lane::splat(vectors, j.mass), sum);
                }
                sum.to_array()
            };
            let share: [f64; MAX_LANES] = {
                let mut sum = Lane::splat(vectors, 0.0);
                for &j in &self.chunk.entries[cluster.wall.clone()] {
                    let j = &near[j as usize];
                    sum = weight(vectors, &target, j).mul_add(Lane::splat(vectors, j.volume), sum);
                }
                sum.to_array()
            };
            for (l, density) in results.by_ref().take(cluster.targets.len()).enumerate() {
                let share = (share[l] / self.lattice).min(LARGEST_WALL_SHARE);
                *density = mass[l] / self.lattice / (1.0 - share);
            }
        }
    }
}

#[inline(always)]
fn weight<V: Vectors, const D: usize>(
    vectors: V,
    i: &Target<V, D>,
    j: &Near<D, V::Number>,
) -> Lane<V> {
    let separation = Separation::new(vectors, i, j);
    let roots = separation.squared.roots(separation.h);
    kernel_value::<V, D>(vectors, roots.root, roots.inverse_other)
}
