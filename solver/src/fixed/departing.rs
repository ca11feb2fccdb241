//! What changes the wave that an outlet sends back into gas that leaves: the flow along the side, friction and heat.

use super::gas::Gas;
use super::slopes::Slopes;
use super::state::{Conserved, Primitive, dot};

/// What the flow across `normal` takes, per time, off the wave `u - 2 c / (gamma - 1)` in `cell`:
/// `v grad_t u - (v grad_t p + rho c^2 div_t v) / (rho c)`, `v` and `_t` being what lies across it; the divergence has what rings about an axis
/// grow by, `growth`, whichever way they go.
pub fn aside<G: Gas, const D: usize>(
    gas: &G,
    cell: &Primitive<D>,
    slopes: &Slopes<D>,
    normal: &[f64; D],
    growth: f64,
) -> f64 {
    let speed = dot(&cell.velocity, normal);
    let impedance = cell.density * gas.sound_square(cell.density, cell.pressure).sqrt();
    let (mut carried, mut apart) = (0.0, growth);
    for (k, slope) in slopes.along.iter().enumerate() {
        let across = cell.velocity[k] - speed * normal[k];
        carried += across * (dot(&slope.velocity, normal) - slope.pressure / impedance);
        apart += slope.velocity[k] - normal[k] * dot(&slope.velocity, normal);
    }
    carried - apart * impedance / cell.density
}

/// What viscosity and heat conduction take, per time, off the wave `u - 2 c / (gamma - 1)` in `cell`: `-F + q / (rho c)`, with the
/// acceleration `F` along `normal` and what heat adds to the pressure, `q`, of what they give it per volume. A layer that is braked all along
/// would be pressed back by the outlet without [as of the terms of diffusion in Yoo & Im 2007, section 2.1].
pub fn braked<G: Gas, const D: usize>(
    gas: &G,
    cell: &Primitive<D>,
    rubbed: &Conserved<D>,
    normal: &[f64; D],
) -> f64 {
    let impedance = cell.density * gas.sound_square(cell.density, cell.pressure).sqrt();
    let heat = rubbed.energy - dot(&cell.velocity, &rubbed.momentum);
    gas.pressure_change(cell.density, cell.pressure, [0.0, heat]) / impedance
        - dot(&rubbed.momentum, normal) / cell.density
}

#[cfg(test)]
mod tests {
    use super::super::gas::IdealGas;
    use super::*;

    const GAS: IdealGas = IdealGas { gamma: 1.4 };

    /// Where gas parts along the side at a rate `a`, the wave that comes in is drawn on at `c a`; what slides along it carries its
    /// own slopes with it.
    #[test]
    fn the_flow_along_the_side_is_told_apart_from_that_across_it() {
        let cell = Primitive {
            density: 1.4,
            velocity: [0.5, 0.2],
            pressure: 1.0,
        };
        let mut slopes = Slopes::<2>::LEVEL;
        slopes.along[0] = Primitive {
            density: 7.0,
            velocity: [3.0, 5.0],
            pressure: 11.0,
        };
        let normal = [1.0, 0.0];
        let aside = |slopes: &Slopes<2>, growth| aside(&GAS, &cell, slopes, &normal, growth);
        assert_eq!(aside(&slopes, 0.0), 0.0);
        slopes.along[1].velocity = [0.0, 0.3];
        let parting = aside(&slopes, 0.0);
        assert!((parting + 0.3).abs() < 1e-14, "{parting}");
        let growing = aside(&slopes, 0.25);
        assert!((growing + 0.55).abs() < 1e-14, "{growing}");
        slopes.along[1] = Primitive {
            density: 0.0,
            velocity: [0.4, 0.0],
            pressure: 0.7,
        };
        let carried = aside(&slopes, 0.0);
        assert!(
            (carried - 0.2 * (0.4 - 0.7 / 1.4)).abs() < 1e-14,
            "{carried}"
        );
    }
}
