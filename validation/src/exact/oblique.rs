//! The oblique shock: deflection, wave angle, jump and detachment.
//!
//! Sources: Anderson, "Modern Compressible Flow", eqs. (4.7)-(4.17); NACA Report 1135 (1953),
//! eqs. 128-142 and, for the wave angle at the largest deflection, eq. 168.

use super::normal;
use super::root::bracketed_root;
use super::{ExactError, require, require_gamma, require_supersonic};

/// Which of the two shocks that turn a stream by the same angle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Strength {
    /// The smaller wave angle, the one seen on wedges.
    Weak,
    /// The larger wave angle, with subsonic flow behind.
    Strong,
}

/// The state behind an oblique shock as ratios to the state ahead.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ObliqueShock {
    /// Wave angle from the oncoming stream, radians.
    pub angle: f64,
    /// Angle by which the stream is turned, radians.
    pub deflection: f64,
    /// Mach number of the stream's component normal to the wave.
    pub normal_mach: f64,
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

/// The largest turn that an attached shock can give.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Detachment {
    /// Largest deflection, radians.
    pub deflection: f64,
    /// Its wave angle, radians.
    pub angle: f64,
}

/// Deflection of the stream, radians, by a shock at wave angle `angle` [Anderson, eq. 4.17]:
/// `tan(theta) = 2 cot(beta) (M^2 sin^2(beta) - 1) / (M^2 (gamma + cos(2 beta)) + 2)`.
pub fn deflection(mach: f64, angle: f64, gamma: f64) -> f64 {
    let m2 = mach * mach;
    let over = 2.0 * (m2 * angle.sin().powi(2) - 1.0);
    (over / angle.tan()).atan2(m2 * (gamma + (2.0 * angle).cos()) + 2.0)
}

/// The shock of wave angle `angle` (radians, from the Mach angle to a right angle).
pub fn shock_at_angle(mach: f64, angle: f64, gamma: f64) -> Result<ObliqueShock, ExactError> {
    require_gamma(gamma)?;
    require_supersonic(mach)?;
    require(
        mach * angle.sin() >= 1.0 && angle <= std::f64::consts::FRAC_PI_2 + 1e-12,
        "the wave angle in radians",
        angle,
        "angles from the Mach angle to a right angle",
    )?;
    let normal_mach = mach * angle.sin();
    let shock = normal::jump(normal_mach, gamma);
    let deflection = deflection(mach, angle, gamma);
    Ok(ObliqueShock {
        angle,
        deflection,
        normal_mach,
        mach: shock.mach / (angle - deflection).sin(),
        pressure_ratio: shock.pressure_ratio,
        density_ratio: shock.density_ratio,
        temperature_ratio: shock.temperature_ratio,
        total_pressure_ratio: shock.total_pressure_ratio,
    })
}

/// The shock that turns a stream of Mach number `mach` by `turn` radians (not negative).
pub fn oblique_shock(
    mach: f64,
    turn: f64,
    gamma: f64,
    strength: Strength,
) -> Result<ObliqueShock, ExactError> {
    let limit = detachment(mach, gamma)?;
    require(
        turn >= 0.0,
        "the deflection in radians",
        turn,
        "compressions, not negative",
    )?;
    if turn > limit.deflection {
        return Err(ExactError::Detached {
            mach,
            given_deg: turn.to_degrees(),
            limit_deg: limit.deflection.to_degrees(),
        });
    }
    let end = match strength {
        Strength::Weak => (1.0 / mach).asin(),
        Strength::Strong => std::f64::consts::FRAC_PI_2,
    };
    let excess = |angle: f64| deflection(mach, angle, gamma) - turn;
    let angle = bracketed_root(excess, end, limit.angle);
    // Round-off may leave an infinitely weak wave a bit below the Mach angle.
    shock_at_angle(mach, angle.max((1.0 / mach).asin() * (1.0 + 1e-15)), gamma)
}

/// Largest deflection by an attached shock, and its wave angle [NACA 1135, eq. 168].
pub fn detachment(mach: f64, gamma: f64) -> Result<Detachment, ExactError> {
    require_gamma(gamma)?;
    require_supersonic(mach)?;
    let m2 = mach * mach;
    let quarter = 0.25 * (gamma + 1.0) * m2;
    let under = (gamma + 1.0) * (1.0 + 0.5 * (gamma - 1.0) * m2 + 0.25 * quarter * m2);
    let sine = ((quarter - 1.0 + under.sqrt()) / (gamma * m2)).sqrt();
    let angle = sine.min(1.0).asin();
    Ok(Detachment {
        deflection: deflection(mach, angle, gamma),
        angle,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reference;
    use approx::assert_relative_eq;
    use proptest::prelude::*;

    #[test]
    fn every_wedge_of_the_reference_table_is_reproduced() {
        let table = reference::wedge();
        for row in 0..table.len() {
            let get = |name: &str| table.column(name).unwrap()[row];
            let (mach, gamma, turn) = (get("M"), get("gamma"), get("theta_deg").to_radians());
            let weak = oblique_shock(mach, turn, gamma, Strength::Weak).unwrap();
            let strong = oblique_shock(mach, turn, gamma, Strength::Strong).unwrap();
            let limit = detachment(mach, gamma).unwrap();
            for (mine, name) in [
                (weak.angle.to_degrees(), "beta_deg"),
                (weak.normal_mach, "Mn"),
                (weak.pressure_ratio, "p2_p1"),
                (weak.density_ratio, "rho2_rho1"),
                (weak.temperature_ratio, "T2_T1"),
                (weak.mach, "M2"),
                (weak.total_pressure_ratio, "p02_p01"),
                (strong.angle.to_degrees(), "beta_strong_deg"),
                (limit.deflection.to_degrees(), "theta_max_deg"),
            ] {
                assert_relative_eq!(mine, get(name), max_relative = 1e-7);
            }
        }
    }

    #[test]
    fn the_textbook_example_of_a_ten_degree_wedge_is_reproduced() {
        // Anderson, example 4.1 type: M 3, 20 deg: beta 37.76 deg, M2 1.994, p2/p1 3.771.
        let shock = oblique_shock(3.0, 20_f64.to_radians(), 1.4, Strength::Weak).unwrap();
        assert_relative_eq!(shock.angle.to_degrees(), 37.76, max_relative = 2e-4);
        assert_relative_eq!(shock.mach, 1.994, max_relative = 3e-4);
        assert_relative_eq!(shock.pressure_ratio, 3.771, max_relative = 3e-4);
    }

    #[test]
    fn a_wedge_beyond_detachment_is_refused_with_the_limit() {
        let error = oblique_shock(2.0, 30_f64.to_radians(), 1.4, Strength::Weak).unwrap_err();
        assert!(error.to_string().contains("22.974 deg"), "{error}");
    }

    #[test]
    fn no_turn_gives_a_mach_wave_or_a_normal_shock() {
        let weak = oblique_shock(2.0, 0.0, 1.4, Strength::Weak).unwrap();
        assert_relative_eq!(weak.angle, 0.5_f64.asin(), max_relative = 1e-12);
        assert_relative_eq!(weak.pressure_ratio, 1.0, max_relative = 1e-12);
        let strong = oblique_shock(2.0, 0.0, 1.4, Strength::Strong).unwrap();
        assert_relative_eq!(strong.pressure_ratio, 4.5, max_relative = 1e-12);
    }

    proptest! {
        /// The tangential velocity passes unchanged, and the jump turns the stream by `turn`.
        #[test]
        fn the_velocity_behind_is_turned_and_keeps_its_tangential_part(
            mach in 1.2_f64..20.0, share in 0.05_f64..0.98, gamma in 1.1_f64..1.7,
        ) {
            let turn = share * detachment(mach, gamma).unwrap().deflection;
            for strength in [Strength::Weak, Strength::Strong] {
                let shock = oblique_shock(mach, turn, gamma, strength).unwrap();
                prop_assert!((shock.deflection - turn).abs() < 1e-9);
                let speed = shock.mach * shock.temperature_ratio.sqrt();
                let tangential = speed * (shock.angle - turn).cos();
                prop_assert!((tangential / (mach * shock.angle.cos()) - 1.0).abs() < 1e-7);
                let normal = speed * (shock.angle - turn).sin();
                let flux = shock.density_ratio * normal / shock.normal_mach;
                prop_assert!((flux - 1.0).abs() < 1e-8);
            }
        }

        #[test]
        fn no_wave_angle_turns_more_than_the_detachment_limit(
            mach in 1.1_f64..20.0, share in 0.0_f64..1.0, gamma in 1.1_f64..1.7,
        ) {
            let limit = detachment(mach, gamma).unwrap();
            let low = (1.0 / mach).asin();
            let angle = low + share * (std::f64::consts::FRAC_PI_2 - low);
            prop_assert!(deflection(mach, angle, gamma) <= limit.deflection + 1e-12);
        }
    }
}
