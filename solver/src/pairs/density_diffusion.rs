//! Diffusion of density, the "delta" of delta-SPH.

use super::encounter::{Encounter, Encounters, Own, Site};
use super::law::{Law, Neighbour};
use super::pair::{LaneVector, dot_add};
use crate::each::each;
use crate::lanes::Lane;
use crate::particles::Rates;
use crate::records::Read;
use crate::vectors::Vectors;

/// Coefficient (Antuono et al. 2010; Villodi & Ramachandran 2024, below eq. 10).
pub const DELTA: f64 = 0.1;

/// What the sum of all [`diffusion`] is to be multiplied with: `r_ji.grad_i W_ij / r_ij^2` is `-F`.
pub const DIFFUSION: f64 = -2.0 * DELTA;

/// `delta c_ij h_ij D_ij.grad_i W_ij` over [`DIFFUSION`], with `D_ij = 2 r_ji / r_ij^2 [(rho_j - rho_i) -
/// (g_i + g_j).r_ji / 2]`, weighed by `m_j / rho_j` [Villodi & Ramachandran 2024, eqs 10-11]; within the gas only.
#[derive(Clone, Copy, Debug)]
pub struct DensityDiffusion;

impl<const D: usize> Law<Encounters<'_, D>, D> for DensityDiffusion {
    type Own<V: Vectors> = LaneVector<V, D>;
    type Sums<V: Vectors> = Lane<V>;
    type Number = f64;

    #[inline(always)]
    fn load<V: Vectors>(
        &self,
        vectors: V,
        read: Read<'_, D, V::Number>,
        slot: impl Fn(usize) -> usize + Copy,
    ) -> Self::Own<V> {
        each(|k| Lane::gather(vectors, |l| read.state[slot(l)].half_gradient[k]))
    }

    #[inline(always)]
    fn add<V: Vectors>(
        &self,
        (own, half_gradient): (&Own<V, D>, &Self::Own<V>),
        met: &mut Encounter<V, D>,
        j: Neighbour<'_, V, D>,
        sum: &mut Self::Sums<V>,
    ) {
        let (near, state) = (&j.read.near[j.slot], &j.read.state[j.slot]);
        let slopes: LaneVector<V, D> =
            each(|k| half_gradient[k] + Lane::broadcast(j.vectors, state.half_gradient[k]));
        let rise = Lane::broadcast(j.vectors, near.half_density) - own.target.half_density;
        let deviation = dot_add(&slopes, &met.pair.separation, rise + rise);
        *sum = (met.sound * met.reach * deviation).mul_add(met.volume, *sum);
    }

    #[inline(always)]
    fn add_ghost<V: Vectors>(
        &self,
        _: (&Own<V, D>, &Self::Own<V>),
        _: &mut Encounter<V, D>,
        _: Neighbour<'_, V, D>,
        _: &mut Self::Sums<V>,
    ) {
    }

    #[inline(always)]
    fn finish(
        &self,
        _: Self::Number,
        all: Self::Number,
        _: &mut Site<'_, D>,
        rates: &mut Rates<D>,
    ) {
        rates.density += DIFFUSION * all;
    }
}
