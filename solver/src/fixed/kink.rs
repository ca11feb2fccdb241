//! Walls ahead of a sharp concave bend, or of a blunt edge ([`super::brinks`]), in the cell that holds it.
//!
//! A shock stands at the bend. Gas faster than sound slides along the wall ahead of it as if nothing were to come, and presses on that wall as in the
//! cells before; the cell that the bend lies in holds gas of both sides of the shock, in parts that depend on where in it the bend lies.

use super::attached;
use super::bend::Kink;
use super::equation_of_state::EquationOfState;
use super::fan::{SONIC, SUPERSONIC, rise};
use super::net::Block;
use super::slopes::{Flow, Slopes};
use super::state::{Primitive, dot};

impl<const D: usize> Kink<D> {
    /// How far gas in the state `front` meets the bend without knowing of it: from not at all, where it is slower than sound or its shock stands
    /// ahead of the bend, to one.
    fn share<G: EquationOfState>(&self, gas: &G, front: &Primitive<D>) -> f64 {
        if let Some(along) = &self.along {
            let across = attached::across(&front.velocity, &self.edge);
            return attached::share(gas, front, &across, &self.before, along);
        }
        let sound = gas.sound_square(front.density, front.pressure);
        let towards = dot(&front.velocity, &self.before).max(0.0);
        rise(towards * towards / sound, SONIC, SUPERSONIC)
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
            edge: [0.0; 2],
            along: Some([cosine, sine]),
        };
        let front = Primitive {
            density: 1.4,
            velocity: [mach, 0.0],
            pressure: 1.0,
        };
        kink.share(&AIR, &front)
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
