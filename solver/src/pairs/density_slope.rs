//! Gradient of the density.

use aero_geometry::Vector;

use super::law::{Law, Neighbour};
use super::pair::{LaneVector, Target, accumulate};
use super::renormalisation::{Moment, Neighbourhoods, Renormalisation, Weighed};
use crate::lanes::Lane;
use crate::records::Read;
use crate::vectors::Vectors;

/// `grad rho = L_i sum_j V_j (rho_j - rho_i) grad_i W_ij` [Villodi & Ramachandran 2024, eq. 8], where densities are evolved.
#[derive(Clone, Copy, Debug)]
pub struct DensitySlope {
    /// Asked of every pair: the branch is always predicted.
    pub is_sought: bool,
}

impl<const D: usize> Law<Neighbourhoods<D>, D> for DensitySlope {
    type Own<V: Vectors> = ();
    /// Half of the sum.
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
        (own, ()): (&Target<V, D>, &()),
        met: &mut Weighed<V, D>,
        j: Neighbour<'_, V, D>,
        slope: &mut LaneVector<V, D>,
    ) {
        if self.is_sought {
            let theirs = Lane::broadcast(j.vectors, j.read.near[j.slot].half_density);
            let rise = met.weight * (theirs - own.half_density);
            accumulate(slope, rise, &met.pair.separation);
        }
    }

    #[inline(always)]
    fn finish(
        &self,
        _: [f64; D],
        slope: [f64; D],
        _: &mut Moment,
        result: &mut Renormalisation<D>,
    ) {
        result.density_gradient = result.matrix * Vector::from(slope) * 2.0;
    }
}
