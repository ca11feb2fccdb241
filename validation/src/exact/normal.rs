//! The normal shock and the Rayleigh pitot pressure.
//!
//! Sources: NACA Report 1135 (1953), eqs. 93-100; Anderson, "Modern Compressible Flow", chapter 3.

use super::isentropic;
use super::{ExactError, require_gamma, require_supersonic};

/// The state behind a normal shock as ratios to the state ahead.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NormalShock {
    /// Mach number behind.
    pub mach: f64,
    /// `p2 / p1`.
    pub pressure_ratio: f64,
    /// `rho2 / rho1`.
    pub density_ratio: f64,
    /// `T2 / T1`.
    pub temperature_ratio: f64,
    /// `p02 / p01`, the loss of total pressure.
    pub total_pressure_ratio: f64,
}

/// Jump across a normal shock at Mach number `mach > 1`.
pub fn normal_shock(mach: f64, gamma: f64) -> Result<NormalShock, ExactError> {
    require_gamma(gamma)?;
    require_supersonic(mach)?;
    Ok(jump(mach, gamma))
}

/// The jump relations themselves; an infinitely weak shock (`mach = 1`) gives ratios of 1.
pub(super) fn jump(mach: f64, gamma: f64) -> NormalShock {
    let m2 = mach * mach;
    let pressure_ratio = 1.0 + 2.0 * gamma / (gamma + 1.0) * (m2 - 1.0);
    let density_ratio = (gamma + 1.0) * m2 / (2.0 + (gamma - 1.0) * m2);
    let behind = ((1.0 + 0.5 * (gamma - 1.0) * m2) / (gamma * m2 - 0.5 * (gamma - 1.0))).sqrt();
    let total_pressure_ratio = pressure_ratio * isentropic::pressure_ratio(behind, gamma)
        / isentropic::pressure_ratio(mach, gamma);
    NormalShock {
        mach: behind,
        pressure_ratio,
        density_ratio,
        temperature_ratio: pressure_ratio / density_ratio,
        total_pressure_ratio,
    }
}

/// What a blunt body's stagnation point feels over the free stream's pressure, `p02 / p1`: behind a
/// normal shock if the stream is supersonic [Rayleigh; NACA 1135, eq. 100], else isentropic.
pub fn pitot_pressure_ratio(mach: f64, gamma: f64) -> f64 {
    if mach <= 1.0 {
        return isentropic::pressure_ratio(mach, gamma);
    }
    let shock = jump(mach, gamma);
    shock.pressure_ratio * isentropic::pressure_ratio(shock.mach, gamma)
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use proptest::prelude::*;

    #[test]
    fn mach_two_agrees_with_the_published_tables() {
        // NACA 1135, table II, rounded there to four figures.
        let shock = normal_shock(2.0, 1.4).unwrap();
        assert_relative_eq!(shock.pressure_ratio, 4.5, max_relative = 1e-12);
        assert_relative_eq!(shock.density_ratio, 8.0 / 3.0, max_relative = 1e-12);
        assert_relative_eq!(shock.mach, 0.577_35, max_relative = 1e-5);
        assert_relative_eq!(shock.total_pressure_ratio, 0.720_874, max_relative = 1e-5);
        assert_relative_eq!(
            pitot_pressure_ratio(2.0, 1.4),
            5.640_44,
            max_relative = 1e-6
        );
    }

    #[test]
    fn mach_ten_stagnation_agrees_with_the_blunt_body_figures() {
        assert_relative_eq!(
            pitot_pressure_ratio(10.0, 1.4),
            129.216_97,
            max_relative = 1e-7
        );
    }

    #[test]
    fn the_pitot_formula_is_continuous_at_sonic_speed() {
        let below = pitot_pressure_ratio(1.0 - 1e-9, 1.4);
        let above = pitot_pressure_ratio(1.0 + 1e-9, 1.4);
        assert_relative_eq!(below, above, max_relative = 1e-7);
    }

    #[test]
    fn a_subsonic_stream_is_refused() {
        assert_eq!(
            normal_shock(0.8, 1.4).unwrap_err(),
            ExactError::Subsonic { mach: 0.8 }
        );
    }

    proptest! {
        /// In units of p1 = rho1 = 1: mass, momentum and total enthalpy are the same on both sides.
        #[test]
        fn mass_momentum_and_energy_pass_through(mach in 1.001_f64..30.0, gamma in 1.05_f64..1.8) {
            let shock = normal_shock(mach, gamma).unwrap();
            let u1 = mach * gamma.sqrt();
            let c2 = (gamma * shock.pressure_ratio / shock.density_ratio).sqrt();
            let u2 = shock.mach * c2;
            prop_assert!((shock.density_ratio * u2 / u1 - 1.0).abs() < 1e-10);
            let ahead = 1.0 + u1 * u1;
            let behind = shock.pressure_ratio + shock.density_ratio * u2 * u2;
            prop_assert!((behind / ahead - 1.0).abs() < 1e-10);
            let enthalpy = |t: f64, u: f64| gamma / (gamma - 1.0) * t + 0.5 * u * u;
            let ratio = enthalpy(shock.temperature_ratio, u2) / enthalpy(1.0, u1);
            prop_assert!((ratio - 1.0).abs() < 1e-10);
            prop_assert!(shock.total_pressure_ratio < 1.0);
        }
    }
}
