//! What shifted particles exchange, so that the flow stays where it was.

use aero_geometry::Vector;

use super::encounter::{Encounter, Encounters, Own, Site};
use super::law::{Law, Neighbour};
use super::pair::{LaneVector, accumulate, dot};
use crate::each::each;
use crate::lanes::Lane;
use crate::particles::Rates;
use crate::records::Read;
use crate::vectors::Vectors;

/// `j` gives its state to `i` where both are shifted, within the gas only, at the rate, over the mass of `i`,
/// `x_ij = (m_j / rho_ij) (s_i - s_j).grad_i W_ij`, with `s` the renormalised shifts.
///
/// `m_i x_ij` is the same from both ends. Velocity and energy that are exchanged in proportion to it,
/// `m_i du_i/dt = sum_j m_i x_ij (u_j - u_i)`, are therefore conserved pair by pair, with masses that stay as they are; the
/// frame of reference does not count, and uniform flow is left alone. In the limit of many neighbours the sum is
/// `(s - <s>).grad u`, `<s>` being the mean shift of the neighbourhood: what varies from particle to particle is
/// taken back, as the advection terms of Oger et al. [2016] and Sun et al. [2019] do, while the mean moves
/// mass, momentum and energy alike.
///
/// The heat `(u_j - u_i)^2 / 2` is half the kinetic energy that the pair loses.
#[derive(Clone, Copy, Debug)]
pub struct Exchange;

impl<const D: usize> Law<Encounters<'_, D>, D> for Exchange {
    type Own<V: Vectors> = LaneVector<V, D>;
    type Sums<V: Vectors> = (Lane<V>, LaneVector<V, D>, Lane<V>);
    type Number = (f64, [f64; D], f64);

    #[inline(always)]
    fn load<V: Vectors>(
        &self,
        vectors: V,
        read: Read<'_, D, V::Number>,
        slot: impl Fn(usize) -> usize + Copy,
    ) -> Self::Own<V> {
        each(|k| Lane::gather(vectors, |l| read.shift[slot(l)][k]))
    }

    #[inline(always)]
    fn add<V: Vectors>(
        &self,
        (own, own_shift): (&Own<V, D>, &Self::Own<V>),
        met: &mut Encounter<V, D>,
        j: Neighbour<'_, V, D>,
        (density, velocity, energy): &mut Self::Sums<V>,
    ) {
        let (near, theirs) = (&j.read.near[j.slot], &j.read.shift[j.slot]);
        let shift: LaneVector<V, D> =
            each(|k| own_shift[k] - Lane::broadcast(j.vectors, theirs[k]));
        let rate = met.pairwise * met.pair.gradient_factor * dot(&shift, &met.pair.separation);
        let half = Lane::splat(j.vectors, 0.5);
        let heat = (half * dot(&met.jump, &met.jump)) + met.energy;
        let half_density = Lane::broadcast(j.vectors, near.half_density);
        *density = rate.mul_add(half_density + own.target.half_density, *density);
        *energy = rate.mul_add(heat, *energy);
        accumulate(velocity, rate, &met.jump);
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
        (density, velocity, energy): Self::Number,
        site: &mut Site<'_, D>,
        rates: &mut Rates<D>,
    ) {
        site.carried += Vector::from(velocity);
        rates.energy += energy;
        // What the sum over the moved particles will read.
        rates.density += density;
    }
}
