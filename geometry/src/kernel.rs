//! The quintic spline, the one smoothing kernel of packer and solver.

use std::f64::consts::PI;

use crate::Real;

/// Support radius in smoothing lengths: the kernel is zero beyond `3 h`.
pub const SUPPORT: f64 = 3.0;

/// Smoothing length in particle spacings (Villodi & Ramachandran 2024, section 3.6: 1.2 is noisy).
pub const SMOOTHING_RATIO: f64 = 1.5;

/// The quintic spline `W(r, h) = s_D / h^D [(3-q)^5 - 6 (2-q)^5 + 15 (1-q)^5]`, `q = r / h`, each
/// bracket only where positive (Schoenberg 1946; Morris, Fox & Zhu 1997, eq. 11).
#[derive(Clone, Copy, Debug, Default)]
pub struct QuinticSpline<const D: usize>;

impl<const D: usize> QuinticSpline<D> {
    /// The factor `s_D` that makes the kernel integrate to one: 1/120, 7/(478 pi) and 1/(120 pi)
    /// for `D = 1, 2, 3`.
    pub const NORMALISATION: f64 = match D {
        1 => 1.0 / 120.0,
        2 => 7.0 / (478.0 * PI),
        _ => 1.0 / (120.0 * PI),
    };

    /// `W(r, h)`, unit 1 / length^D.
    #[inline]
    pub fn value(r: f64, h: f64) -> f64 {
        Self::NORMALISATION / h.powi(D as i32) * shape(r / h)
    }

    /// `(dW/dr) / r`, never positive, unit 1 / length^(D+2): the gradient is this times `r_i - r_j`.
    #[inline]
    pub fn gradient_factor(r: f64, h: f64) -> f64 {
        let slope = -5.0 * steepness(r / h);
        Self::NORMALISATION / h.powi(D as i32 + 1) * slope / r.max(1e-12 * h)
    }
}

/// The spline but for its scale: `(3-q)^5 - 6 (2-q)^5 + 15 (1-q)^5`.
#[inline(always)]
pub fn shape<R: Real>(q: R) -> R {
    let [a, b, c] = brackets(q);
    alternating([fourth(a) * a, fourth(b) * b, fourth(c) * c])
}

/// Its slope over minus five: `(3-q)^4 - 6 (2-q)^4 + 15 (1-q)^4`.
#[inline(always)]
pub fn steepness<R: Real>(q: R) -> R {
    let [a, b, c] = brackets(q);
    alternating([fourth(a), fourth(b), fourth(c)])
}

/// The positive parts of `3 - q`, `2 - q`, `1 - q`: beyond the support all are exactly zero.
#[inline(always)]
fn brackets<R: Real>(q: R) -> [R; 3] {
    // No closure: what is not inlined is not compiled for the wide vectors.
    let zero = q.constant(0.0);
    [
        (q.constant(3.0) - q).at_least(zero),
        (q.constant(2.0) - q).at_least(zero),
        (q.constant(1.0) - q).at_least(zero),
    ]
}

/// `a - 6 b + 15 c`.
#[inline(always)]
fn alternating<R: Real>([a, b, c]: [R; 3]) -> R {
    c.times_plus(c.constant(15.0), b.times_plus(b.constant(-6.0), a))
}

#[inline(always)]
fn fourth<R: Real>(a: R) -> R {
    let squared = a * a;
    squared * squared
}

#[cfg(test)]
mod tests {
    use super::*;

    fn integral<const D: usize>() -> f64 {
        let n = 60_000;
        let dr = SUPPORT / f64::from(n);
        (0..n)
            .map(|k| {
                let r = (f64::from(k) + 0.5) * dr;
                let shell = match D {
                    1 => 2.0,
                    2 => 2.0 * PI * r,
                    _ => 4.0 * PI * r * r,
                };
                shell * QuinticSpline::<D>::value(r, 1.0) * dr
            })
            .sum()
    }

    #[test]
    fn the_kernel_integrates_to_one_in_every_dimension() {
        assert!((integral::<1>() - 1.0).abs() < 1e-8);
        assert!((integral::<2>() - 1.0).abs() < 1e-8);
        assert!((integral::<3>() - 1.0).abs() < 1e-8);
    }

    #[test]
    fn the_gradient_factor_is_the_slope_of_the_value() {
        for r in [0.2, 0.9, 1.4, 2.3, 2.9] {
            let h = 1.1;
            let d = 1e-6;
            let slope = (QuinticSpline::<3>::value(r + d, h) - QuinticSpline::<3>::value(r - d, h))
                / (2.0 * d);
            assert!((slope - r * QuinticSpline::<3>::gradient_factor(r, h)).abs() < 1e-8);
        }
    }
}
