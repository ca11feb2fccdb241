//! What viscosity does to momentum, and the heat of friction.

use aero_geometry::Vector;

use super::{Met, Neighbours, Own, Site};
use crate::each::each;
use crate::lanes::Lane;
use crate::pairs::law::{Law, Neighbour};
use crate::pairs::pair::{LaneVector, accumulate, dot, dot_add};
use crate::particles::Rates;
use crate::records::Read;
use crate::vectors::Vectors;

/// Acceleration `1/rho_i [sum_j V_j (tau_i L_i + tau_j L_j) grad_i W_ij + sum_j V_j 2 mu_ij d_ij F]` by the [`stress`](crate::diffusive::stress) `tau`, with the
/// departure `d_ij = u_ij - 1/2 (grad u_i + grad u_j) r_ij`, and the heat that its forces take from the motion,
/// `1/rho_i [tau_i : grad u_i - 1/2 sum_j V_j 2 mu_ij d_ij.u_ij F]`.
#[derive(Clone, Copy, Debug)]
pub struct ViscousStress;

/// Of the particles `i`: half their velocity gradients, and half their viscosities.
#[derive(Clone, Copy)]
pub struct Sheared<V: Vectors, const D: usize> {
    half_gradient: [LaneVector<V, D>; D],
    half_viscosity: Lane<V>,
}

impl ViscousStress {
    /// From `sum V_j grad W`, and `sum V_j tau_j L_j grad W` and `sum V_j 2 mu d F`.
    #[inline(always)]
    fn acceleration<const D: usize>(
        site: &Site<'_, D>,
        volume_gradient: &Vector<D>,
        (stress, departure, _): ([f64; D], [f64; D], f64),
    ) -> Vector<D> {
        let own = site.own.stress * volume_gradient / site.near.volume;
        (own + Vector::from(stress) + Vector::from(departure)) / site.near.density()
    }
}

impl<const D: usize> Law<Neighbours<'_, D>, D> for ViscousStress {
    type Own<V: Vectors> = Sheared<V, D>;
    type Sums<V: Vectors> = (LaneVector<V, D>, LaneVector<V, D>, Lane<V>);
    type Number = ([f64; D], [f64; D], f64);

    #[inline(always)]
    fn load<V: Vectors>(
        &self,
        vectors: V,
        read: Read<'_, D, V::Number>,
        slot: impl Fn(usize) -> usize + Copy,
    ) -> Self::Own<V> {
        let of = |l: usize| &read.diffusive[slot(l)];
        Sheared {
            half_gradient: each(|a| {
                each(|b| Lane::gather(vectors, |l| of(l).half_gradient[(a, b)]))
            }),
            half_viscosity: Lane::gather(vectors, |l| of(l).half_viscosity),
        }
    }

    #[inline(always)]
    fn add<V: Vectors>(
        &self,
        (_, own): (&Own<V, D>, &Self::Own<V>),
        met: &mut Met<V, D>,
        j: Neighbour<'_, V, D>,
        (stress, departure, work): &mut Self::Sums<V>,
    ) {
        let other = &j.read.diffusive[j.slot];
        let lane = |number| Lane::broadcast(j.vectors, number);
        let r = &met.pair.separation;
        let viscosity = own.half_viscosity + lane(other.half_viscosity);
        let exchange = (viscosity + viscosity) * met.gradient_volume;
        let mut apart = met.jump;
        for a in 0..D {
            let row: LaneVector<V, D> = each(|b| lane(other.stress[(a, b)]));
            stress[a] = dot(&row, r).mul_add(met.pair.gradient_factor, stress[a]);
            let slope: LaneVector<V, D> =
                each(|b| -(own.half_gradient[a][b] + lane(other.half_gradient[(a, b)])));
            apart[a] = dot_add(&slope, r, met.jump[a]);
        }
        accumulate(departure, exchange, &apart);
        *work = dot(&apart, &met.jump).mul_add(exchange, *work);
    }

    #[inline(always)]
    fn finish(
        &self,
        gas: Self::Number,
        all: Self::Number,
        site: &mut Site<'_, D>,
        _: &mut Rates<D>,
    ) {
        let (.., work) = all;
        let [in_gas, in_all] = site.volume_gradients;
        site.accelerations[0] += Self::acceleration(site, &in_gas, gas);
        site.accelerations[1] += Self::acceleration(site, &in_all, all);
        let friction = site.own.friction(&site.velocity_gradient);
        site.friction += (friction - 0.5 * work) / site.near.density();
    }
}
