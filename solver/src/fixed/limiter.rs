//! How steep the gas may be between two cells: limiters of the slope from one cell's middle to the next.
//!
//! All are functions `phi(a, b)` of two differences, the one beyond a cell and the one across a face: `b` where both are equal,
//! zero where they have opposite signs.

use super::calmness::share;
use super::real::Real;

/// The mean, no more than twice the smaller one: monotonized central differences [van Leer 1977, J. Comput. Phys. 23, 276-299].
#[inline(always)]
pub fn central<R: Real>(a: R, b: R) -> R {
    let (low, high) = (a.min(b) * 2.0, a.max(b) * 2.0);
    let mean = (a + b) * 0.5;
    let limited = a.select(mean.min(low), mean.max(high));
    (a * b).select(limited, a.like(0.0))
}

/// A third of the one beyond and two of the one across, no more than twice the smaller one: where the gas is smooth and the cells are even,
/// of third order [Koren 1993, in Numerical Methods for Advection-Diffusion Problems, 117-138].
#[inline(always)]
pub fn third<R: Real>(beyond: R, across: R) -> R {
    let (low, high) = (beyond.min(across) * 2.0, beyond.max(across) * 2.0);
    let mean = (beyond + across * 2.0) * (1.0 / 3.0);
    let limited = beyond.select(mean.min(low), mean.max(high));
    (beyond * across).select(limited, beyond.like(0.0))
}

/// The smaller of both [Roe 1986, Annu. Rev. Fluid Mech. 18, 337-365].
#[inline(always)]
pub fn minmod<R: Real>(a: R, b: R) -> R {
    let smaller = a.select(a.min(b), a.max(b));
    (a * b).select(smaller, a.like(0.0))
}

/// How much of a wave that cells can follow there is in the differences beyond the cells on both sides of a face less the one across it, `a` and
/// `b`: these have opposite signs where a wave bends the gas alike, and at a crest are as `cos(2 pi / n)` to one, `n` cells to a wave. Waves of
/// six cells and shorter ones count for nothing, and those of fourteen and longer wholly; at a jump no two are alike, and next to none of it counts.
#[inline(always)]
pub fn wavy<R: Real>(a: R, b: R) -> R {
    /// `cos(2 pi / 6)` and `cos(2 pi / 14)`.
    const SHORT: f64 = 0.5;
    const LONG: f64 = 0.900_968_867_902_419_1;
    let larger = (a * a).max(b * b) + f64::MIN_POSITIVE;
    share(-(a * b) / larger, SHORT, LONG)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limiters_keep_what_is_even_and_stop_at_extremes() {
        for limiter in [central::<f64>, minmod::<f64>] {
            assert_eq!(limiter(0.3, 0.3), 0.3);
            assert_eq!(limiter(-0.3, -0.3), -0.3);
            assert_eq!(limiter(0.3, -0.1), 0.0);
            assert_eq!(limiter(0.0, 0.0), 0.0);
        }
    }

    #[test]
    fn central_differences_take_the_mean_or_twice_the_smaller_and_minmod_the_smaller() {
        assert_eq!(central(1.0, 2.0), 1.5);
        assert_eq!(central(2.0, 1.0), 1.5);
        assert_eq!(central(-1.0, -2.0), -1.5);
        assert_eq!(central(1.0, 9.0), 2.0);
        assert_eq!(central(-9.0, -1.0), -2.0);
        // x^2 has the means 1, 4 and 9 and a twelfth around 1, 2 and 3, and is 6.25 half-way between the last two.
        let face = 4.0 + 1.0 / 12.0 + 0.5 * third(3.0, 5.0);
        assert!((face - 6.25_f64).abs() < 1e-14, "{face}");
        assert_eq!(third(1.0, 9.0), 2.0);
        assert_eq!(third(0.3, -0.1), 0.0);
        assert_eq!(third(-9.0, -1.0), -2.0);
        assert_eq!(minmod(1.0, 3.0), 1.0);
        assert_eq!(minmod(-3.0, -1.0), -1.0);
    }
}
