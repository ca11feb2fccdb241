//! Artificial conduction of heat, and the heat flux that keeps walls from overheating.

use super::encounter::{Encounter, Encounters, Own, Site};
use super::law::{Law, Neighbour};
use super::pair::{LaneVector, dot};
use crate::each::each;
use crate::lanes::Lane;
use crate::particles::Rates;
use crate::records::Read;
use crate::scheme::Conduction;
use crate::vectors::Vectors;

/// Coefficient (Villodi & Ramachandran 2024, below eq. 14).
pub const KAPPA: f64 = 0.1;

/// Coefficient of the flux in compressed gas: `g_2 = 1` of `g_2 h^2 (|div u| - div u)`, whose bracket is twice
/// the rate of compression (Fulk 1994; Monaghan 1995; Liu & Liu 2003, eq. 4.74).
const COMPRESSED: f64 = 2.0;

/// What the sum of all exchanges is to be multiplied with: `r_ji.grad_i W_ij / r_ij^2` is `-F`.
///
/// An exchange is `kappa c_ij h_ij E_ij.grad_i W_ij` over this, with `E_ij = 2 (e_j - e_i) r_ji / r_ij^2` [Villodi &
/// Ramachandran 2024, eqs 14-15], weighed by `m_j / rho_j` (as printed) or by `m_j / rho_ij`, which exchanges energy
/// pairwise and so conserves it.
pub const CONDUCTION: f64 = -2.0 * KAPPA;

/// What Noh [1987] adds to the speed of sound in a shock, over [`KAPPA`]. Where gas first meets a wall the artificial
/// viscosity heats it too much, and its density is then too low for good; as long as it is compressed, its neighbours
/// share that heat. `closing` is the viscosity's `mu`.
#[inline(always)]
fn shock_speed<V: Vectors>(vectors: V, closing: Lane<V>) -> Lane<V> {
    closing * Lane::splat(vectors, -COMPRESSED / KAPPA)
}

/// That part of the `difference` `e_j - e_i` that does not vary linearly across the pair: what is left of it by the least
/// of itself and of what the slopes at both ends see, `own = g_i.r_ji` and `other = g_j.r_ji` (Roe's minmod [1986]); all
/// of it where they differ in sign. As for the viscosity [Frontiere, Raskin & Owen 2017, section 2.4; for conduction
/// Rosswog 2020, section 2.3], contacts are then not smeared further than the scheme needs. Van Leer's mean is a tenth better at
/// contacts, costs 4 % more time and lets walls overheat.
#[inline(always)]
fn uneven_part<V: Vectors>(
    vectors: V,
    difference: Lane<V>,
    own: Lane<V>,
    other: Lane<V>,
) -> Lane<V> {
    let zero = Lane::splat(vectors, 0.0);
    let rise = own.min(other).min(difference).max(zero);
    let fall = own.max(other).max(difference).min(zero);
    difference - (rise + fall)
}

/// Exchange of heat, times [`CONDUCTION`], within the gas only.
#[derive(Clone, Copy, Debug)]
pub struct ArtificialConduction(pub Conduction);

impl<const D: usize> Law<Encounters<'_, D>, D> for ArtificialConduction {
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
        each(|k| Lane::gather(vectors, |l| read.state[slot(l)].energy_slope[k]))
    }

    #[inline(always)]
    fn add<V: Vectors>(
        &self,
        (_, own_slope): (&Own<V, D>, &Self::Own<V>),
        met: &mut Encounter<V, D>,
        j: Neighbour<'_, V, D>,
        sum: &mut Self::Sums<V>,
    ) {
        let (vectors, pair) = (j.vectors, &met.pair);
        let uneven = match self.0 {
            Conduction::None => return,
            Conduction::ByVolume => {
                let exchanged = met.sound * met.energy * met.reach;
                *sum = exchanged.mul_add(met.volume, *sum);
                return;
            }
            Conduction::InShocks => Lane::splat(vectors, 0.0),
            Conduction::Pairwise => met.energy,
            Conduction::Limited => {
                let slope = &j.read.state[j.slot].energy_slope;
                let theirs: LaneVector<V, D> = each(|k| Lane::broadcast(vectors, slope[k]));
                let own = -dot(own_slope, &pair.separation);
                let other = -dot(&theirs, &pair.separation);
                uneven_part(vectors, met.energy, own, other)
            }
        };
        let noh = shock_speed(vectors, met.closing) * met.energy;
        let exchanged = met.sound.mul_add(uneven, noh);
        *sum = (exchanged * met.reach).mul_add(met.pairwise, *sum);
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
        rates.energy += CONDUCTION * all;
    }
}
