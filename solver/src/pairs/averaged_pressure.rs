//! Pressure by averages of pairs.

use aero_geometry::Vector;

use super::encounter::{Encounter, Encounters, Own, Site};
use super::law::{Law, Neighbour};
use super::pair::{LaneVector, accumulate};
use crate::lanes::Lane;
use crate::particles::Rates;
use crate::records::Read;
use crate::vectors::Vectors;

/// Acceleration `-1/m_i sum_j (V_i^2 + V_j^2) p_ij grad_i W_ij` with `p_ij = (V_i p_i + V_j p_j) / (V_i + V_j)`, the mean that weighs by the
/// other's density [Adami, Hu & Adams 2013, eqs 7-8; Ramachandran & Puri 2019; sign of Negi & Ramachandran 2021, eq. 19, as the continuum has
/// it]: pairs of equal masses exchange momentum alike.
#[derive(Clone, Copy, Debug)]
pub struct AveragedPressure {
    /// False where another law gives the acceleration.
    pub acts: bool,
}

/// Of the particles `i`: volume and pressure.
#[derive(Clone, Copy)]
pub struct Pressed<V: Vectors> {
    volume: Lane<V>,
    pressure: Lane<V>,
}

impl AveragedPressure {
    /// The acceleration, from `sum (V_i^2 + V_j^2) / V_i p_ij grad W`.
    #[inline(always)]
    fn acceleration<const D: usize>(site: &Site<'_, D>, sum: [f64; D]) -> Vector<D> {
        Vector::from(sum) * (-site.near.volume / site.near.mass)
    }
}

impl<const D: usize> Law<Encounters<'_, D>, D> for AveragedPressure {
    type Own<V: Vectors> = Pressed<V>;
    type Sums<V: Vectors> = LaneVector<V, D>;
    type Number = [f64; D];

    #[inline(always)]
    fn load<V: Vectors>(
        &self,
        vectors: V,
        read: Read<'_, D, V::Number>,
        slot: impl Fn(usize) -> usize + Copy,
    ) -> Pressed<V> {
        Pressed {
            volume: Lane::gather(vectors, |l| read.near[slot(l)].volume),
            pressure: Lane::gather(vectors, |l| read.state[slot(l)].pressure),
        }
    }

    #[inline(always)]
    fn add<V: Vectors>(
        &self,
        (_, own): (&Own<V, D>, &Pressed<V>),
        met: &mut Encounter<V, D>,
        j: Neighbour<'_, V, D>,
        sum: &mut Self::Sums<V>,
    ) {
        if self.acts {
            let pressure = Lane::broadcast(j.vectors, j.read.state[j.slot].pressure);
            let (own_volume, volume) = (own.volume, met.volume);
            let weighed = own_volume.mul_add(own.pressure, volume * pressure);
            let squares = own_volume.mul_add(own_volume, volume * volume);
            let factor = squares * weighed / (own_volume * (own_volume + volume));
            accumulate(sum, factor * met.pair.gradient_factor, &met.pair.separation);
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
