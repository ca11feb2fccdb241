//! Regular refraction of a plane shock at a plane interface between two perfect gases.
//!
//! Source: L. F. Henderson, "The refraction of a plane shock wave at a gas interface", J. Fluid Mech. 26 (1966) 607-637
//! (doi:10.1017/S0022112066001435): seen from the point where the waves meet, both streams are turned by the same angle to the same
//! pressure.

use super::oblique::{Strength, oblique_shock, shock_at_angle};
use super::prandtl_meyer::expand;
use super::root::bracketed_root;
use super::{ExactError, State, require};

/// What a shock leaves behind it at the interface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Refraction {
    /// Angle by which the interface is turned, radians.
    pub turn: f64,
    /// Pressure on both sides of it.
    pub pressure: f64,
    /// Density on the side that the shock came from.
    pub density_behind: f64,
    /// Density on the other side.
    pub density_ahead: f64,
    /// Angle between the transmitted shock and the interface before it came, radians.
    pub transmitted: f64,
    /// Speed at which the point where the waves meet runs along the interface.
    pub speed: f64,
}

/// The refraction of a shock of Mach number `mach` that makes an `angle` (radians) with the interface between gas at rest in the states
/// `behind`, from where it comes, and `ahead`, of one pressure; `gammas` are their ratios of specific heats.
///
/// # Errors
/// Where the waves do not meet in one point.
pub fn refraction(
    mach: f64,
    angle: f64,
    [behind, ahead]: [State; 2],
    gammas: [f64; 2],
) -> Result<Refraction, ExactError> {
    let speed = mach * behind.sound_speed(gammas[0]) / angle.sin();
    let oncoming = speed / ahead.sound_speed(gammas[1]);
    require(
        oncoming > 1.0,
        "the Mach number along the interface",
        oncoming,
        "shocks that both gases run into faster than sound",
    )?;
    let incident = shock_at_angle(mach / angle.sin(), angle, gammas[0])?;
    // By the pressure that the transmitted shock has: how far the interface then is from being one.
    let transmitted = |pressure: f64| {
        let normal = (1.0 + 0.5 * (gammas[1] + 1.0) / gammas[1] * (pressure - 1.0)).sqrt();
        shock_at_angle(oncoming, (normal / oncoming).min(1.0).asin(), gammas[1])
    };
    let reflected = |turn: f64| -> Result<[f64; 2], ExactError> {
        let further = turn - incident.deflection;
        let [pressure, density] = if further >= 0.0 {
            let fan = expand(incident.mach, further, gammas[0])?;
            [fan.pressure_ratio, fan.density_ratio]
        } else {
            let shock = oblique_shock(incident.mach, -further, gammas[0], Strength::Weak)?;
            [shock.pressure_ratio, shock.density_ratio]
        };
        Ok([
            pressure * incident.pressure_ratio,
            density * incident.density_ratio,
        ])
    };
    let excess = |pressure: f64| {
        let turn = transmitted(pressure).map(|shock| shock.deflection);
        turn.and_then(reflected)
            .map_or(f64::INFINITY, |[reflected, _]| reflected - pressure)
    };
    // The most that either gas can be brought to without a second shock from behind it.
    let high = incident.pressure_ratio.powi(2);
    let pressure = bracketed_root(excess, 1.0 + 1e-12, high);
    let shock = transmitted(pressure)?;
    let [other, density] = reflected(shock.deflection)?;
    require(
        (other / pressure - 1.0).abs() < 1e-9,
        "the angle of the shock and the interface in radians",
        angle,
        "waves that meet in one point",
    )?;
    Ok(Refraction {
        turn: shock.deflection,
        pressure: pressure * behind.pressure,
        density_behind: density * behind.density,
        density_ahead: shock.density_ratio * ahead.density,
        transmitted: shock.angle,
        speed,
    })
}

#[cfg(test)]
mod tests {
    use super::super::riemann::Riemann;
    use super::*;
    use approx::assert_relative_eq;

    const AIR: State = State::new(1.2048, 0.0, 101_325.0);
    const HELIUM: State = State::new(0.2191, 0.0, 101_325.0);
    const GAMMAS: [f64; 2] = [1.4, 1.648];

    /// The gas behind a shock of Mach 1.22 in air.
    fn behind() -> State {
        let shock = super::super::normal::normal_shock(1.22, 1.4).unwrap();
        let speed = 1.22 * AIR.sound_speed(1.4) * (1.0 - 1.0 / shock.density_ratio);
        State::new(
            AIR.density * shock.density_ratio,
            speed,
            AIR.pressure * shock.pressure_ratio,
        )
    }

    #[test]
    fn a_shock_that_meets_the_interface_squarely_is_a_riemann_problem() {
        let plane = Riemann::of_two_gases(behind(), HELIUM, GAMMAS).unwrap();
        let star = plane.star().unwrap();
        let found = refraction(1.22, 1e-3, [AIR, HELIUM], GAMMAS).unwrap();
        assert_relative_eq!(found.pressure, star.pressure, max_relative = 1e-5);
        assert_relative_eq!(found.density_ahead, star.density_right, max_relative = 1e-5);
        assert_relative_eq!(found.density_behind, star.density_left, max_relative = 1e-5);
        let speed = found.speed * found.turn;
        assert_relative_eq!(speed, star.velocity, max_relative = 1e-3);
    }

    #[test]
    fn an_interface_between_alike_gases_lets_the_shock_pass_as_it_is() {
        let found = refraction(1.8, 0.6, [AIR, AIR], [1.4; 2]).unwrap();
        let shock = shock_at_angle(1.8 / 0.6_f64.sin(), 0.6, 1.4).unwrap();
        assert_relative_eq!(found.turn, shock.deflection, max_relative = 1e-9);
        assert_relative_eq!(found.transmitted, 0.6, max_relative = 1e-9);
        assert_relative_eq!(
            found.pressure / AIR.pressure,
            shock.pressure_ratio,
            max_relative = 1e-9
        );
    }

    /// A heavier gas sends a shock back.
    #[test]
    fn a_heavy_gas_is_brought_to_more_pressure_than_the_shock_has() {
        let heavy = State::new(6.0, 0.0, AIR.pressure);
        let found = refraction(1.5, 0.4, [AIR, heavy], [1.4, 1.1]).unwrap();
        let shock = shock_at_angle(1.5 / 0.4_f64.sin(), 0.4, 1.4).unwrap();
        assert!(found.pressure > 1.05 * AIR.pressure * shock.pressure_ratio);
        assert!(found.turn < shock.deflection && found.turn > 0.0);
    }

    #[test]
    fn a_shock_that_light_gas_outruns_is_refused() {
        assert!(refraction(1.22, 0.6, [AIR, HELIUM], GAMMAS).is_err());
    }
}
