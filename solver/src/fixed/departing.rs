//! What changes the wave that an outlet sends back into gas that leaves: the flow along the side, friction and heat.

use super::gas::Gas;
use super::slopes::Slopes;
use super::state::{Conserved, Primitive, dot};

/// What the flow across `normal` takes, per time, off the wave `u - 2 c / (gamma - 1)` in `cell`:
/// `v grad_t u - (v grad_t p + rho c^2 div_t v) / (rho c)`, `v` and `_t` being what lies across it.
pub fn aside<G: Gas, const D: usize>(
    gas: &G,
    cell: &Primitive<D>,
    slopes: &Slopes<D>,
    normal: &[f64; D],
) -> f64 {
    let speed = dot(&cell.velocity, normal);
    let impedance = cell.density * gas.sound_square(cell.density, cell.pressure).sqrt();
    let (mut carried, mut apart) = (0.0, 0.0);
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
