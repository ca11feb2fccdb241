//! A diamond at an incidence, by shocks and expansions: exact as long as no wave from one of its sides meets another.
//!
//! Each of its front sides turns the stream through a shock, or where it faces away from it through a fan, each of its rear sides through a
//! fan. Source: Anderson, "Modern Compressible Flow", section 4.15.

use super::oblique::{Strength, oblique_shock};
use super::prandtl_meyer::expand;
use super::shock_expansion::Loads;
use super::{ExactError, require};

/// Pressures on the sides of a diamond, and what they make.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Diamond {
    /// On the front and the rear of the upper face, over the free stream's.
    pub upper: [f64; 2],
    /// The same of the lower face.
    pub lower: [f64; 2],
    /// Coefficients over the chord.
    pub loads: Loads,
    /// Slope of its sides.
    slope: f64,
    /// Coefficient of half a chord under a pressure of one.
    scale: f64,
}

impl Diamond {
    /// Coefficient of the moment about a point of the chord so many chords behind the nose, nose up, on the square of the chord.
    pub fn moment(&self, hinge: f64) -> f64 {
        // Sides are pressed in their middle, half as high as the body; along the chord by their slope.
        let along = 0.25 * self.slope * self.slope;
        let [front, rear] = [0, 1].map(|side| self.upper[side] - self.lower[side]);
        self.scale * (front * (0.25 - hinge + along) + rear * (0.75 - hinge - along))
    }
}

/// A diamond whose sides are inclined by `half_angle` in a stream of Mach number `mach` from below, at `incidence`; radians.
///
/// # Errors
/// Angles that are no diamond's, or through which no attached shock turns the stream.
pub fn diamond(
    half_angle: f64,
    mach: f64,
    incidence: f64,
    gamma: f64,
) -> Result<Diamond, ExactError> {
    require(
        half_angle > 0.0 && half_angle < 0.5,
        "the inclination of a diamond's sides in radians",
        half_angle,
        "values above 0 and below 0.5",
    )?;
    let face = |turn: f64| -> Result<[f64; 2], ExactError> {
        let [pressure, mach] = if turn > 0.0 {
            let shock = oblique_shock(mach, turn, gamma, Strength::Weak)?;
            [shock.pressure_ratio, shock.mach]
        } else {
            let fan = expand(mach, -turn, gamma)?;
            [fan.pressure_ratio, fan.mach]
        };
        let rear = expand(mach, 2.0 * half_angle, gamma)?;
        Ok([pressure, pressure * rear.pressure_ratio])
    };
    let (upper, lower) = (face(half_angle - incidence)?, face(half_angle + incidence)?);
    // Each side is half a chord long along the chord.
    let scale = 1.0 / (gamma * mach * mach);
    let across = scale * (lower[0] + lower[1] - upper[0] - upper[1]);
    let along = scale * half_angle.tan() * (upper[0] + lower[0] - upper[1] - lower[1]);
    let (sine, cosine) = incidence.sin_cos();
    Ok(Diamond {
        upper,
        lower,
        loads: Loads {
            lift: across * cosine - along * sine,
            drag: across * sine + along * cosine,
        },
        slope: half_angle.tan(),
        scale,
    })
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    /// NACA Report 1135 (1953), table II and charts: 1.454 and 2.822 behind shocks that turn a stream of Mach 3 by 5 and by 15 degrees.
    #[test]
    fn the_front_sides_are_those_of_wedges() {
        let [half, incidence] = [10.0_f64, 5.0].map(f64::to_radians);
        let diamond = diamond(half, 3.0, incidence, 1.4).unwrap();
        assert_relative_eq!(diamond.upper[0], 1.453_98, epsilon = 1e-5);
        assert_relative_eq!(diamond.lower[0], 2.821_56, epsilon = 1e-5);
        assert!(diamond.lower[1] < diamond.lower[0]);
    }

    /// Ackeret: a lift of `4 alpha / b` and a drag of `4 (alpha^2 + delta^2) / b`.
    #[test]
    fn a_thin_diamond_is_as_linear_theory_says() {
        let (half, incidence, beta) = (2e-4_f64, 1e-4, 3.0_f64.sqrt());
        let diamond_in_stream = diamond(half, 2.0, incidence, 1.4).unwrap();
        let thin = diamond_in_stream.loads;
        assert_relative_eq!(thin.lift, 4.0 * incidence / beta, max_relative = 2e-3);
        let drag = 4.0 * (incidence * incidence + half * half) / beta;
        assert_relative_eq!(thin.drag, drag, max_relative = 2e-3);
        assert!(diamond(0.3, 1.5, 0.2, 1.4).is_err());
        // The load is in the middle of the chord.
        let about_nose = -0.5 * 4.0 * incidence / beta;
        assert_relative_eq!(
            diamond_in_stream.moment(0.0),
            about_nose,
            max_relative = 2e-3
        );
    }

    /// Second order (Busemann 1935): a thickness of a tenth of the chord draws the load from the middle of the chord to 0.4365 of it at Mach 2.
    #[test]
    fn thickness_draws_the_load_forward() {
        let incidence = 1e-3;
        let thick = diamond(0.1_f64.atan(), 2.0, incidence, 1.4).unwrap();
        let slope = thick.loads.lift / incidence;
        let centre = -thick.moment(0.0) / thick.loads.lift;
        assert!(
            (slope / (4.0 / 3.0_f64.sqrt()) - 1.0).abs() < 0.03,
            "{slope}"
        );
        assert!((centre - 0.4365).abs() < 0.01, "{centre}");
        // All of the load is there, but for what the drag has of it along the chord.
        let held = thick.moment(centre) / thick.loads.lift;
        assert!(held.abs() < 6e-3, "{held}");
    }
    #[test]
    fn the_moment_is_that_of_all_sides() {
        let (half, mach, hinge) = (0.2_f64, 3.0, 0.3);
        let thick = diamond(half, mach, 0.05, 1.4).unwrap();
        let top = 0.5 * half.tan();
        let mut moment = 0.0;
        for (pressures, up) in [(thick.upper, 1.0), (thick.lower, -1.0)] {
            let corners = [[0.0, 0.0], [0.5, up * top], [1.0, 0.0]];
            for (ends, pressure) in corners.windows(2).zip(pressures) {
                let way = [ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]];
                let arm = [
                    0.5 * (ends[0][0] + ends[1][0]) - hinge,
                    0.5 * (ends[0][1] + ends[1][1]),
                ];
                let force = [up * way[1] * pressure, -up * way[0] * pressure];
                // Nose up is clockwise, the nose at the origin.
                moment -= arm[0] * force[1] - arm[1] * force[0];
            }
        }
        moment /= 0.5 * 1.4 * mach * mach;
        assert_relative_eq!(thick.moment(hinge), moment, max_relative = 1e-12);
    }
}
