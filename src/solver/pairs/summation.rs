//! Density read off the particles.

use pulp::{Arch, Simd, WithSimd};
use rayon::prelude::*;

use super::super::lanes::{Lane, MAX_LANES};
use super::super::neighbours::{Chunk, Lists};
use super::super::records::Near;
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
    near: &[Near<D>],
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
                near,
                lattice,
                densities,
            });
        });
}

struct Summation<'a, const D: usize> {
    chunk: &'a Chunk,
    near: &'a [Near<D>],
    lattice: f64,
    densities: &'a mut [f64],
}

impl<const D: usize> WithSimd for Summation<'_, D> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let mut results = self.densities.iter_mut();
        for cluster in &self.chunk.clusters {
            let last = cluster.targets.end - 1;
            let first = cluster.targets.start;
            if cluster.is_calm {
                for i in cluster.targets.clone() {
                    if let Some(density) = results.next() {
                        *density = self.near[i].density();
                    }
                }
                continue;
            }
            let target = Target::load(simd, |l| &self.near[(first + l).min(last)]);
            let mass: [f64; MAX_LANES] = {
                let mut sum = Lane::splat(simd, 0.0);
                for &j in &self.chunk.entries[cluster.gas.clone()] {
                    let j = &self.near[j as usize];
                    sum = weight(simd, &target, j).mul_add(Lane::splat(simd, j.mass), sum);
                }
                sum.to_array()
            };
            let share: [f64; MAX_LANES] = {
                let mut sum = Lane::splat(simd, 0.0);
                for &j in &self.chunk.entries[cluster.wall.clone()] {
                    let j = &self.near[j as usize];
                    sum = weight(simd, &target, j).mul_add(Lane::splat(simd, j.volume), sum);
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
fn weight<S: Simd, const D: usize>(simd: S, i: &Target<S, D>, j: &Near<D>) -> Lane<S> {
    let separation = Separation::new(simd, i, j);
    let roots = separation.squared.roots(separation.h);
    kernel_value::<S, D>(simd, roots.root, roots.inverse_other)
}
