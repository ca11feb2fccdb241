//! Concentration of particles: where they crowd.

use aero_geometry::Vector;
use aero_geometry::kernel::shape;

use super::law::{Law, Neighbour};
use super::pair::{LaneVector, Pair, Target, accumulate};
use super::renormalisation::{Moment, Neighbourhoods, Renormalisation, Weighed};
use crate::lanes::Lane;
use crate::records::Read;
use crate::vectors::Vectors;

/// Coefficient `R` of the short-ranged part (Monaghan 2000; Sun et al. 2017).
const SHORT_RANGE: f64 = 0.2;

/// `(3 - q)^5 - 6 (2 - q)^5 + 15 (1 - q)^5` of the quintic spline one spacing away, `q = 2/3`.
const ONE_SPACING: f64 = (16_807.0 - 6.0 * 1_024.0 + 15.0) / 243.0;

/// Where the mean moment is less, the particle stands at a free edge and its concentration says nothing about
/// order (Lee et al. 2008: `div r < 1.5` in the plane, of 2 inside).
const SURROUNDED: f64 = 0.75;

/// `1 + R (W_ij / W(dx))^4`, with which the gradient of the concentration, `sum_j V_j [..] grad_i W_ij`, weighs a pair
/// [Sun et al. 2017, after Monaghan 2000]. The kernel alone does not feel rows and pairs closer together
/// than it is wide; the short-ranged part does. `W(dx)` is that of a spacing `2/3 h_ij`, so that the factor depends on
/// `r / h` alone: a smooth gradient of density, along which spacing and `h` grow together, is then no disorder
/// up to terms in `h^2`.
#[inline(always)]
fn repulsion<V: Vectors, const D: usize>(vectors: V, pair: &Pair<V, D>) -> Lane<V> {
    let relative = shape(pair.ratio) * Lane::splat(vectors, 1.0 / ONE_SPACING);
    let squared = relative * relative;
    (squared * squared).mul_add(Lane::splat(vectors, SHORT_RANGE), Lane::splat(vectors, 1.0))
}

/// Gradient of the particles' concentration, `sum_j V_j [..] grad_i W_ij`, and the ghosts' part of it.
#[derive(Clone, Copy, Debug)]
pub struct Concentration {
    /// Asked of every pair: the branch is always predicted.
    pub is_sought: bool,
}

impl<const D: usize> Law<Neighbourhoods<D>, D> for Concentration {
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
        _: (&Target<V, D>, &()),
        met: &mut Weighed<V, D>,
        j: Neighbour<'_, V, D>,
        sum: &mut LaneVector<V, D>,
    ) {
        if self.is_sought {
            let weight = met.weight * repulsion(j.vectors, &met.pair);
            accumulate(sum, weight, &met.pair.separation);
        }
    }

    #[inline(always)]
    fn finish(
        &self,
        gas: [f64; D],
        all: [f64; D],
        site: &mut Moment,
        result: &mut Renormalisation<D>,
    ) {
        if self.is_sought && site.trace > SURROUNDED * D as f64 {
            result.concentration_gradient = Vector::from(all);
            result.wall_gradient = result.concentration_gradient - Vector::from(gas);
        }
    }
}

#[cfg(test)]
mod tests {
    use aero_geometry::kernel::{QuinticSpline, SMOOTHING_RATIO};

    #[test]
    fn the_kernel_one_spacing_away_is_that_of_the_starting_lattice() {
        let shape = QuinticSpline::<2>::value(1.0, SMOOTHING_RATIO) * SMOOTHING_RATIO.powi(2)
            / QuinticSpline::<2>::NORMALISATION;
        assert!((shape - super::ONE_SPACING).abs() < 1e-12 * shape);
    }
}
