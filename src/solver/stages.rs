//! Moves the fluid by its rates, and what a finished step leaves to do: energy to settle, sides to cross.

use rayon::prelude::*;

use super::Simulation;
use super::neighbours::GROWTH;
use crate::case::{Equations, Side};

impl<const D: usize> Simulation<D> {
    /// Sets the fluid to its state at the start of the step plus `ahead` times the rates.
    pub(super) fn advance(&mut self, ahead: f64) {
        let paper = self.case.scheme.equations == Equations::Paper;
        // The velocity that moves the particle is the one at which the rates were evaluated.
        self.fluid
            .par_iter_mut()
            .zip(&self.saved)
            .zip(&self.rates)
            .for_each(|((particle, saved), rates)| {
                particle.position = saved.position + (particle.velocity + rates.shift) * ahead;
                let acceleration = rates.acceleration + rates.wall_acceleration;
                particle.velocity = saved.velocity + acceleration * ahead;
                if paper {
                    // Eq. 17, at the stage whose density gave the rate.
                    let growth = -rates.density / (D as f64 * particle.density);
                    particle.smoothing_length = saved.smoothing_length
                        + (particle.smoothing_length * growth * ahead)
                            .min((GROWTH - 1.0) * saved.smoothing_length);
                }
                particle.density = saved.density + rates.density * ahead;
                particle.energy = saved.energy + rates.energy * ahead;
            });
    }

    /// Settles the total energy of a finished step to round-off.
    ///
    /// Forces are paid for at the velocity `v` that they were evaluated at; the kinetic energy
    /// changes by their work at the mean of the velocities before and after. The difference,
    /// of third order in the step, is heat: `-dt a.((u0 + u1) / 2 - v)`, the same in every frame
    /// of reference. Needs the records of the second evaluation, which hold `v`.
    pub(super) fn settle_energy(&mut self, step: f64) {
        self.fluid
            .par_iter_mut()
            .zip(&self.saved)
            .zip(&self.rates)
            .zip(&self.records.near)
            .for_each(|(((particle, saved), rates), evaluated)| {
                let mean = (saved.velocity + particle.velocity) * 0.5;
                let acceleration = rates.acceleration + rates.wall_acceleration;
                particle.energy -= step * acceleration.dot(&(mean - evaluated.velocity));
            });
    }

    /// Lets particles change sides after the step that began at `before`.
    pub(super) fn cross_sides(&mut self, before: f64) {
        if self.case.has_open_sides() {
            for open in self
                .open
                .particles
                .iter_mut()
                .filter(|open| open.lattice.is_none())
            {
                open.particle.position += open.particle.velocity * (self.time - before);
            }
            let renormalisations = &self.renormalisations;
            let frozen = |i: usize| {
                let r = &renormalisations[i];
                (r.matrix, r.density_gradient)
            };
            self.open
                .exchange(&self.case, before, self.time, &mut self.fluid, frozen);
        }
        let domain = &self.case.domain;
        for axis in 0..D {
            let (low, high) = (domain.bounds.min[axis], domain.bounds.max[axis]);
            let sides = domain.sides[axis];
            for particle in &mut self.fluid {
                let x = particle.position[axis];
                if x < low && sides[0] == Side::Periodic {
                    particle.position[axis] += high - low;
                } else if x >= high && sides[1] == Side::Periodic {
                    particle.position[axis] -= high - low;
                } else if (x < low && sides[0].is_mirror()) || (x > high && sides[1].is_mirror()) {
                    let plane = if x < low { low } else { high };
                    particle.position[axis] = 2.0 * plane - x;
                    particle.velocity[axis] = -particle.velocity[axis];
                }
            }
        }
    }
}
