//! A piston that leaves rest with constant acceleration: the isentropic simple wave ahead of it.
//!
//! Advancing, the wave steepens and the solution ends when the first shock forms; withdrawing, it
//! holds until the gas can no longer follow. Source: Courant & Friedrichs, "Supersonic Flow and
//! Shock Waves" (1948), chapter III.

use super::{ExactError, State, require, require_gamma};

/// A piston at `x = a t^2 / 2`, gas at rest in front of it (`x > 0`) at `t = 0`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AcceleratingPiston {
    acceleration: f64,
    rest: State,
    gamma: f64,
}

impl AcceleratingPiston {
    /// Piston of acceleration `acceleration` (positive into the gas, not zero) against gas of
    /// `density` and `pressure`.
    pub fn new(
        acceleration: f64,
        density: f64,
        pressure: f64,
        gamma: f64,
    ) -> Result<Self, ExactError> {
        require_gamma(gamma)?;
        require(
            acceleration != 0.0 && acceleration.is_finite(),
            "the piston's acceleration",
            acceleration,
            "finite values other than zero",
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
            acceleration,
            rest: State::new(density, 0.0, pressure),
            gamma,
        })
    }

    /// The solution's last moment: the first shock, `2 c / ((gamma+1) a)`, or, withdrawing, the
    /// escape of the gas, `2 c / ((gamma-1) |a|)`.
    pub fn valid_until(&self) -> f64 {
        let c = self.rest.sound_speed(self.gamma);
        let slack = if self.acceleration > 0.0 {
            self.gamma + 1.0
        } else {
            self.gamma - 1.0
        };
        2.0 * c / (slack * self.acceleration.abs())
    }

    /// Gas at `x` at time `t`, `0 <= t <= valid_until`; behind the piston's face, the face's gas.
    ///
    /// The wave sent off at time `s` carries `u = a s`, `c = c0 + (gamma-1)/2 u`, and reaches
    /// `x = a s^2/2 + (u + c)(t - s)`: a quadratic for `s`.
    pub fn at(&self, x: f64, t: f64) -> Result<State, ExactError> {
        require(
            (0.0..=self.valid_until() * (1.0 + 1e-12)).contains(&t),
            "the time",
            t,
            "times before the first shock or vacuum",
        )?;
        let c = self.rest.sound_speed(self.gamma);
        if x >= c * t {
            return Ok(self.rest);
        }
        let lean = 0.5 * (self.gamma + 1.0) * self.acceleration;
        // A s^2 + B s + C = 0, written so that the wanted root is the one near s = 0 at the front.
        let quadratic = 0.5 * self.acceleration - lean;
        let linear = lean * t - c;
        let constant = c * t - x;
        let discriminant = (linear * linear - 4.0 * quadratic * constant)
            .max(0.0)
            .sqrt();
        let sent = (-2.0 * constant / (linear - discriminant)).clamp(0.0, t);
        let u = self.acceleration * sent;
        let ratio = (1.0 + 0.5 * (self.gamma - 1.0) * u / c).max(0.0);
        Ok(State::new(
            self.rest.density * ratio.powf(2.0 / (self.gamma - 1.0)),
            u,
            self.rest.pressure * ratio.powf(2.0 * self.gamma / (self.gamma - 1.0)),
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reference;
    use approx::{assert_abs_diff_eq, assert_relative_eq};

    #[test]
    fn the_reference_profiles_are_reproduced() {
        let table = reference::accelerating_piston();
        for row in 0..table.len() {
            let get = |name: &str| table.column(name).unwrap()[row];
            let piston = AcceleratingPiston::new(get("a"), 1.4, 1.0, 1.4).unwrap();
            let state = piston.at(get("x"), get("t")).unwrap();
            assert_relative_eq!(state.density, get("rho"), max_relative = 1e-6);
            assert_abs_diff_eq!(state.velocity, get("u"), epsilon = 1e-6);
            assert_relative_eq!(state.pressure, get("p"), max_relative = 1e-6);
        }
    }

    #[test]
    fn the_gas_at_the_face_moves_with_the_piston() {
        for acceleration in [1.0, -1.0] {
            let piston = AcceleratingPiston::new(acceleration, 1.4, 1.0, 1.4).unwrap();
            let state = piston.at(0.5 * acceleration * 0.25, 0.5).unwrap();
            assert_relative_eq!(state.velocity, 0.5 * acceleration, max_relative = 1e-10);
        }
    }

    #[test]
    fn times_after_the_first_shock_are_refused() {
        let piston = AcceleratingPiston::new(1.0, 1.4, 1.0, 1.4).unwrap();
        assert_relative_eq!(piston.valid_until(), 2.0 / 2.4, max_relative = 1e-12);
        assert!(piston.at(0.5, 0.9).is_err());
    }
}
