//! Density read off the particles.

use super::law::{Basis, Law, Neighbour};
use super::pair::{LaneVector, Separation, Target, dot};
use super::unlike::{share, unlike};
use crate::backend::Backend;
use crate::each::each;
use crate::lanes::Lane;
use crate::neighbours::Lists;
use crate::records::{Read, Records};
use crate::vectors::Vectors;

/// The walls' share of the kernel is never taken above this, so that a particle squeezed among
/// ghosts keeps a finite density.
const LARGEST_WALL_SHARE: f64 = 0.7;

/// Density of each particle by summation. Writes one density per
/// listed particle; `lattice` is the same sum over a perfect lattice of unit density.
pub fn densities<const D: usize>(
    backend: &impl Backend,
    lists: &Lists,
    records: &Records<D>,
    lattice: f64,
    densities: &mut [f64],
) {
    let (kernels, law) = (
        Kernels { records },
        Summation {
            lattice,
            second: &records.second,
        },
    );
    backend.sweep(lists, records, &kernels, &law, densities);
}

/// Values of the kernel at the neighbours.
struct Kernels<'a, const D: usize> {
    records: &'a Records<D>,
}

/// `rho_i = [sum_gas m_j W_ij + sum_ghosts V_g s_g.r_gi W_ig] / (1 - phi_i)`, where `phi_i = sum_ghosts V_g W_ig` is the walls' share of the
/// kernel and `s_g` the gradient of the density across the layer at the wall: gas on one side alone is as dense as it is beside the particle, not
/// as at it. A particle of another gas
/// counts by the room that it takes, as one of its own: `m_i` in place of `m_j` [Hu & Adams 2006, eq. 6], so that no gas is spread into
/// the other.
struct Summation<'a> {
    lattice: f64,
    /// Share of the second gas in each; empty where there is one.
    second: &'a [f64],
}

impl<const D: usize> Basis<D> for Kernels<'_, D> {
    type Own<V: Vectors> = Target<V, D>;
    /// The kernel and `r_ij`.
    type Pair<V: Vectors> = (Lane<V>, LaneVector<V, D>);
    type Site<'a>
        = ()
    where
        Self: 'a;
    type Result = f64;

    #[inline(always)]
    fn load<V: Vectors>(
        &self,
        vectors: V,
        read: Read<'_, D, V::Number>,
        slot: impl Fn(usize) -> usize,
    ) -> Target<V, D> {
        Target::load(vectors, read, slot)
    }

    #[inline(always)]
    fn meet<V: Vectors>(
        &self,
        vectors: V,
        own: &Target<V, D>,
        read: Read<'_, D, V::Number>,
        j: usize,
    ) -> Self::Pair<V> {
        let separation = Separation::new(vectors, own, &read.near[j]);
        (separation.kernel(vectors), separation.vector)
    }

    fn rest(&self, slot: usize, density: &mut f64) {
        *density = self.records.near[slot].density();
    }

    #[inline(always)]
    fn open(&self, _: usize, _: &mut f64) {}

    #[inline(always)]
    fn close(&self, (): (), _: &mut f64) {}
}

impl<const D: usize> Law<Kernels<'_, D>, D> for Summation<'_> {
    /// Share of the second gas, and mass.
    type Own<V: Vectors> = (Lane<V>, Lane<V>);
    /// Mass of the gas, share of the walls, and half of what the density lacks there.
    type Sums<V: Vectors> = (Lane<V>, (Lane<V>, Lane<V>));
    type Number = (f64, (f64, f64));

    #[inline(always)]
    fn load<V: Vectors>(
        &self,
        vectors: V,
        read: Read<'_, D, V::Number>,
        slot: impl Fn(usize) -> usize + Copy,
    ) -> Self::Own<V> {
        if self.second.is_empty() {
            return (Lane::splat(vectors, 0.0), Lane::splat(vectors, 0.0));
        }
        let mass = Lane::gather(vectors, |l| read.near[slot(l)].mass);
        (share(vectors, self.second, slot), mass)
    }

    #[inline(always)]
    fn add<V: Vectors>(
        &self,
        (_, (own_share, own)): (&Target<V, D>, &Self::Own<V>),
        (kernel, _): &mut (Lane<V>, LaneVector<V, D>),
        j: Neighbour<'_, V, D>,
        (mass, _): &mut Self::Sums<V>,
    ) {
        let near = &j.read.near[j.slot];
        let mut theirs = Lane::broadcast(j.vectors, near.mass);
        if let Some(&second) = self.second.get(j.slot) {
            theirs += unlike(j.vectors, *own_share, second) * (*own - theirs);
        }
        *mass = kernel.mul_add(theirs, *mass);
    }

    #[inline(always)]
    fn add_ghost<V: Vectors>(
        &self,
        _: (&Target<V, D>, &Self::Own<V>),
        (kernel, separation): &mut (Lane<V>, LaneVector<V, D>),
        j: Neighbour<'_, V, D>,
        (_, (share, fall)): &mut Self::Sums<V>,
    ) {
        let volume = Lane::broadcast(j.vectors, j.read.near[j.slot].volume);
        let state = &j.read.state[j.slot];
        let slope: LaneVector<V, D> = each(|k| Lane::broadcast(j.vectors, state.half_gradient[k]));
        *fall = (*kernel * volume).mul_add(dot(&slope, separation), *fall);
        *share = kernel.mul_add(volume, *share);
    }

    /// Masses and volumes are in the cubes of the records' lengths, kernels in those of the inverse.
    #[inline(always)]
    fn in_metres<V: Vectors>(&self, sums: Self::Sums<V>, _: Lane<V>) -> Self::Sums<V> {
        sums
    }

    #[inline(always)]
    fn finish(
        &self,
        _: Self::Number,
        (mass, (share, fall)): Self::Number,
        (): &mut (),
        density: &mut f64,
    ) {
        let share = (share / self.lattice).min(LARGEST_WALL_SHARE);
        let mass = (mass - 2.0 * fall).clamp(0.5 * mass, 2.0 * mass);
        *density = mass / self.lattice / (1.0 - share);
    }
}
