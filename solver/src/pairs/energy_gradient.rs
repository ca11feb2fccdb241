//! Gradient of the specific internal energy.

use aero_geometry::Vector;

use super::encounter::{Encounter, Encounters, Own, Site};
use super::law::{Law, Neighbour};
use super::pair::{LaneVector, accumulate};
use crate::particles::Rates;
use crate::records::Read;
use crate::vectors::Vectors;

/// `grad e = L_i sum_j V_j (e_j - e_i) grad_i W_ij`, where anything asks for it.
#[derive(Clone, Copy, Debug)]
pub struct EnergyGradient {
    /// Asked of every pair: the branch is always predicted.
    pub is_sought: bool,
}

impl<const D: usize> Law<Encounters<'_, D>, D> for EnergyGradient {
    type Own<V: Vectors> = ();
    type Sums<V: Vectors> = LaneVector<V, D>;
    type Number = [f64; D];

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
        _: Neighbour<'_, V, D>,
        sums: &mut Self::Sums<V>,
    ) {
        if self.is_sought {
            accumulate(sums, met.gradient_volume * met.energy, &met.pair.separation);
        }
    }

    #[inline(always)]
    fn finish(
        &self,
        _: Self::Number,
        all: Self::Number,
        site: &mut Site<'_, D>,
        rates: &mut Rates<D>,
    ) {
        site.energy_slope = Vector::from(all);
        rates.energy_gradient = site.renormalisation.matrix * site.energy_slope;
    }
}
