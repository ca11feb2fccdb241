//! Gas at rest beyond a side, and the state in which it comes in at less than the speed of sound: of the three values that fix
//! that state two come from the gas at rest and one, an acoustic wave on its way out, from the flow inside.

use super::waves::Along;
use crate::problem::Problem;

/// Gas at rest.
#[derive(Clone, Copy, Debug)]
pub struct Plenum {
    /// Pressure.
    pressure: f64,
    /// Square of the speed of sound.
    sound_square: f64,
    gamma: f64,
}

impl Plenum {
    /// At the stagnation state of the free stream of `problem`.
    pub fn of_stream<const D: usize>(problem: &Problem<D>) -> Self {
        Self::of(problem, problem.free_stream.velocity.norm_squared())
    }

    /// Where the free stream comes to rest across `axis` and goes on along the side as it is.
    pub fn before<const D: usize>(problem: &Problem<D>, axis: usize) -> Self {
        Self::of(problem, problem.free_stream.velocity[axis].powi(2))
    }

    /// Where gas of the free stream's state has lost this square of a speed.
    fn of<const D: usize>(problem: &Problem<D>, square: f64) -> Self {
        let gas = &problem.free_stream;
        let gamma = problem.gas.ratio_at(gas.density, gas.pressure);
        let heat = gamma - 1.0;
        let sound_square = gamma * gas.pressure / gas.density;
        // NACA Report 1135 (1953), eqs 43 and 44.
        let rise = 1.0 + 0.5 * heat * square / sound_square;
        Self {
            pressure: gas.pressure * rise.powf(gamma / heat),
            sound_square: sound_square * rise,
            gamma,
        }
    }

    /// As hot, at another pressure.
    #[must_use]
    pub fn at(self, pressure: f64) -> Self {
        Self { pressure, ..self }
    }

    /// Ratio of specific heats.
    pub fn gamma(&self) -> f64 {
        self.gamma
    }

    /// State in which gas enters against the invariant `back` on its way out, see [`entering`].
    pub fn entering(&self, back: f64) -> Along {
        let gamma = self.gamma;
        let (speed, sound) = entering(back, self.sound_square, gamma);
        let share = sound * sound / self.sound_square;
        let pressure = self.pressure * share.powf(gamma / (gamma - 1.0));
        Along {
            density: gamma * pressure / (sound * sound),
            speed,
            pressure,
        }
    }
}

/// Speed, and speed of sound, at which gas of the stagnation speed of sound `sqrt(sound_square)` meets
/// the outgoing invariant `wave = u - 2 c / (gamma - 1)`.
///
/// The constant total enthalpy, `c^2 + (gamma - 1) u^2 / 2 = c_0^2`, makes it a quadratic equation
/// [e.g. Hirsch, Numerical Computation of Internal and External Flows, vol. 2, 1990, section 19.1.2].
/// The speed stays between zero and that of sound: gas neither flows back into the reservoir nor
/// outruns the wave.
fn entering(wave: f64, sound_square: f64, gamma: f64) -> (f64, f64) {
    let heat = gamma - 1.0;
    let critical = (2.0 * sound_square / (gamma + 1.0)).sqrt();
    // u^2 (gamma + 1) / 4 - wave (gamma - 1) u / 2 + (gamma - 1) wave^2 / 4 - c_0^2 / (gamma - 1) = 0, over
    // (gamma - 1), with c = (gamma - 1) (u - wave) / 2.
    let a = 0.25 * (gamma + 1.0);
    let b = -0.5 * heat * wave;
    let c = 0.25 * heat * wave * wave - sound_square / heat;
    let root = (b * b - 4.0 * a * c).max(0.0).sqrt();
    let speed = ((root - b) / (2.0 * a)).clamp(0.0, critical);
    let sound = (sound_square - 0.5 * heat * speed * speed).sqrt();
    (speed, sound)
}

#[cfg(test)]
mod tests {
    use super::*;

    const GAMMA: f64 = 1.4;

    #[test]
    fn a_flow_that_already_fits_the_reservoir_is_left_alone() {
        for mach in [0.0, 0.3, 0.9] {
            let sound_square = 1.0 + 0.2 * mach * mach;
            let (speed, sound) = entering(mach - 5.0, sound_square, GAMMA);
            assert!((speed - mach).abs() < 1e-12, "{mach}: {speed}");
            assert!((sound - 1.0).abs() < 1e-12, "{mach}: {sound}");
        }
    }

    #[test]
    fn higher_pressure_inside_slows_the_inflow_down_to_rest_at_most() {
        let wave = |sound: f64| 0.3 - 5.0 * sound;
        let speed = |sound: f64| entering(wave(sound), 1.018, GAMMA).0;
        assert!(speed(1.01) < speed(1.0) && speed(1.0) < speed(0.99));
        assert_eq!(speed(1.2), 0.0);
    }
}
