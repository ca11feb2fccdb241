//! A piston set impulsively to a constant speed in a tube of gas at rest: a shock when it
//! advances, a centred fan (and beyond its limit a vacuum) when it withdraws.
//!
//! Source: Anderson, "Modern Compressible Flow", chapter 7; Courant & Friedrichs,
//! "Supersonic Flow and Shock Waves" (1948), chapter III.

use super::{ExactError, State, require, require_gamma};

/// A piston that starts at `x = 0` at `t = 0` and moves at `speed` for ever; gas lies at `x > 0`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piston {
    speed: f64,
    rest: State,
    gamma: f64,
}

impl Piston {
    /// Piston of velocity `speed` (positive into the gas) against gas of `density` and `pressure`.
    pub fn new(speed: f64, density: f64, pressure: f64, gamma: f64) -> Result<Self, ExactError> {
        require_gamma(gamma)?;
        require(
            speed.is_finite(),
            "the piston's speed",
            speed,
            "finite values",
        )?;
        require(
            density > 0.0,
            "the density at rest",
            density,
            "positive values",
        )?;
        require(
            pressure > 0.0,
            "the pressure at rest",
            pressure,
            "positive values",
        )?;
        Ok(Self {
            speed,
            rest: State::new(density, 0.0, pressure),
            gamma,
        })
    }

    /// Speed of the wave's front: the shock, or the head of the fan at the speed of sound.
    ///
    /// Shock: `W = (gamma+1)/4 u + sqrt(((gamma+1)/4 u)^2 + c^2)`.
    pub fn front_speed(&self) -> f64 {
        let c = self.rest.sound_speed(self.gamma);
        let lean = 0.25 * (self.gamma + 1.0) * self.speed.max(0.0);
        lean + lean.hypot(c)
    }

    /// Speed of the fan's tail, `c - (gamma+1)/2 |u|`; none ahead of an advancing piston. Beyond
    /// the escape speed it is that of the vacuum's edge.
    pub fn tail_speed(&self) -> Option<f64> {
        (self.speed < 0.0).then(|| {
            let c = self.rest.sound_speed(self.gamma);
            c + 0.5 * (self.gamma + 1.0) * self.speed.max(-self.escape_speed())
        })
    }

    /// Largest speed at which the gas can follow, `2 c / (gamma - 1)`.
    pub fn escape_speed(&self) -> f64 {
        2.0 * self.rest.sound_speed(self.gamma) / (self.gamma - 1.0)
    }

    /// Gas at the piston's face; a vacuum if it withdraws faster than the gas can follow.
    pub fn face(&self) -> State {
        if self.speed <= 0.0 {
            return self.expanded(self.speed.max(-self.escape_speed()));
        }
        let front = self.front_speed();
        State::new(
            self.rest.density * front / (front - self.speed),
            self.speed,
            self.rest.pressure + self.rest.density * front * self.speed,
        )
    }

    /// Gas at `x` (in front of the piston) at time `t > 0`.
    pub fn at(&self, x: f64, t: f64) -> State {
        let ray = x / t;
        let c = self.rest.sound_speed(self.gamma);
        match self.tail_speed() {
            _ if ray >= self.front_speed() => self.rest,
            None => self.face(),
            Some(tail) if ray <= tail => self.face(),
            Some(_) => self.expanded(2.0 / (self.gamma + 1.0) * (ray - c)),
        }
    }

    /// Gas brought from rest to velocity `u <= 0` by a simple wave: `c = c0 + (gamma-1)/2 u`.
    fn expanded(&self, u: f64) -> State {
        let ratio = (1.0 + u / self.escape_speed()).max(0.0);
        State::new(
            self.rest.density * ratio.powf(2.0 / (self.gamma - 1.0)),
            u,
            self.rest.pressure * ratio.powf(2.0 * self.gamma / (self.gamma - 1.0)),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reference;
    use approx::{assert_abs_diff_eq, assert_relative_eq};
    use proptest::prelude::*;

    #[test]
    fn the_reference_table_of_pistons_is_reproduced() {
        let table = reference::piston();
        for row in 0..table.len() {
            let get = |name: &str| table.column(name).unwrap()[row];
            // The table is for rho 1.4, p 1, so that the speed of sound at rest is 1.
            let piston = Piston::new(get("u_piston"), 1.4, 1.0, 1.4).unwrap();
            let face = piston.face();
            let wave = piston.tail_speed().unwrap_or_else(|| piston.front_speed());
            assert_abs_diff_eq!(wave, get("wave_speed"), epsilon = 1e-6 * wave.abs() + 1e-9);
            assert_relative_eq!(
                face.pressure,
                get("p"),
                max_relative = 1e-6,
                epsilon = 1e-100
            );
            assert_relative_eq!(
                face.density,
                get("rho"),
                max_relative = 1e-6,
                epsilon = 1e-70
            );
        }
    }

    #[test]
    fn a_withdrawing_piston_leaves_a_continuous_fan() {
        let piston = Piston::new(-0.8, 1.0, 1.0, 1.4).unwrap();
        let c = 1.4_f64.sqrt();
        assert_relative_eq!(
            piston.at(0.999_999 * c, 1.0).density,
            1.0,
            max_relative = 1e-5
        );
        let tail = piston.tail_speed().unwrap();
        assert_relative_eq!(
            piston.at(tail + 1e-9, 1.0).pressure,
            piston.face().pressure,
            max_relative = 1e-7
        );
    }

    #[test]
    fn a_piston_faster_than_the_escape_speed_leaves_a_vacuum() {
        let piston = Piston::new(-10.0, 1.4, 1.0, 1.4).unwrap();
        assert_eq!(piston.face().density, 0.0);
        assert_relative_eq!(piston.tail_speed().unwrap(), -5.0, max_relative = 1e-12);
    }

    proptest! {
        #[test]
        fn the_piston_shock_obeys_the_normal_shock_relations(
            speed in 0.01_f64..30.0, gamma in 1.1_f64..1.67,
        ) {
            let piston = Piston::new(speed, 1.0, 1.0, gamma).unwrap();
            let mach = piston.front_speed() / gamma.sqrt();
            let shock = super::super::normal::normal_shock(mach, gamma).unwrap();
            prop_assert!((piston.face().pressure / shock.pressure_ratio - 1.0).abs() < 1e-9);
            prop_assert!((piston.face().density / shock.density_ratio - 1.0).abs() < 1e-9);
        }
    }
}
