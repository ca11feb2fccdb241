//! What heat conduction does.

use super::{Met, Neighbours, Own, Site};
use crate::each::each;
use crate::lanes::Lane;
use crate::pairs::law::{Law, Neighbour};
use crate::pairs::pair::{LaneVector, dot, dot_add};
use crate::particles::Rates;
use crate::records::Read;
use crate::vectors::Vectors;

/// Heating `1/rho_i [sum_j V_j (q_i L_i + q_j L_j).grad_i W_ij + sum_j V_j 2 kappa_ij d_ij F]` by the flux `q = kappa grad e` [Fourier
/// 1822] with the conductivity `kappa` by energy, and the departure `d_ij = e_ij - 1/2 (grad e_i + grad e_j).r_ij`.
#[derive(Clone, Copy, Debug)]
pub struct HeatFlux;

/// Of the particles `i`: half the gradients of their energies, and half their conductivities.
#[derive(Clone, Copy)]
pub struct Heated<V: Vectors, const D: usize> {
    half_slope: LaneVector<V, D>,
    half_conductivity: Lane<V>,
}

impl<const D: usize> Law<Neighbours<'_, D>, D> for HeatFlux {
    type Own<V: Vectors> = Heated<V, D>;
    /// `sum V_j q_j L_j.grad W + sum V_j 2 kappa d F`.
    type Sums<V: Vectors> = Lane<V>;
    type Number = f64;

    #[inline(always)]
    fn load<V: Vectors>(
        &self,
        vectors: V,
        read: Read<'_, D, V::Number>,
        slot: impl Fn(usize) -> usize + Copy,
    ) -> Self::Own<V> {
        let of = |l: usize| &read.diffusive[slot(l)];
        Heated {
            half_slope: each(|k| Lane::gather(vectors, |l| of(l).half_slope[k])),
            half_conductivity: Lane::gather(vectors, |l| of(l).half_conductivity),
        }
    }

    #[inline(always)]
    fn add<V: Vectors>(
        &self,
        (_, own): (&Own<V, D>, &Self::Own<V>),
        met: &mut Met<V, D>,
        j: Neighbour<'_, V, D>,
        heat: &mut Lane<V>,
    ) {
        let other = &j.read.diffusive[j.slot];
        let lane = |number| Lane::broadcast(j.vectors, number);
        let r = &met.pair.separation;
        let flux: LaneVector<V, D> = each(|k| lane(other.flux[k]));
        let conductivity = own.half_conductivity + lane(other.half_conductivity);
        let exchange = (conductivity + conductivity) * met.gradient_volume;
        let slope: LaneVector<V, D> = each(|k| -(own.half_slope[k] + lane(other.half_slope[k])));
        let apart = dot_add(&slope, r, met.energy);
        *heat = dot(&flux, r).mul_add(met.pair.gradient_factor, *heat);
        *heat = apart.mul_add(exchange, *heat);
    }

    #[inline(always)]
    fn finish(&self, _: f64, heat: f64, site: &mut Site<'_, D>, _: &mut Rates<D>) {
        let own = site.own.flux.dot(&site.volume_gradients[1]) / site.near.volume;
        site.conduction += (own + heat) / site.near.density();
    }
}
