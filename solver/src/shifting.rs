//! Shifting: particles drift, relative to the gas, from where they crowd to where they are few.
//!
//! The drift is a transport velocity; what it carries is put back by [`super::pairs::exchange`]. It vanishes on a lattice, in a
//! uniform stream and, to third order in the spacing, in any ordered flow; it knows the gas' volumes
//! `m / rho`, not their masses, so that a change of density is no crowd.

use aero_geometry::Vector;
use aero_geometry::kernel::SUPPORT;
use aero_geometry::parallel::prelude::*;

use super::neighbourhood::{Neighbourhood, open_side_distance};
use super::pairs::renormalisation::Renormalisation;
use super::particles::{Columns, Particle, Particles};
use super::problem::Problem;
use super::records::{FLOW_IMAGES, GHOSTS, Records};

/// Drift along a gradient of concentration of `1 / (2 h)`, over the speed of sound: the largest Mach number of the
/// weakly compressible flows for which Sun et al. [2017, 2019] give `du = -Ma c (2h) grad C`.
const STRENGTH: f64 = 0.1;

/// Fastest drift over the speed of sound: half of that Mach number [Sun et al. 2019]. At the largest Courant
/// number of one it moves no particle further than a twentieth of `h` in a step.
pub const FASTEST: f64 = 0.5 * STRENGTH;

/// Ghosts' share of the gradient of the kernel sum, times `h`, one spacing (two thirds of `h`) away from a plane wall:
/// `exp(-q^2) / sqrt(pi)`, the normal distribution of the variance `h^2 / 2` of the spline on a line.
const ONE_SPACING_FROM_A_WALL: f64 = 0.36;

/// Adds the drift to the shifts in the rates, and writes what the pairs read of them.
pub fn shift<const D: usize>(
    problem: &Problem<D>,
    fluid: &mut Particles<D>,
    around: &mut Neighbourhood<D>,
) {
    let gas = around.records.start[GHOSTS];
    around.records.shift.clear();
    around.records.shift.resize(gas, Vector::zeros());
    let is_shielded = problem.scheme.transport_velocity.shield;
    let (near, state) = (&around.records.near, &around.records.state);
    let Columns {
        state: particles,
        rates,
        renormalisations,
        ..
    } = fluid.columns();
    let shifts: Vec<_> = particles
        .par_iter()
        .zip(&*renormalisations)
        .zip(near.par_iter().zip(state))
        .zip(&*rates)
        .map(|(((particle, renormalisation), (near, state)), rates)| {
            let h = near.smoothing_length();
            // The buffers beyond open sides do not shift.
            let mut shift = if open_side_distance(&problem.domain, &near.position) < SUPPORT * h {
                Vector::zeros()
            } else {
                drift(particle, renormalisation, 2.0 * state.half_sound, h)
            };
            if is_shielded {
                shift += rates.shift;
            }
            shift
        })
        .collect();
    let records = &mut around.records;
    rates
        .par_iter_mut()
        .zip(&mut records.shift)
        .zip(&*renormalisations)
        .zip(shifts)
        .for_each(|(((rates, renormalised), renormalisation), shift)| {
            rates.shift = shift;
            *renormalised = renormalisation.matrix * shift;
        });
    for (number, slot) in (records.start[FLOW_IMAGES]..gas).enumerate() {
        let (source, sign) = around.copies.gas.source(number);
        records.shift[slot] = sign.component_mul(&records.shift[source]);
    }
    if around.arch.is_mixed() {
        let Records { shift, rounded, .. } = records;
        rounded.round_shift(shift);
    }
}

/// `factor` times the gradient of the concentration; next to a wall never towards it.
pub fn spread<const D: usize>(
    renormalisation: &Renormalisation<D>,
    factor: f64,
    h: f64,
) -> Vector<D> {
    let wall = renormalisation.wall_gradient;
    let mut way = renormalisation.concentration_gradient * factor;
    let steepness = wall.norm();
    if steepness * h > ONE_SPACING_FROM_A_WALL {
        let into = wall / steepness;
        way -= into * way.dot(&into).max(0.0);
    }
    way
}

/// Lets particles stay where they are: their drift takes back what the flow moves them by.
pub fn stand_still<const D: usize>(fluid: &mut Particles<D>) {
    let Columns { state, rates, .. } = fluid.columns();
    rates
        .par_iter_mut()
        .zip(state)
        .for_each(|(rates, particle)| rates.shift = -particle.velocity);
}

/// `du = -Ma c (2h) grad C`, bounded by [`FASTEST`] and scaled down in shocks; next to a wall never towards it.
fn drift<const D: usize>(
    particle: &Particle<D>,
    renormalisation: &Renormalisation<D>,
    sound: f64,
    h: f64,
) -> Vector<D> {
    let mut drift = spread(renormalisation, -2.0 * STRENGTH * sound * h, h);
    let fastest = FASTEST * sound;
    let speed = drift.norm();
    if speed > fastest {
        drift *= fastest / speed;
    }
    drift * particle.spared.smoothness
}
