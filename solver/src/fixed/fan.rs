//! Gas that turns away from a wall within a cell: the steady fan behind a sharp bend.

use super::calmness::share;
use super::gas::Gas;
use super::state::Primitive;

/// Square of the Mach number along the wall below which gas knows of the bend ahead, and no fan stands at it.
const SONIC: f64 = 1.0;

/// The same above which a fan alone turns the gas.
const SUPERSONIC: f64 = 2.0;

/// Steps in which gas turns.
const STEPS: usize = 8;

/// Least `M^2 - 1` in a step: at the speed of sound a turn changes pressure without bound.
const LEAST: f64 = 1e-3;

/// Gas beside a wall that it moves away from.
#[derive(Clone, Copy, Debug)]
pub struct Departing {
    /// Its speed along the wall, in the direction in which it turns.
    pub along: f64,
    /// Its speed away from the wall.
    pub away: f64,
}

/// Pressure and density of gas on its way, and the square of its speed.
#[derive(Clone, Copy)]
struct Turned {
    density: f64,
    pressure: f64,
    square: f64,
}

impl Departing {
    /// Part of the turn that a steady fan makes: from none below the speed of sound to all.
    pub fn share(&self, sound_square: f64) -> f64 {
        if self.away <= 0.0 {
            return 0.0;
        }
        share(self.along * self.along / sound_square, SONIC, SUPERSONIC)
    }

    /// Pressure on the wall once gas in the state of `cell` has turned to it in a simple wave, `dp = -rho u^2 / sqrt(M^2 - 1) dtheta`
    /// [Anderson, Modern Compressible Flow (2003), eq. 4.35, with `dp = -rho u du`].
    ///
    /// It is the same for all states of the fan: what of it a cell holds does not matter.
    pub fn pressure<G: Gas, const D: usize>(&self, gas: &G, cell: &Primitive<D>) -> f64 {
        let angle = self.away.atan2(self.along.abs()) / STEPS as f64;
        let mut gone = Turned {
            density: cell.density,
            pressure: cell.pressure,
            square: self.along * self.along + self.away * self.away,
        };
        for _ in 0..STEPS {
            let half = gone.after(gas, &gone, 0.5 * angle);
            gone = gone.after(gas, &half, angle);
        }
        gone.pressure
    }
}

impl Turned {
    /// After a turn by `angle` at the rates of gas in the state `by`.
    fn after<G: Gas>(self, gas: &G, by: &Self, angle: f64) -> Self {
        let sound = gas.sound_square(by.density, by.pressure);
        let (heat, square) = (by.pressure / by.density, by.square);
        let fall = square / heat / (square / sound - 1.0).max(LEAST).sqrt() * angle;
        Self {
            density: self.density * (-fall * heat / sound).exp(),
            pressure: self.pressure * (-fall).exp(),
            square: self.square + 2.0 * heat * fall,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::gas::IdealGas;
    use super::*;

    const AIR: IdealGas = IdealGas { gamma: 1.4 };

    /// Pressure behind a turn by `degrees` of a stream at this Mach number, over its own.
    fn behind(mach: f64, degrees: f64) -> f64 {
        let (away, along) = degrees.to_radians().sin_cos();
        let cell = Primitive {
            density: 1.4,
            velocity: [mach, 0.0],
            pressure: 1.0,
        };
        let departing = Departing {
            along: mach * along,
            away: mach * away,
        };
        departing.pressure(&AIR, &cell)
    }

    /// Prandtl and Meyer (NACA Report 1135, 1953, table II).
    #[test]
    fn gas_that_turns_has_the_pressure_of_a_fan() {
        for (mach, degrees, ratio) in [
            (1.5, 10.0, 0.600_003),
            (2.0, 15.0, 0.393_068),
            (3.0, 20.0, 0.159_650),
            (4.0, 10.0, 0.330_083),
        ] {
            let off = behind(mach, degrees) / ratio - 1.0;
            assert!(off.abs() < 1e-3, "Mach {mach}, {degrees} degrees: {off}");
        }
    }

    #[test]
    fn all_of_a_fan_meets_the_wall_alike() {
        let whole = behind(2.0, 15.0);
        // Halfway through the fan: 7.5 degrees turned at Mach 2.2766.
        let halfway = behind(2.0, 7.5) * behind(2.276_6, 7.5);
        assert!((halfway / whole - 1.0).abs() < 1e-3, "{halfway} {whole}");
    }

    #[test]
    fn no_fan_stands_in_gas_that_is_slower_than_sound_or_comes_to_the_wall() {
        let share = |along: f64, away: f64| Departing { along, away }.share(1.0);
        assert_eq!(
            [share(0.9, 0.1), share(3.0, -0.1), share(3.0, 0.0)],
            [0.0; 3]
        );
        assert_eq!([share(1.5, 0.1), share(-1.5, 0.1)], [1.0; 2]);
        assert!((share(1.5_f64.sqrt(), 0.1) - 0.5).abs() < 1e-12);
    }
}
