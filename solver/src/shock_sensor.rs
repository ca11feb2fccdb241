//! Where artificial viscosity and conduction may be spared and particles shifted: in flow that varies smoothly,
//! not in shocks.

use aero_geometry::parallel::prelude::*;

use super::particles::{Particle, Rates};
use super::rings::Rings;
use crate::problem::Problem;
use crate::scheme::{Conduction, Viscosity};

/// Compression, over the speed of sound per smoothing length, at which flow is half-way to a shock. A captured
/// shock is some four spacings wide and so has at least 0.1, whatever is finer has next to nothing.
const ONSET: f64 = 0.05;

/// Tells each particle how smooth the flow is, `1 - s`, the rate of strain that the viscosity leaves alone, and the slope
/// of energy that conduction does: all of it in smooth flow, none in a shock, `(1 - s) E` with `s = d^2 / (d^2 + |curl u|^2 + (0.05 c / h)^2)` and `d` the rate of compression
/// [Ducros et al. 1999, eq. 12; Bhagatwala & Lele 2009, eq. 14, for the term in `c`].
pub fn find_shocks<const D: usize>(
    problem: &Problem<D>,
    rings: Rings,
    rates: &[Rates<D>],
    particles: &mut [Particle<D>],
) {
    let scheme = &problem.scheme;
    let limits_viscosity = scheme.viscosity == Viscosity::Limited;
    let limits_conduction = scheme.conduction == Conduction::Limited;
    if !(limits_viscosity || limits_conduction || scheme.transport_velocity.shifting) {
        return;
    }
    let gases = problem.gases();
    particles
        .par_iter_mut()
        .zip(rates)
        .for_each(|(particle, rates)| {
            let gradient = &rates.velocity_gradient;
            let turn = gradient - gradient.transpose();
            let strain = (gradient + gradient.transpose()) * 0.5;
            let compression = (gradient.trace() + rings.growth(particle)).min(0.0);
            let gas = gases.of(particle.is_second);
            let sound = gas.sound_speed(particle.density, particle.energy);
            let onset = ONSET * sound / particle.smoothing_length;
            let squared = compression * compression;
            let smooth = 0.5 * turn.norm_squared() + onset * onset;
            let spared = smooth / (squared + smooth);
            particle.spared.smoothness = spared;
            if limits_viscosity {
                particle.spared.strain = strain * spared;
            }
            if limits_conduction {
                particle.spared.energy_slope = rates.energy_gradient * spared;
            }
        });
}
