//! Walls ahead of a sharp concave bend, or of a blunt edge ([`super::brinks`]), in the cell that holds it.
//!
//! A shock stands at the bend. Gas faster than sound slides along the wall ahead of it as if nothing were to come, and presses on that wall as in the
//! cells before; the cell that the bend lies in holds gas of both sides of the shock, in parts that depend on where in it the bend lies.

use super::bend::Kink;
use super::equation_of_state::EquationOfState;
use super::fan::{SONIC, SUPERSONIC, rise};
use super::net::Block;
use super::slopes::{Flow, Slopes};
use super::state::{Primitive, dot};

/// Part of the largest turn that a shock at the bend may make from which on it may stand ahead of the bend.
const NEARLY: f64 = 0.95;

impl<const D: usize> Kink<D> {
    /// How far gas in the state `front` meets the bend without knowing of it: from not at all, where it is slower than sound or its shock stands
    /// ahead of the bend, to one.
    fn share<G: EquationOfState>(&self, gas: &G, front: &Primitive<D>) -> f64 {
        let sound = gas.sound_square(front.density, front.pressure);
        let gamma = sound * front.density / front.pressure;
        let towards = dot(&front.velocity, &self.before);
        if towards <= 0.0 {
            return 0.0;
        }
        let fast = rise(towards * towards / sound, SONIC, SUPERSONIC);
        let Some(along) = &self.along else {
            return fast;
        };
        let speed = dot(&front.velocity, &front.velocity);
        let cosine = dot(&front.velocity, along) / speed.sqrt();
        let turn = cosine.clamp(-1.0, 1.0).acos();
        let largest = largest_turn(speed / sound, gamma);
        fast * (1.0 - rise(turn, NEARLY * largest, largest))
    }
}

/// Lets the gas ahead say what presses on the walls of a block before their bends; `pressures` are the usual ones.
pub fn hold<G: EquationOfState, const D: usize>(
    gas: &G,
    block: &Block<D>,
    flow: Flow<'_, D>,
    pressures: &mut [f64],
) {
    for kink in &block.kinks {
        let front = &flow.states[kink.donor as usize];
        let share = kink.share(gas, front);
        if share > 0.0 {
            let ahead = if let Some(wall) = &kink.pressed {
                let Slopes { along, calmness } = &flow.slopes[kink.donor as usize];
                wall.pressure(gas, front, along, *calmness)
            } else {
                let normal = &block.walls[kink.wall].image.normal;
                let speed = dot(&front.velocity, normal);
                gas.wall_pressure(front.density, front.pressure, speed)
            };
            let pressure = &mut pressures[kink.wall];
            *pressure += share * (ahead - *pressure);
        }
    }
}

/// The largest angle by which an oblique shock turns gas of this square of the Mach number [NACA Report 1135 (1953), eqs 138 and 168].
fn largest_turn(mach_square: f64, gamma: f64) -> f64 {
    if mach_square <= 1.0 {
        return 0.0;
    }
    let m = mach_square;
    let root = ((gamma + 1.0) * ((gamma + 1.0) * m * m + 8.0 * (gamma - 1.0) * m + 16.0)).sqrt();
    let sine_square = ((gamma + 1.0) * m - 4.0 + root) / (4.0 * gamma * m);
    let across = m * sine_square - 1.0;
    let cotangent = (1.0 / sine_square - 1.0).sqrt();
    (2.0 * cotangent * across / (m * (gamma + 1.0 - 2.0 * sine_square) + 2.0)).atan()
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;
    use crate::gas::IdealGas;

    const AIR: IdealGas = IdealGas::new(1.4);

    /// A stream that meets a bend of so many degrees.
    fn share(mach: f64, degrees: f64) -> f64 {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        let kink = Kink {
            wall: 0,
            donor: 0,
            pressed: None,
            before: [1.0, 0.0],
            along: Some([cosine, sine]),
        };
        let front = Primitive {
            density: 1.4,
            velocity: [mach, 0.0],
            pressure: 1.0,
        };
        kink.share(&AIR, &front)
    }

    /// NACA Report 1135 (1953), chart 2 and its equations: 22.97 degrees at Mach 2, 34.07 at Mach 3, 41.12 at Mach 5.
    #[test]
    fn a_shock_turns_gas_as_far_as_the_tables_say() {
        for (mach, degrees) in [(2.0_f64, 22.974), (3.0, 34.073), (5.0, 41.118)] {
            let found = largest_turn(mach * mach, 1.4).to_degrees();
            assert_relative_eq!(found, degrees, epsilon = 2e-3);
        }
        assert_eq!(largest_turn(0.9, 1.4), 0.0);
    }

    #[test]
    fn gas_knows_of_a_bend_that_it_is_too_slow_for_or_that_pushes_its_shock_ahead() {
        assert_eq!(share(2.0, 20.0), 1.0);
        assert_eq!(share(2.0, 23.0), 0.0);
        assert_relative_eq!(share(2.0, 22.974 * 0.975), 0.5, epsilon = 1e-3);
        assert_relative_eq!(share(1.5_f64.sqrt(), 1.0), 0.5, epsilon = 1e-12);
        assert_eq!(share(0.9, 5.0), 0.0);
        assert_eq!(share(-3.0, 5.0), 0.0);
    }
}
