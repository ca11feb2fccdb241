//! Supersonic flow over a circular cone at no incidence (Taylor-Maccoll).
//!
//! Sources: Taylor & Maccoll, Proc. R. Soc. A 139 (1933) 278 (doi:10.1098/rspa.1933.0017); the
//! equation as in Anderson, "Modern Compressible Flow", section 10.3; tables to compare with:
//! Sims, NASA SP-3004 (1964).

use super::oblique::shock_at_angle;
use super::root::{bracketed_maximum, bracketed_root};
use super::{ExactError, isentropic, require, require_gamma, require_supersonic};

/// Integration steps from the shock to the cone: fourth order leaves an error near 1e-11.
const STEPS: usize = 400;

/// Flow on a cone's surface and the shock that makes it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConeFlow {
    /// Half-angle of the shock, radians.
    pub shock_angle: f64,
    /// Half-angle of the cone, radians.
    pub cone_angle: f64,
    /// Mach number on the surface.
    pub surface_mach: f64,
    /// Surface pressure over the free stream's.
    pub pressure_ratio: f64,
    /// Surface density over the free stream's.
    pub density_ratio: f64,
    /// Surface pressure coefficient.
    pub pressure_coefficient: f64,
}

/// Flow over the cone of half-angle `cone_angle` radians (weak shock) at Mach number `mach`.
pub fn cone_flow(mach: f64, cone_angle: f64, gamma: f64) -> Result<ConeFlow, ExactError> {
    let limit = detachment(mach, gamma)?;
    require(
        cone_angle > 0.0,
        "the cone's half-angle in radians",
        cone_angle,
        "positive angles",
    )?;
    if cone_angle > limit.cone_angle {
        return Err(ExactError::Detached {
            mach,
            given_deg: cone_angle.to_degrees(),
            limit_deg: limit.cone_angle.to_degrees(),
        });
    }
    let excess = |angle: f64| cone_of_shock(mach, angle, gamma).0 - cone_angle;
    let angle = bracketed_root(excess, lowest_angle(mach), limit.shock_angle);
    surface(mach, angle, gamma)
}

/// The bluntest cone with an attached shock, and its flow.
pub fn detachment(mach: f64, gamma: f64) -> Result<ConeFlow, ExactError> {
    require_gamma(gamma)?;
    require_supersonic(mach)?;
    let cone = |angle: f64| cone_of_shock(mach, angle, gamma).0;
    let top = bracketed_maximum(cone, lowest_angle(mach), std::f64::consts::FRAC_PI_2 - 1e-6);
    surface(mach, top, gamma)
}

/// Just above the Mach angle, where the shock has no strength.
fn lowest_angle(mach: f64) -> f64 {
    (1.0 / mach).asin() + 1e-9
}

/// Surface values for the cone that makes a shock of half-angle `shock_angle`.
fn surface(mach: f64, shock_angle: f64, gamma: f64) -> Result<ConeFlow, ExactError> {
    let shock = shock_at_angle(mach, shock_angle, gamma)?;
    let (cone_angle, speed) = cone_of_shock(mach, shock_angle, gamma);
    // speed is a fraction of the largest possible: V^2 = (gamma-1)/2 M^2 / (1 + (gamma-1)/2 M^2).
    let surface_mach = (2.0 / (gamma - 1.0) * speed * speed / (1.0 - speed * speed)).sqrt();
    let temperature = isentropic::temperature_ratio(shock.mach, gamma)
        / isentropic::temperature_ratio(surface_mach, gamma);
    let pressure_ratio = shock.pressure_ratio * temperature.powf(gamma / (gamma - 1.0));
    Ok(ConeFlow {
        shock_angle,
        cone_angle,
        surface_mach,
        pressure_ratio,
        density_ratio: shock.density_ratio * temperature.powf(1.0 / (gamma - 1.0)),
        pressure_coefficient: isentropic::pressure_coefficient(pressure_ratio, mach, gamma),
    })
}

/// Half-angle of the cone behind a conical shock, and the gas speed on it over the largest
/// possible; the ray where the velocity across rays vanishes.
fn cone_of_shock(mach: f64, shock_angle: f64, gamma: f64) -> (f64, f64) {
    let Ok(shock) = shock_at_angle(mach, shock_angle, gamma) else {
        return (0.0, 0.0);
    };
    let speed = (2.0 / ((gamma - 1.0) * shock.mach * shock.mach) + 1.0)
        .sqrt()
        .recip();
    let inward = shock_angle - shock.deflection;
    let mut v = [speed * inward.cos(), -speed * inward.sin()];
    let mut angle = shock_angle;
    let step = -shock_angle / STEPS as f64;
    for _ in 0..STEPS {
        let next = runge_kutta(angle, v, step, gamma);
        if next[1] >= 0.0 || !next[1].is_finite() || angle + step <= 0.0 {
            let share = bracketed_root(|f| runge_kutta(angle, v, f * step, gamma)[1], 0.0, 1.0);
            let wall = runge_kutta(angle, v, share * step, gamma);
            return (angle + share * step, wall[0]);
        }
        v = next;
        angle += step;
    }
    (0.0, v[0])
}

/// One step of the classical fourth-order method.
fn runge_kutta(angle: f64, v: [f64; 2], step: f64, gamma: f64) -> [f64; 2] {
    let add = |k: [f64; 2], f: f64| [v[0] + f * k[0], v[1] + f * k[1]];
    let k1 = taylor_maccoll(angle, v, gamma);
    let k2 = taylor_maccoll(angle + 0.5 * step, add(k1, 0.5 * step), gamma);
    let k3 = taylor_maccoll(angle + 0.5 * step, add(k2, 0.5 * step), gamma);
    let k4 = taylor_maccoll(angle + step, add(k3, step), gamma);
    let mean = |c: usize| (k1[c] + 2.0 * k2[c] + 2.0 * k3[c] + k4[c]) / 6.0;
    [v[0] + step * mean(0), v[1] + step * mean(1)]
}

/// `d(v_r, v_theta)/d theta` of conical flow, speeds over the largest possible, with
/// `k = (gamma-1)/2 (1 - v_r^2 - v_theta^2)` (half the square of the sound speed):
/// `v_r' = v_theta`, `v_theta' = [v_r v_theta^2 - k (2 v_r + v_theta cot(theta))] / (k - v_theta^2)`.
fn taylor_maccoll(angle: f64, [along, across]: [f64; 2], gamma: f64) -> [f64; 2] {
    let k = 0.5 * (gamma - 1.0) * (1.0 - along * along - across * across);
    let over = along * across * across - k * (2.0 * along + across / angle.tan());
    [across, over / (k - across * across)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reference;
    use approx::{assert_abs_diff_eq, assert_relative_eq};

    #[test]
    fn every_cone_of_the_reference_table_is_reproduced() {
        let table = reference::cones();
        for row in 0..table.len() {
            let get = |name: &str| table.column(name).unwrap()[row];
            let angle = get("cone_half_angle_deg").to_radians();
            let flow = cone_flow(get("M"), angle, 1.4).unwrap();
            let shock = flow.shock_angle.to_degrees();
            assert_abs_diff_eq!(shock, get("shock_deg"), epsilon = 1e-4);
            assert_relative_eq!(flow.surface_mach, get("M_surface"), max_relative = 1e-5);
            assert_relative_eq!(flow.pressure_ratio, get("pc_p1"), max_relative = 1e-5);
            assert_relative_eq!(flow.density_ratio, get("rhoc_rho1"), max_relative = 1e-5);
            assert_relative_eq!(flow.pressure_coefficient, get("Cp"), max_relative = 2e-5);
        }
    }

    #[test]
    fn the_detachment_angles_agree_with_the_reference_table() {
        let table = reference::detachment();
        for row in 0..table.len() {
            let get = |name: &str| table.column(name).unwrap()[row];
            let limit = detachment(get("M"), 1.4).unwrap().cone_angle.to_degrees();
            assert_abs_diff_eq!(limit, get("theta_max_cone_deg"), epsilon = 2e-3);
        }
    }

    #[test]
    fn a_cone_needs_a_weaker_shock_than_the_wedge_of_the_same_angle() {
        use crate::exact::oblique::{Strength, oblique_shock};
        let angle = 20_f64.to_radians();
        let cone = cone_flow(2.0, angle, 1.4).unwrap();
        let wedge = oblique_shock(2.0, angle, 1.4, Strength::Weak).unwrap();
        assert!(cone.shock_angle < wedge.angle);
    }

    #[test]
    fn a_cone_too_blunt_is_refused() {
        let error = cone_flow(2.0, 45_f64.to_radians(), 1.4).unwrap_err();
        assert!(error.to_string().contains("detaches"), "{error}");
    }
}
