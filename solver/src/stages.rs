//! Moves the fluid by its rates, and lets it cross sides.

use rayon::prelude::*;

use super::Simulation;
use super::failure::Failure;
use super::neighbours::GROWTH;
use super::particle::{Particle, Rates};
use super::snapshot::Extremes;
use super::time_step::Bounds;
use crate::problem::{Equations, Side};

/// Particles that a task moves at once.
const BLOCK: usize = 1024;

impl<const D: usize> Simulation<D> {
    /// Predicts the state half a step ahead, keeps the fluid as it was. The published scheme takes its rates now; the
    /// leapfrog drifts at the velocity now, and takes the rates of the last evaluation for all else.
    pub(super) fn predict(&mut self, ahead: f64) -> Result<(), Failure> {
        std::mem::swap(&mut self.fluid, &mut self.saved);
        self.fluid.truncate(self.saved.len());
        let missing = &self.saved[self.fluid.len()..];
        self.fluid.extend_from_slice(missing);
        let is_leapfrog = self.problem.scheme.equations == Equations::Conservative;
        self.advance(|particle, saved, rates| {
            *particle = *saved;
            if is_leapfrog {
                particle.position += saved.velocity * ahead;
                particle.velocity += saved.by_pressure.acceleration * ahead;
                particle.energy += saved.by_pressure.heating * ahead;
            } else {
                midpoint(particle, saved, rates, ahead);
            }
            Bounds::default()
        })?;
        Ok(())
    }

    /// Corrects the state: the fluid at the start of the step plus `step` times the rates of its middle. The leapfrog
    /// keeps of these what its next step goes by.
    pub(super) fn correct(&mut self, step: f64) -> Result<(), Failure> {
        let is_leapfrog = self.problem.scheme.equations == Equations::Conservative;
        let calm = self.calm.take();
        let result = self.advance(|particle, saved, rates| {
            let mut bounds = Bounds::default();
            if is_leapfrog {
                kick_and_drift(particle, saved, rates, step);
                particle.by_pressure = rates.by_pressure;
                bounds = Bounds::of(particle, rates);
            } else {
                midpoint(particle, saved, rates, step);
            }
            if let Some(calm) = &calm {
                particle.is_calm = calm.holds(particle, rates);
            }
            bounds
        });
        self.calm = calm;
        let bounds = result?;
        if is_leapfrog {
            self.stable_step = bounds.step(self.problem.scheme.cfl, &self.problem.gas);
        }
        Ok(())
    }

    /// Moves each particle of the fluid by its state at the start of the step and its rates; returns the tightest of
    /// the bounds that `stage` finds.
    fn advance(
        &mut self,
        stage: impl Fn(&mut Particle<D>, &Particle<D>, &Rates<D>) -> Bounds + Sync,
    ) -> Result<Bounds, Failure> {
        let (extremes, bounds) = self
            .fluid
            .par_chunks_mut(BLOCK)
            .zip(self.saved.par_chunks(BLOCK))
            .zip(self.rates.par_chunks(BLOCK))
            .map(|((fluid, saved), rates)| {
                let (mut extremes, mut bounds) = Default::default();
                for ((particle, saved), rates) in fluid.iter_mut().zip(saved).zip(rates) {
                    bounds = Bounds::tighter(bounds, stage(particle, saved, rates));
                    Extremes::meet(&mut extremes, particle);
                }
                (extremes, bounds)
            })
            .reduce(Default::default, |(a, b), (c, d)| {
                (a.merge(c), b.tighter(d))
            });
        self.check(extremes)?;
        Ok(bounds)
    }

    /// Keeps of an evaluation before any step what the step goes by.
    pub(super) fn remember_rates(&mut self) {
        self.fluid
            .par_iter_mut()
            .zip(&self.rates)
            .for_each(|(particle, rates)| particle.by_pressure = rates.by_pressure);
        self.stable_step = self.time_step();
    }

    /// Lets particles change sides after the step that began at `before`.
    pub(super) fn cross_sides(&mut self, before: f64) {
        if self.problem.has_open_sides() {
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
                .exchange(&self.problem, before, self.time, &mut self.fluid, frozen);
        }
        let domain = &self.problem.domain;
        for axis in 0..D {
            let (low, high) = (domain.bounds.min[axis], domain.bounds.max[axis]);
            let sides = domain.sides[axis];
            if !sides
                .iter()
                .any(|side| side.is_mirror() || *side == Side::Periodic)
            {
                continue;
            }
            self.fluid.par_iter_mut().for_each(|particle| {
                let x = particle.position[axis];
                if x < low && sides[0] == Side::Periodic {
                    particle.position[axis] += high - low;
                } else if x >= high && sides[1] == Side::Periodic {
                    particle.position[axis] -= high - low;
                } else if (x < low && sides[0].is_mirror()) || (x > high && sides[1].is_mirror()) {
                    let plane = if x < low { low } else { high };
                    particle.position[axis] = 2.0 * plane - x;
                    particle.velocity[axis] = -particle.velocity[axis];
                    let acceleration = &mut particle.by_pressure.acceleration;
                    acceleration[axis] = -acceleration[axis];
                }
            });
        }
    }
}

/// Sets `particle` to its state at the start of the step plus `ahead` times its rates.
fn midpoint<const D: usize>(
    particle: &mut Particle<D>,
    saved: &Particle<D>,
    rates: &Rates<D>,
    ahead: f64,
) {
    // The velocity that moves the particle is the one at which the rates were evaluated.
    particle.position = saved.position + (particle.velocity + rates.shift) * ahead;
    let acceleration = rates.acceleration + rates.wall_acceleration;
    particle.velocity = saved.velocity + acceleration * ahead;
    // Eq. 17, at the stage whose density gave the rate.
    let growth = -rates.density / (D as f64 * particle.density);
    particle.smoothing_length = saved.smoothing_length
        + (particle.smoothing_length * growth * ahead).min((GROWTH - 1.0) * saved.smoothing_length);
    particle.density = saved.density + rates.density * ahead;
    particle.energy = saved.energy + rates.energy * ahead;
}

/// The leapfrog's kick at the middle of the step, and its drift to the end.
///
/// Forces are paid for at the velocity `v` that they were evaluated at; the kinetic energy
/// changes by their work at the mean of the velocities before and after. The difference
/// is heat: `-dt a.((u0 + u1) / 2 - v)`, the same in every frame
/// of reference, which settles the total energy to round-off.
fn kick_and_drift<const D: usize>(
    particle: &mut Particle<D>,
    saved: &Particle<D>,
    rates: &Rates<D>,
    step: f64,
) {
    let evaluated = particle.velocity;
    let acceleration = rates.acceleration + rates.wall_acceleration;
    particle.velocity = saved.velocity + acceleration * step;
    let mean = (saved.velocity + particle.velocity) * 0.5;
    particle.position = saved.position + (mean + rates.shift) * step;
    particle.energy = saved.energy + (rates.energy - acceleration.dot(&(mean - evaluated))) * step;
    // That of the middle was read off the particles there.
    particle.density += rates.density * (0.5 * step);
}
