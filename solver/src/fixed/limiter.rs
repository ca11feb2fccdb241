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

/// `cos(2 pi / n)` of waves of six cells, which count for nothing, and of fourteen: those and longer ones count wholly.
const SHORT: f64 = 0.5;
const LONG: f64 = 0.900_968_867_902_419_1;

/// How much of a wave that cells can follow there is about a crest: `a` and `b` are the differences beyond the cells on both sides of a face less the
/// one across it. These have opposite signs where a wave bends the gas alike, and at a crest are as `cos(2 pi / n)` to one, `n` cells to a wave; at a
/// jump no two are alike, and next to none of it counts.
#[inline(always)]
pub fn wavy<R: Real>(a: R, b: R) -> R {
    let larger = (a * a).max(b * b) + f64::MIN_POSITIVE;
    share(-(a * b) / larger, SHORT, LONG)
}

/// The same on a wave's flanks, where the differences `beyond` both cells and the one `across` the face have one sign: anywhere on a wave of `n` cells
/// the mean of the outer ones is `cos(2 pi / n)` of the one between. At the foot of a jump it is more, in its middle little. Towards crests,
/// where the smaller one goes to zero, it counts less and less: switched there, it would make flows lean that have no side.
#[inline(always)]
pub fn rising<R: Real>(beyond: [R; 2], across: R) -> R {
    let inverse = across / (across * across + f64::MIN_POSITIVE);
    let [a, b] = [beyond[0] * inverse, beyond[1] * inverse];
    let mean = (a + b) * 0.5;
    let counted = share(mean, SHORT, LONG) * share(a.min(b), 0.0, SHORT);
    (mean.like(1.0) - mean).select(counted, mean.like(0.0))
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

    /// Differences of `cos(x)` about a face at `place`, `count` cells to a wave.
    fn differences(place: f64, count: f64) -> ([f64; 2], f64) {
        let angle = std::f64::consts::TAU / count;
        let [a, b, c, d] = [-1.5, -0.5, 0.5, 1.5].map(|k| (place + k * angle).cos());
        ([b - a, d - c], c - b)
    }

    #[test]
    fn waves_of_fourteen_cells_count_wholly_on_their_flanks_and_those_of_six_for_nothing() {
        for place in [1.3, 1.6, 1.8, -1.4] {
            let counted = [5.0, 6.0, 9.0, 14.0, 40.0].map(|count| {
                let (beyond, across) = differences(place, count);
                rising(beyond, across)
            });
            assert_eq!(counted[0], 0.0);
            assert!(counted[1].abs() < 1e-12, "{counted:?}");
            assert!(counted[2] > 0.3 && counted[2] < 0.7, "{counted:?}");
            assert!(counted[3] > 1.0 - 1e-12, "{counted:?}");
            assert_eq!(counted[4], 1.0);
        }
    }

    #[test]
    fn what_counts_fades_towards_crests() {
        let near = [0.3, 0.44, 0.46].map(|place| {
            let (beyond, across) = differences(place, 14.0);
            rising(beyond, across)
        });
        assert!(
            near[0] == 0.0 && near[1] == 0.0 && near[2] > 0.0 && near[2] < 0.1,
            "{near:?}"
        );
    }

    #[test]
    fn neither_crests_nor_feet_of_jumps_nor_gas_at_rest_are_flanks() {
        let (beyond, across) = differences(0.1, 14.0);
        assert_eq!(rising(beyond, across), 0.0);
        assert_eq!(rising([0.1, 0.9], 0.3), 0.0);
        assert_eq!(rising([0.1, 0.1], 0.8), 0.0);
        assert_eq!(rising([0.0, 0.0], 0.0), 0.0);
        assert_eq!(rising([-1.0, -0.9], -1.0), rising([0.9, 1.0], 1.0));
    }
}
