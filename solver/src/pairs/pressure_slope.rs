//! Pressure by differences.

use aero_geometry::Vector;

use super::encounter::{Encounter, Encounters, Own, Site};
use super::law::{Law, Neighbour};
use super::pair::{LaneVector, accumulate};
use crate::lanes::Lane;
use crate::particles::Rates;
use crate::records::Read;
use crate::vectors::Vectors;

/// Acceleration `-1/rho_i sum_j V_j (p_j - p_i) L_i grad_i W_ij` [Negi & Ramachandran 2021, eq. 8]: exact where the pressure is linear, on any
/// arrangement; a pair does not exchange its momentum alike.
#[derive(Clone, Copy, Debug)]
pub struct PressureSlope {
    /// False where another law gives the acceleration.
    pub acts: bool,
}

impl PressureSlope {
    /// The acceleration, from `sum V_j (p_j - p_i) grad W`.
    #[inline(always)]
    fn acceleration<const D: usize>(site: &Site<'_, D>, slope: [f64; D]) -> Vector<D> {
        site.renormalisation.matrix * Vector::from(slope) / -site.near.density()
    }
}

impl<const D: usize> Law<Encounters<'_, D>, D> for PressureSlope {
    type Own<V: Vectors> = Lane<V>;
    type Sums<V: Vectors> = LaneVector<V, D>;
    type Number = [f64; D];

    #[inline(always)]
    fn load<V: Vectors>(
        &self,
        vectors: V,
        read: Read<'_, D, V::Number>,
        slot: impl Fn(usize) -> usize + Copy,
    ) -> Lane<V> {
        Lane::gather(vectors, |l| read.state[slot(l)].pressure)
    }

    #[inline(always)]
    fn add<V: Vectors>(
        &self,
        (_, pressure): (&Own<V, D>, &Lane<V>),
        met: &mut Encounter<V, D>,
        j: Neighbour<'_, V, D>,
        slope: &mut Self::Sums<V>,
    ) {
        if self.acts {
            let rise = Lane::broadcast(j.vectors, j.read.state[j.slot].pressure) - *pressure;
            accumulate(slope, met.gradient_volume * rise, &met.pair.separation);
        }
    }

    #[inline(always)]
    fn finish(
        &self,
        gas: Self::Number,
        all: Self::Number,
        site: &mut Site<'_, D>,
        rates: &mut Rates<D>,
    ) {
        if self.acts {
            let acceleration = Self::acceleration(site, all);
            rates.by_pressure.acceleration += acceleration;
            rates.acceleration += Self::acceleration(site, gas);
            site.acceleration += acceleration;
        }
    }
}
