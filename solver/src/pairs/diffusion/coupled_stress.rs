//! What viscosity does to momentum, by differences.

use aero_geometry::Vector;

use super::{Met, Neighbours, Own, Site};
use crate::each::each;
use crate::lanes::Lane;
use crate::pairs::law::{Law, Neighbour};
use crate::pairs::pair::{LaneVector, accumulate, dot, dot_add};
use crate::pairs::renormalisation::Renormalisation;
use crate::particles::Rates;
use crate::record::Number;
use crate::records::Read;
use crate::vectors::Vectors;

/// Acceleration `1/rho_i [sum_j V_j (tau_j - tau_i) L_i grad_i W_ij + sum_j V_j 2 mu_ij d_ij F]` [Negi & Ramachandran 2021, eq. 8, of the whole
/// [`stress`](crate::diffusive::stress)], with the departure `d_ij = u_ij - 1/2 (grad u_i + grad u_j) r_ij`, which the first sum is blind to: where nobody
/// knows gradients it is the Laplacian of pairs [Morris, Fox & Zhu 1997, eq. 22]. The records hold `V tau`. No heat.
#[derive(Clone, Copy, Debug)]
pub struct CoupledStress<'a, const D: usize>(pub &'a [Renormalisation<D>]);

/// Of the particles `i`: half their velocity gradients, half their viscosities, their stresses and their renormalisations.
#[derive(Clone, Copy)]
pub struct Sheared<V: Vectors, const D: usize> {
    half_gradient: [LaneVector<V, D>; D],
    half_viscosity: Lane<V>,
    stress: [LaneVector<V, D>; D],
    matrix: [LaneVector<V, D>; D],
}

impl<const D: usize> Law<Neighbours<'_, D>, D> for CoupledStress<'_, D> {
    type Own<V: Vectors> = Sheared<V, D>;
    type Sums<V: Vectors> = LaneVector<V, D>;
    type Number = [f64; D];

    #[inline(always)]
    fn load<V: Vectors>(
        &self,
        vectors: V,
        read: Read<'_, D, V::Number>,
        slot: impl Fn(usize) -> usize + Copy,
    ) -> Self::Own<V> {
        let of = |l: usize| &read.diffusive[slot(l)];
        let per_volume = Lane::gather(vectors, |l| read.near[slot(l)].volume).recip();
        Sheared {
            half_gradient: each(|a| {
                each(|b| Lane::gather(vectors, |l| of(l).half_gradient[(a, b)]))
            }),
            half_viscosity: Lane::gather(vectors, |l| of(l).half_viscosity),
            stress: each(|a| {
                each(|b| Lane::gather(vectors, |l| of(l).stress[(a, b)]) * per_volume)
            }),
            matrix: each(|a| {
                each(|b| {
                    let own = |l: usize| self.0[slot(l)].matrix[(a, b)];
                    Lane::gather(vectors, |l| V::Number::rounded(own(l)))
                })
            }),
        }
    }

    #[inline(always)]
    fn add<V: Vectors>(
        &self,
        (_, own): (&Own<V, D>, &Self::Own<V>),
        met: &mut Met<V, D>,
        j: Neighbour<'_, V, D>,
        sum: &mut Self::Sums<V>,
    ) {
        let other = &j.read.diffusive[j.slot];
        let lane = |number| Lane::broadcast(j.vectors, number);
        let volume = lane(j.read.near[j.slot].volume);
        let r = &met.pair.separation;
        let turned: LaneVector<V, D> = each(|a| dot(&own.matrix[a], r));
        let viscosity = own.half_viscosity + lane(other.half_viscosity);
        let exchange = (viscosity + viscosity) * met.gradient_volume;
        let mut apart = met.jump;
        for a in 0..D {
            let rise: LaneVector<V, D> =
                each(|b| lane(other.stress[(a, b)]) - volume * own.stress[a][b]);
            sum[a] = dot(&rise, &turned).mul_add(met.pair.gradient_factor, sum[a]);
            let slope: LaneVector<V, D> =
                each(|b| -(own.half_gradient[a][b] + lane(other.half_gradient[(a, b)])));
            apart[a] = dot_add(&slope, r, met.jump[a]);
        }
        accumulate(sum, exchange, &apart);
    }

    #[inline(always)]
    fn finish(&self, gas: [f64; D], all: [f64; D], site: &mut Site<'_, D>, _: &mut Rates<D>) {
        let density = site.near.density();
        site.accelerations[0] += Vector::from(gas) / density;
        site.accelerations[1] += Vector::from(all) / density;
    }
}
