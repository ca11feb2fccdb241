//! Prandtl-Meyer expansion: the function, its inverse, and the fan at a convex corner.
//!
//! Sources: Anderson, "Modern Compressible Flow", eq. (4.44); NACA Report 1135 (1953), eq. 171c.

use super::isentropic;
use super::root::bracketed_root;
use super::{ExactError, require, require_gamma, require_supersonic};

/// Prandtl-Meyer angle, radians, of a stream of Mach number `mach >= 1` (infinity allowed):
/// `sqrt(k) atan(sqrt((M^2-1)/k)) - atan(sqrt(M^2-1))`, `k = (gamma+1)/(gamma-1)`.
pub fn prandtl_meyer_angle(mach: f64, gamma: f64) -> f64 {
    let k = ((gamma + 1.0) / (gamma - 1.0)).sqrt();
    let b = (mach * mach - 1.0).max(0.0).sqrt();
    k * (b / k).atan() - b.atan()
}

/// The angle of an expansion from sonic speed into vacuum, radians (130.45 degrees in air).
pub fn largest_angle(gamma: f64) -> f64 {
    let k = ((gamma + 1.0) / (gamma - 1.0)).sqrt();
    std::f64::consts::FRAC_PI_2 * (k - 1.0)
}

/// Mach number of Prandtl-Meyer angle `angle` (radians, from 0 to [`largest_angle`], where it is
/// infinite).
pub fn mach_from_angle(angle: f64, gamma: f64) -> Result<f64, ExactError> {
    require_gamma(gamma)?;
    require(
        (0.0..=largest_angle(gamma)).contains(&angle),
        "the Prandtl-Meyer angle in radians",
        angle,
        "angles from zero to the expansion into vacuum",
    )?;
    // In terms of 1/M the whole branch lies between 0 (vacuum) and 1 (sonic).
    let excess = |inverse: f64| prandtl_meyer_angle(1.0 / inverse, gamma) - angle;
    Ok(1.0 / bracketed_root(excess, 0.0, 1.0))
}

/// The stream behind a centred fan as ratios to the stream ahead.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fan {
    /// Mach number behind; infinite if the turn opens a vacuum.
    pub mach: f64,
    /// `p2 / p1`.
    pub pressure_ratio: f64,
    /// `rho2 / rho1`.
    pub density_ratio: f64,
    /// `T2 / T1`.
    pub temperature_ratio: f64,
    /// First Mach wave, radians above the oncoming stream's direction (turning downwards).
    pub head_angle: f64,
    /// Last Mach wave, radians above the oncoming stream's direction.
    pub tail_angle: f64,
}

/// Expansion of a stream of Mach number `mach` around a convex corner of `turn` radians. A turn
/// beyond the expansion into vacuum is allowed: the gas then turns as far as it can.
pub fn expand(mach: f64, turn: f64, gamma: f64) -> Result<Fan, ExactError> {
    require_gamma(gamma)?;
    require_supersonic(mach)?;
    require(
        turn >= 0.0,
        "the expansion's turn in radians",
        turn,
        "values of zero and above",
    )?;
    let before = prandtl_meyer_angle(mach, gamma);
    let after = (before + turn).min(largest_angle(gamma));
    let behind = mach_from_angle(after, gamma)?;
    let ratios = ratios(mach, behind, gamma);
    Ok(Fan {
        mach: behind,
        pressure_ratio: ratios[0],
        density_ratio: ratios[1],
        temperature_ratio: ratios[2],
        head_angle: (1.0 / mach).asin(),
        tail_angle: (1.0 / behind).asin() - (after - before),
    })
}

/// `p`, `rho` and `T` at Mach number `to` over those at Mach number `from` of the same stream.
pub fn ratios(from: f64, to: f64, gamma: f64) -> [f64; 3] {
    let temperature =
        isentropic::temperature_ratio(from, gamma) / isentropic::temperature_ratio(to, gamma);
    [
        temperature.powf(gamma / (gamma - 1.0)),
        temperature.powf(1.0 / (gamma - 1.0)),
        temperature,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reference;
    use approx::{assert_abs_diff_eq, assert_relative_eq};
    use proptest::prelude::*;

    #[test]
    fn every_corner_of_the_reference_table_is_reproduced() {
        let table = reference::expansion_corner();
        for row in 0..table.len() {
            let get = |name: &str| table.column(name).unwrap()[row];
            let fan = expand(get("M1"), get("turn_deg").to_radians(), 1.4).unwrap();
            if get("M2").is_infinite() {
                assert!(fan.mach > 1e7 && fan.pressure_ratio < 1e-30);
            } else {
                assert_relative_eq!(fan.mach, get("M2"), max_relative = 1e-7);
                assert_relative_eq!(fan.pressure_ratio, get("p2_p1"), max_relative = 1e-6);
                assert_relative_eq!(fan.density_ratio, get("rho2_rho1"), max_relative = 1e-6);
            }
            let head = fan.head_angle.to_degrees();
            let tail = fan.tail_angle.to_degrees();
            assert_abs_diff_eq!(head, get("head_angle_deg"), epsilon = 1e-6);
            assert_abs_diff_eq!(tail, get("tail_angle_deg"), epsilon = 1e-5);
        }
    }

    #[test]
    fn the_function_agrees_with_the_published_table() {
        // NACA 1135, table II: nu(2) = 26.38 deg, nu(5) = 76.92 deg.
        assert_abs_diff_eq!(
            prandtl_meyer_angle(2.0, 1.4).to_degrees(),
            26.3798,
            epsilon = 1e-4
        );
        assert_abs_diff_eq!(
            prandtl_meyer_angle(5.0, 1.4).to_degrees(),
            76.9202,
            epsilon = 1e-4
        );
        assert_abs_diff_eq!(largest_angle(1.4).to_degrees(), 130.4541, epsilon = 1e-4);
    }

    proptest! {
        #[test]
        fn angle_and_mach_invert_each_other(mach in 1.001_f64..40.0, gamma in 1.1_f64..1.67) {
            let back = mach_from_angle(prandtl_meyer_angle(mach, gamma), gamma).unwrap();
            prop_assert!((back / mach - 1.0).abs() < 1e-7);
        }

        #[test]
        fn an_expansion_speeds_up_cools_and_keeps_total_pressure(
            mach in 1.05_f64..10.0, turn in 0.001_f64..0.8,
        ) {
            let fan = expand(mach, turn, 1.4).unwrap();
            prop_assume!(fan.mach < 1e3);
            prop_assert!(fan.mach > mach && fan.temperature_ratio < 1.0);
            let total = fan.pressure_ratio * isentropic::pressure_ratio(fan.mach, 1.4)
                / isentropic::pressure_ratio(mach, 1.4);
            prop_assert!((total - 1.0).abs() < 1e-9);
        }
    }
}
