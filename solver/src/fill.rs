//! Writes the records that the pair loops read, from particles, buffers and ghosts. Sums nothing.

use aero_geometry::parallel::prelude::*;

use super::gas::Gases;
use super::neighbourhood::Neighbourhood;
use super::particles::{Particle, Particles};
use super::problem::Problem;
use super::records::{Near, State, Symmetric};
use super::rings::Rings;
use super::sides::Buffers;
use super::walls::Walls;

/// Writes the records of ghosts and their images.
pub fn fill_ghosts<const D: usize>(walls: &Walls<D>, around: &mut Neighbourhood<D>) {
    walls.fill(&mut around.records);
    around.copies.ghosts.refresh(&mut around.records);
}

/// Writes the records of fluid, buffers and their images; buffers drift on by `ahead`.
pub fn fill_gas<const D: usize>(
    problem: &Problem<D>,
    ahead: f64,
    fluid: &Particles<D>,
    buffers: &Buffers<D>,
    around: &mut Neighbourhood<D>,
) {
    fill_near(problem, ahead, fluid, buffers, around);
    let (gases, count) = (problem.gases(), fluid.len());
    let (near, state) = (&around.records.near, &mut around.records.state);
    state[..count]
        .par_iter_mut()
        .zip(&fluid[..])
        .for_each(|(state, particle)| *state = state_of(particle, &gases));
    for (slot, open) in (count..).zip(buffers.particles()) {
        let mut open_state = state_of(&open.particle, &gases);
        open_state.renormalise(&open.renormalisation, &open.gradient, near[slot].volume);
        state[slot] = open_state;
    }
    around.copies.gas.refresh(&mut around.records);
}

/// Writes where they are and how they move, all that lists and the sum for the density read.
pub fn fill_near<const D: usize>(
    problem: &Problem<D>,
    ahead: f64,
    fluid: &Particles<D>,
    buffers: &Buffers<D>,
    around: &mut Neighbourhood<D>,
) {
    let rings = Rings::new(problem);
    let count = fluid.len();
    let near = &mut around.records.near;
    near[..count]
        .par_iter_mut()
        .zip(&fluid[..])
        .for_each(|(near, particle)| *near = near_of(particle, rings.plane_mass(particle)));
    for (near, open) in near[count..].iter_mut().zip(buffers.particles()) {
        *near = near_of(&open.particle, rings.plane_mass(&open.particle));
        near.position += open.particle.velocity * ahead;
    }
    if problem.second.is_some() {
        let open = buffers.particles().iter().map(|open| &open.particle);
        let all = fluid.iter().chain(open);
        let share = |particle: &Particle<D>| f64::from(u8::from(particle.is_second));
        let start = &mut around.records.second[..];
        start
            .iter_mut()
            .zip(all)
            .for_each(|(second, particle)| *second = share(particle));
    }
    around.copies.gas.refresh_near(&mut around.records);
}

/// Where a gas particle of plane mass `mass` is and how it moves.
fn near_of<const D: usize>(particle: &Particle<D>, mass: f64) -> Near<D> {
    Near {
        position: particle.position,
        half_h: 0.5 * particle.smoothing_length,
        volume: mass / particle.density,
        mass,
        half_density: 0.5 * particle.density,
        velocity: particle.velocity,
    }
}

/// The state of a gas particle.
fn state_of<const D: usize>(particle: &Particle<D>, gases: &Gases) -> State<D> {
    let gas = gases.of(particle.is_second);
    let pressure = gas.pressure(particle.density, particle.energy);
    let mut state = State::new(pressure, particle.density, particle.energy, gas);
    state.strain = Symmetric::new(&particle.spared.strain);
    state.energy_slope = particle.spared.energy_slope;
    state
}
