//! Isentropic flow of a perfect gas: ratios to stagnation and the area-Mach relation.
//!
//! Sources: NACA Report 1135, "Equations, tables, and charts for compressible flow" (1953),
//! eqs. 43-45 and 80; Anderson, "Modern Compressible Flow", chapter 3.

use super::root::bracketed_root;
use super::{ExactError, require, require_gamma};

/// Which solution of a relation with two: slower or faster than sound.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Branch {
    /// Mach number below 1.
    Subsonic,
    /// Mach number above 1.
    Supersonic,
}

/// `T0 / T = 1 + (gamma - 1)/2 M^2` [NACA 1135, eq. 43].
pub fn temperature_ratio(mach: f64, gamma: f64) -> f64 {
    1.0 + 0.5 * (gamma - 1.0) * mach * mach
}

/// `p0 / p` [NACA 1135, eq. 44].
pub fn pressure_ratio(mach: f64, gamma: f64) -> f64 {
    temperature_ratio(mach, gamma).powf(gamma / (gamma - 1.0))
}

/// `rho0 / rho` [NACA 1135, eq. 45].
pub fn density_ratio(mach: f64, gamma: f64) -> f64 {
    temperature_ratio(mach, gamma).powf(1.0 / (gamma - 1.0))
}

/// `A / A*`, the area over that of the sonic throat [NACA 1135, eq. 80]:
/// `(1/M) [2/(gamma+1) (1 + (gamma-1)/2 M^2)]^((gamma+1)/(2(gamma-1)))`.
pub fn area_ratio(mach: f64, gamma: f64) -> f64 {
    let exponent = 0.5 * (gamma + 1.0) / (gamma - 1.0);
    (2.0 / (gamma + 1.0) * temperature_ratio(mach, gamma)).powf(exponent) / mach
}

/// Mach number where the area is `ratio` times the sonic throat, on the branch asked for.
///
/// `ratio` must be at least 1 (the throat is the narrowest sonic section).
pub fn mach_from_area(ratio: f64, branch: Branch, gamma: f64) -> Result<f64, ExactError> {
    require_gamma(gamma)?;
    require(
        ratio >= 1.0 && ratio.is_finite(),
        "the ratio of area to sonic throat",
        ratio,
        "values of 1 and above",
    )?;
    let excess = |mach: f64| area_ratio(mach, gamma) - ratio;
    Ok(match branch {
        // Near M = 0 the ratio grows as 1/M, so this end is always above the target.
        Branch::Subsonic => bracketed_root(excess, 0.5 / (ratio + 1.0), 1.0),
        Branch::Supersonic => {
            let mut high = 2.0;
            while excess(high) < 0.0 {
                high *= 2.0;
            }
            bracketed_root(excess, 1.0, high)
        }
    })
}

/// Mach number of gas expanded from stagnation `p0` to `p`, given `p0 / p >= 1`.
pub fn mach_from_pressure(ratio: f64, gamma: f64) -> f64 {
    let temperature = ratio.powf((gamma - 1.0) / gamma);
    (2.0 / (gamma - 1.0) * (temperature - 1.0)).max(0.0).sqrt()
}

/// Pressure coefficient `(p - p1) / (rho1 u1^2 / 2)` of a pressure `p = ratio p1` in a stream of
/// Mach number `mach`: `2 (ratio - 1) / (gamma M^2)`.
pub fn pressure_coefficient(ratio: f64, mach: f64, gamma: f64) -> f64 {
    2.0 * (ratio - 1.0) / (gamma * mach * mach)
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use proptest::prelude::*;

    #[test]
    fn mach_two_agrees_with_the_published_tables() {
        // NACA 1135, table II: p/p0 0.1278, T/T0 0.5556, A/A* 1.688 (rounded there).
        assert_relative_eq!(
            1.0 / pressure_ratio(2.0, 1.4),
            0.127_805,
            max_relative = 1e-5
        );
        assert_relative_eq!(
            1.0 / temperature_ratio(2.0, 1.4),
            0.555_556,
            max_relative = 1e-5
        );
        assert_relative_eq!(
            1.0 / density_ratio(2.0, 1.4),
            0.230_048,
            max_relative = 1e-5
        );
        assert_relative_eq!(area_ratio(2.0, 1.4), 1.6875, max_relative = 1e-12);
    }

    #[test]
    fn the_throat_is_sonic_on_both_branches() {
        for branch in [Branch::Subsonic, Branch::Supersonic] {
            assert_relative_eq!(
                mach_from_area(1.0, branch, 1.4).unwrap(),
                1.0,
                epsilon = 1e-7
            );
        }
    }

    #[test]
    fn an_area_below_the_throat_is_refused() {
        let error = mach_from_area(0.9, Branch::Subsonic, 1.4).unwrap_err();
        assert!(error.to_string().contains("0.9"), "{error}");
    }

    proptest! {
        #[test]
        fn area_and_mach_invert_each_other(mach in 0.01_f64..8.0, gamma in 1.1_f64..1.7) {
            prop_assume!((mach - 1.0).abs() > 1e-3);
            let branch = if mach < 1.0 { Branch::Subsonic } else { Branch::Supersonic };
            let back = mach_from_area(area_ratio(mach, gamma), branch, gamma).unwrap();
            prop_assert!((back - mach).abs() < 1e-8 * mach.max(1.0));
        }

        #[test]
        fn pressure_and_mach_invert_each_other(mach in 0.01_f64..20.0, gamma in 1.1_f64..1.7) {
            let back = mach_from_pressure(pressure_ratio(mach, gamma), gamma);
            prop_assert!((back - mach).abs() < 1e-9 * mach.max(1.0));
        }
    }
}
