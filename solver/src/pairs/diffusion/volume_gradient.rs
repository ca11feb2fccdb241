//! The gradient of one, as neighbours sum it.

use aero_geometry::Vector;

use super::{Met, Neighbours, Own, Site};
use crate::pairs::law::{Law, Neighbour};
use crate::pairs::pair::{LaneVector, accumulate};
use crate::particles::Rates;
use crate::records::Read;
use crate::vectors::Vectors;

/// `sum V_j grad_i W_ij`, by which stress and heat flux count their own particle's part.
#[derive(Clone, Copy, Debug)]
pub struct VolumeGradient;

impl<const D: usize> Law<Neighbours<'_, D>, D> for VolumeGradient {
    type Own<V: Vectors> = ();
    type Sums<V: Vectors> = LaneVector<V, D>;
    type Number = [f64; D];

    #[inline(always)]
    fn load<V: Vectors>(&self, _: V, _: Read<'_, D, V::Number>, _: impl Fn(usize) -> usize + Copy) {
    }

    #[inline(always)]
    fn add<V: Vectors>(
        &self,
        _: (&Own<V, D>, &()),
        met: &mut Met<V, D>,
        _: Neighbour<'_, V, D>,
        gradient: &mut LaneVector<V, D>,
    ) {
        accumulate(gradient, met.gradient_volume, &met.pair.separation);
    }

    #[inline(always)]
    fn finish(&self, gas: [f64; D], all: [f64; D], site: &mut Site<'_, D>, _: &mut Rates<D>) {
        site.volume_gradients = [Vector::from(gas), Vector::from(all)];
    }
}
