//! Writes the records that the pair loops read, from particles, buffers and ghosts. Sums nothing.

use rayon::prelude::*;

use super::Simulation;
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
        let (gamma, rings) = (self.case.gamma, self.rings);
        let count = self.fluid.len();
        let (near, state) = (&mut self.records.near, &mut self.records.state);
        near[..count]
            .par_iter_mut()
            .zip(&mut state[..count])
            .zip(&self.fluid)
            .for_each(|((near, state), particle)| {
                (*near, *state) = record(particle, rings.plane_mass(particle), gamma);
            });
        for (slot, open) in (count..).zip(&self.open.particles) {
            let (mut place, mut open_state) =
                record(&open.particle, rings.plane_mass(&open.particle), gamma);
            place.position += open.particle.velocity * ahead;
            open_state.renormalise(&open.renormalisation, &open.gradient, place.volume);
            near[slot] = place;
            state[slot] = open_state;
        }
        self.flow_images
            .refresh(&mut self.records, FLUID, FLOW_IMAGES);
    }
}

/// The records of a gas particle of plane mass `mass`.
fn record<const D: usize>(particle: &Particle<D>, mass: f64, gamma: f64) -> (Near<D>, State<D>) {
    let pressure = (gamma - 1.0) * particle.density * particle.energy;
    let mut state = State::new(pressure, particle.density, particle.energy, gamma);
    state.strain = Symmetric::new(&particle.strain);
    state.energy_slope = particle.energy_slope;
    let near = Near {
        position: particle.position,
        half_h: 0.5 * particle.smoothing_length,
        volume: mass / particle.density,
        mass,
        half_density: 0.5 * particle.density,
        velocity: particle.velocity,
    };
    (near, state)
}
