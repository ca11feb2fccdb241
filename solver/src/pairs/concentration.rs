//! Concentration of particles: where they crowd.

use super::super::lanes::Lane;
use super::super::vectors::Vectors;
use super::{Pair, brackets, fourth};

/// Coefficient `R` of the short-ranged part (Monaghan 2000; Sun et al. 2017).
const SHORT_RANGE: f64 = 0.2;

/// `(3 - q)^5 - 6 (2 - q)^5 + 15 (1 - q)^5` of the quintic spline one spacing away, `q = 2/3`.
const ONE_SPACING: f64 = (16_807.0 - 6.0 * 1_024.0 + 15.0) / 243.0;

/// `1 + R (W_ij / W(dx))^4`, with which the gradient of the concentration, `sum_j V_j [..] grad_i W_ij`, weighs a pair
/// [Sun et al. 2017, after Monaghan 2000]. The kernel alone does not feel rows and pairs closer together
/// than it is wide; the short-ranged part does. `W(dx)` is that of a spacing `2/3 h_ij`, so that the factor depends on
/// `r / h` alone: a smooth gradient of density, along which spacing and `h` grow together, is then no disorder
/// up to terms in `h^2`.
#[inline(always)]
pub fn repulsion<V: Vectors, const D: usize>(vectors: V, pair: &Pair<V, D>) -> Lane<V> {
    let [a, b, c] = brackets(vectors, pair.ratio);
    let six = Lane::splat(vectors, -6.0);
    let fifteen = Lane::splat(vectors, 15.0);
    let value = (fourth(c) * c).mul_add(fifteen, (fourth(b) * b).mul_add(six, fourth(a) * a));
    let relative = value * Lane::splat(vectors, 1.0 / ONE_SPACING);
    fourth(relative).mul_add(Lane::splat(vectors, SHORT_RANGE), Lane::splat(vectors, 1.0))
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
