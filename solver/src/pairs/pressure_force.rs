//! What pressure does.

use aero_geometry::Vector;

use super::encounter::{Encounter, Encounters, Own, Site};
use super::law::{Law, Neighbour};
use super::pair::{LaneVector, accumulate, dot};
use crate::each::each;
use crate::lanes::Lane;
use crate::particles::{ByPressure, Rates};
use crate::records::Read;
use crate::vectors::Vectors;

/// Acceleration `-1/rho_i sum_j V_j (p_i L_i + p_j L_j) grad_i W_ij` and heating `-p/rho div u` [Villodi & Ramachandran 2024, eqs
/// 12 and 14].
#[derive(Clone, Copy, Debug)]
pub struct PressureForce;

impl PressureForce {
    /// The acceleration, from `sum V_j grad W` and `sum V_j p_j L_j grad W`.
    #[inline(always)]
    fn acceleration<const D: usize>(
        site: &Site<'_, D>,
        (gradient, stress): ([f64; D], [f64; D]),
    ) -> Vector<D> {
        let own = site.renormalisation.matrix * Vector::from(gradient) * site.state.pressure;
        -(own + Vector::from(stress)) / site.near.density()
    }
}

impl<const D: usize> Law<Encounters<'_, D>, D> for PressureForce {
    type Own<V: Vectors> = ();
    type Sums<V: Vectors> = (LaneVector<V, D>, LaneVector<V, D>);
    type Number = ([f64; D], [f64; D]);

    #[inline(always)]
    fn load<V: Vectors>(
        &self,
        _: V,
        _: Read<'_, D, V::Number>,
        _: impl Fn(usize) -> usize + Copy,
    ) -> Self::Own<V> {
    }

    #[inline(always)]
    fn add<V: Vectors>(
        &self,
        _: (&Own<V, D>, &Self::Own<V>),
        met: &mut Encounter<V, D>,
        j: Neighbour<'_, V, D>,
        (gradient, stress): &mut Self::Sums<V>,
    ) {
        let (state, pair) = (&j.read.state[j.slot], &met.pair);
        accumulate(gradient, met.gradient_volume, &pair.separation);
        for a in 0..D {
            let row: LaneVector<V, D> =
                each(|b| Lane::broadcast(j.vectors, state.stress.get(a, b)));
            stress[a] = dot(&row, &pair.separation).mul_add(pair.gradient_factor, stress[a]);
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
        let acceleration = Self::acceleration(site, all);
        rates.by_pressure = ByPressure {
            acceleration,
            heating: -site.state.pressure / site.near.density() * site.divergence,
        };
        rates.acceleration += Self::acceleration(site, gas);
        site.acceleration += acceleration;
        rates.energy += rates.by_pressure.heating;
    }
}
