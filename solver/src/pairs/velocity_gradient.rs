//! Gradient of the velocity, and the density that follows it.

use super::encounter::{Encounter, Encounters, Own, Site};
use super::law::{Law, Neighbour};
use super::pair::{LaneVector, accumulate};
use crate::particles::Rates;
use crate::records::{Matrix, Read};
use crate::vectors::Vectors;

/// `du_a / dx_b = [sum_j V_j (u_j - u_i) (x) grad_i W_ij L_i]_ab`, and the rate of density `-rho div u` [Villodi & Ramachandran
/// 2024, eqs 6 and 10].
#[derive(Clone, Copy, Debug)]
pub struct VelocityGradient;

impl<const D: usize> Law<Encounters<'_, D>, D> for VelocityGradient {
    type Own<V: Vectors> = ();
    type Sums<V: Vectors> = [LaneVector<V, D>; D];
    type Number = [[f64; D]; D];

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
        for a in 0..D {
            accumulate(
                &mut sums[a],
                met.gradient_volume * met.jump[a],
                &met.pair.separation,
            );
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
        let matrix = &site.renormalisation.matrix;
        site.slope = Matrix::from_fn(|a, b| all[a][b]);
        site.divergence = site.slope.component_mul(matrix).sum();
        rates.velocity_gradient = site.slope * matrix;
        rates.density = -site.near.density() * site.divergence;
    }
}
