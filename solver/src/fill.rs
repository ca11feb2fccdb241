//! Writes the records that the pair loops read, from particles, buffers and ghosts. Sums nothing.

use rayon::prelude::*;

use super::Simulation;
use super::gas::Gas;
use super::particle::Particle;
use super::records::{FLOW_IMAGES, FLUID, GHOST_IMAGES, GHOSTS, Near, State, Symmetric};

impl<const D: usize> Simulation<D> {
    /// Writes the records of ghosts and their images.
    pub(super) fn fill_ghosts(&mut self) {
        self.walls.fill(&mut self.records);
        self.ghost_images
            .refresh(&mut self.records, GHOSTS, GHOST_IMAGES);
    }

    /// Writes the records of fluid, buffers and their images; buffers drift on by `ahead`.
    pub(super) fn fill_gas(&mut self, ahead: f64) {
        self.fill_near(ahead);
        let (gas, count) = (self.problem.gas, self.fluid.len());
        let (near, state) = (&self.records.near, &mut self.records.state);
        state[..count]
            .par_iter_mut()
            .zip(&self.fluid)
            .for_each(|(state, particle)| *state = state_of(particle, &gas));
        for (slot, open) in (count..).zip(&self.open.particles) {
            let mut open_state = state_of(&open.particle, &gas);
            open_state.renormalise(&open.renormalisation, &open.gradient, near[slot].volume);
            state[slot] = open_state;
        }
        self.flow_images
            .refresh(&mut self.records, FLUID, FLOW_IMAGES);
    }

    /// Writes where they are and how they move, all that lists and the sum for the density read.
    pub(super) fn fill_near(&mut self, ahead: f64) {
        let rings = self.rings;
        let count = self.fluid.len();
        let near = &mut self.records.near;
        near[..count]
            .par_iter_mut()
            .zip(&self.fluid)
            .for_each(|(near, particle)| *near = near_of(particle, rings.plane_mass(particle)));
        for (near, open) in near[count..].iter_mut().zip(&self.open.particles) {
            *near = near_of(&open.particle, rings.plane_mass(&open.particle));
            near.position += open.particle.velocity * ahead;
        }
        self.flow_images
            .refresh_near(&mut self.records, FLUID, FLOW_IMAGES);
    }
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
fn state_of<const D: usize>(particle: &Particle<D>, gas: &Gas) -> State<D> {
    let pressure = gas.pressure(particle.density, particle.energy);
    let mut state = State::new(pressure, particle.density, particle.energy, gas);
    state.strain = Symmetric::new(&particle.strain);
    state.energy_slope = particle.energy_slope;
    state
}
