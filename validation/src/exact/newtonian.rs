//! Modified Newtonian pressure on blunt bodies, and the drag of a body of revolution from it.
//!
//! A good estimate on windward surfaces at high Mach number, nothing more. Source: Lees,
//! "Hypersonic flow" (1955); Anderson, "Hypersonic and High-Temperature Gas Dynamics", section 3.3.

use super::{isentropic, normal};

/// Pressure coefficient at the stagnation point, from the Rayleigh pitot formula.
pub fn stagnation_coefficient(mach: f64, gamma: f64) -> f64 {
    isentropic::pressure_coefficient(normal::pitot_pressure_ratio(mach, gamma), mach, gamma)
}

/// Pressure coefficient on a surface inclined by `inclination` radians to the stream (a right angle
/// at the stagnation point): `Cp_max sin^2`, zero in the shadow.
pub fn pressure_coefficient(mach: f64, inclination: f64, gamma: f64) -> f64 {
    stagnation_coefficient(mach, gamma) * inclination.sin().max(0.0).powi(2)
}

/// Wall pressure over the stagnation pressure at `angle` radians from the stagnation point of a
/// round nose: `p/p02 = cos^2 + (p_inf/p02) sin^2`, the free stream's pressure in the shadow.
pub fn round_nose_pressure(mach: f64, angle: f64, gamma: f64) -> f64 {
    let free = 1.0 / normal::pitot_pressure_ratio(mach, gamma);
    let facing = angle.cos().max(0.0).powi(2);
    free + (1.0 - free) * facing
}

/// Drag coefficient of the windward part of a body of revolution at no incidence, over the area of
/// its largest section.
///
/// `profile` runs downstream along the surface as `[x, r]`; every straight piece that faces the
/// stream (`dr > 0`) adds `Cp` times its frontal area.
pub fn forebody_drag(profile: &[[f64; 2]], mach: f64, gamma: f64) -> f64 {
    let largest = profile.iter().map(|p| p[1]).fold(0.0, f64::max);
    let mut drag = 0.0;
    for pair in profile.windows(2) {
        let (dx, dr) = (pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]);
        if dr > 0.0 {
            let frontal = pair[1][1] * pair[1][1] - pair[0][1] * pair[0][1];
            drag += pressure_coefficient(mach, dr.atan2(dx), gamma) * frontal;
        }
    }
    if largest > 0.0 {
        drag / (largest * largest)
    } else {
        0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reference;
    use approx::{assert_abs_diff_eq, assert_relative_eq};

    /// The Apollo forebody: heat shield of radius 4.6939 m, then a shoulder of radius 0.1956 m.
    fn apollo() -> Vec<[f64; 2]> {
        let (shield, shoulder) = (4.6939, 0.1956);
        let centre = [0.554_287, 1.760_200];
        let tangent = (1.836_739_f64 / shield).asin();
        let pieces = 2000;
        let arc =
            |k: i32, from: f64, to: f64| from + (to - from) * f64::from(k) / f64::from(pieces);
        let mut profile = Vec::new();
        for k in 0..=pieces {
            let angle = arc(k, 0.0, tangent);
            profile.push([shield * (1.0 - angle.cos()), shield * angle.sin()]);
        }
        for k in 1..=pieces {
            let angle = arc(k, tangent, std::f64::consts::FRAC_PI_2);
            profile.push([
                centre[0] - shoulder * angle.cos(),
                centre[1] + shoulder * angle.sin(),
            ]);
        }
        profile
    }

    #[test]
    fn the_apollo_forebody_agrees_with_the_reference_table() {
        let table = reference::apollo_newtonian();
        for row in 0..table.len() {
            let get = |name: &str| table.column(name).unwrap()[row];
            let maximum = stagnation_coefficient(get("M"), 1.4);
            assert_relative_eq!(maximum, get("Cpmax"), max_relative = 1e-6);
            let drag = forebody_drag(&apollo(), get("M"), 1.4);
            assert_relative_eq!(drag, get("CD_forebody_modNewtonian"), max_relative = 1e-4);
        }
    }

    #[test]
    fn a_hemisphere_has_half_the_stagnation_coefficient() {
        let profile: Vec<[f64; 2]> = (0..=2000)
            .map(|k| std::f64::consts::FRAC_PI_2 * f64::from(k) / 2000.0)
            .map(|a| [1.0 - a.cos(), a.sin()])
            .collect();
        let drag = forebody_drag(&profile, 10.0, 1.4);
        assert_relative_eq!(
            drag,
            0.5 * stagnation_coefficient(10.0, 1.4),
            max_relative = 1e-5
        );
    }

    #[test]
    fn the_cylinder_wall_column_of_the_reference_is_reproduced() {
        let table = reference::cylinder_wall();
        for row in 0..table.len() {
            let get = |name: &str| table.column(name).unwrap()[row];
            let mine = round_nose_pressure(10.0, get("angle_deg").to_radians(), 1.4);
            assert_abs_diff_eq!(mine, get("modNewton_p_p02"), epsilon = 2e-5);
        }
    }

    #[test]
    fn the_shadow_feels_the_free_stream() {
        assert_eq!(pressure_coefficient(5.0, -0.3, 1.4), 0.0);
    }
}
