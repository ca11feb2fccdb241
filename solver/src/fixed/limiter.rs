//! How steep the gas may be between two cells: limiters of the slope from one cell's middle to the next.
//!
//! All are functions `phi(a, b)` of two differences, the one beyond a cell and the one across a face: `b` where both are equal,
//! zero where they have opposite signs.

use super::real::Real;

/// Of van Leer, the harmonic mean `2 a b / (a + b)` [van Leer 1974, J. Comput. Phys. 14, 361-370].
#[inline(always)]
pub fn van_leer<R: Real>(a: R, b: R) -> R {
    let product = a * b;
    product.select(product * 2.0 / (a + b), a.like(0.0))
}

/// The smaller of both [Roe 1986, Annu. Rev. Fluid Mech. 18, 337-365].
#[inline(always)]
pub fn minmod<R: Real>(a: R, b: R) -> R {
    let smaller = a.select(a.min(b), a.max(b));
    (a * b).select(smaller, a.like(0.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limiters_keep_what_is_even_and_stop_at_extremes() {
        for limiter in [van_leer::<f64>, minmod::<f64>] {
            assert_eq!(limiter(0.3, 0.3), 0.3);
            assert_eq!(limiter(-0.3, -0.3), -0.3);
            assert_eq!(limiter(0.3, -0.1), 0.0);
            assert_eq!(limiter(0.0, 0.0), 0.0);
        }
    }

    #[test]
    fn van_leer_takes_the_harmonic_mean_and_minmod_the_smaller() {
        assert!((van_leer(1.0, 3.0) - 1.5_f64).abs() < 1e-15);
        assert!((van_leer(-3.0, -1.0) + 1.5_f64).abs() < 1e-15);
        assert_eq!(minmod(1.0, 3.0), 1.0);
        assert_eq!(minmod(-3.0, -1.0), -1.0);
    }
}
