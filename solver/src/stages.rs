//! Moves the fluid by its rates, and lets it cross sides.

use aero_geometry::Vector;
use rayon::prelude::*;

use super::Simulation;
use super::failure::Failure;
use super::neighbours::GROWTH;
use super::particle::{Particle, Rates};
use super::snapshot::Extremes;
use super::time_step::Bounds;
use crate::problem::Side;
use crate::scheme::{Density, Energy, Integrator, Scheme};

/// Particles that a task moves at once.
const BLOCK: usize = 1024;

impl<const D: usize> Simulation<D> {
    /// Predicts the state half a step ahead, keeps the fluid as it was. The predictor takes its rates now; the
    /// leapfrog drifts at the velocity now, and takes the rates of the last evaluation for all else.
    pub(super) fn predict(&mut self, ahead: f64) -> Result<(), Failure> {
        std::mem::swap(&mut self.fluid, &mut self.saved);
        self.fluid.truncate(self.saved.len());
        let missing = &self.saved[self.fluid.len()..];
        self.fluid.extend_from_slice(missing);
        let Scheme {
            integrator,
            density,
            ..
        } = self.problem.scheme;
        let gas = self.problem.gas;
        self.advance(|particle, saved, rates| {
            *particle = *saved;
            match integrator {
                Integrator::Leapfrog => {
                    particle.position += saved.velocity * ahead;
                    particle.velocity += saved.by_pressure.acceleration * ahead;
                    particle.energy += saved.by_pressure.heating * ahead;
                    if density == Density::Continuity {
                        // Compression heats by p / rho^2 per density.
                        let heat = gas.pressure_over_density(saved.density, saved.energy);
                        particle.density +=
                            saved.by_pressure.heating * saved.density / heat * ahead;
                    }
                }
                Integrator::PredictorCorrector => {
                    move_on(particle, saved, rates, ahead);
                    particle.energy = saved.energy + rates.energy * ahead;
                    continue_density(particle, saved, rates, ahead);
                }
            }
            Bounds::default()
        })?;
        Ok(())
    }

    /// Corrects the state: the fluid at the start of the step plus `step` times the rates of its middle. The leapfrog
    /// keeps of these what its next step goes by.
    pub(super) fn correct(&mut self, step: f64) -> Result<(), Failure> {
        let Scheme {
            integrator,
            step: rule,
            density,
            energy,
            cfl,
            ..
        } = self.problem.scheme;
        let gas = self.problem.gas;
        let calm = self.calm.take();
        let result = self.advance(|particle, saved, rates| {
            let evaluated = particle.velocity;
            match integrator {
                Integrator::Leapfrog => kick_and_drift(particle, saved, rates, step),
                Integrator::PredictorCorrector => move_on(particle, saved, rates, step),
            }
            particle.energy = saved.energy
                + match energy {
                    Energy::ByRate => rates.energy,
                    Energy::Settled => settled(particle, saved, rates, &evaluated),
                } * step;
            match density {
                Density::Continuity => continue_density(particle, saved, rates, step),
                // That of the middle was read off the particles there.
                Density::Summation => particle.density += rates.density * (0.5 * step),
            }
            let mut bounds = Bounds::default();
            if integrator == Integrator::Leapfrog {
                particle.by_pressure = rates.by_pressure;
                bounds = rule.bounds(&gas, particle, rates);
            }
            if let Some(calm) = &calm {
                particle.is_calm = calm.holds(particle, rates);
            }
            bounds
        });
        self.calm = calm;
        let bounds = result?;
        if integrator == Integrator::Leapfrog {
            self.stable_step = rule.step(bounds, cfl, &gas);
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

/// Moves `particle` from where it was at the start of the step by `ahead` times its rates.
fn move_on<const D: usize>(
    particle: &mut Particle<D>,
    saved: &Particle<D>,
    rates: &Rates<D>,
    ahead: f64,
) {
    // The velocity that moves the particle is the one at which the rates were evaluated.
    particle.position = saved.position + (particle.velocity + rates.shift) * ahead;
    let acceleration = rates.acceleration + rates.wall_acceleration;
    particle.velocity = saved.velocity + acceleration * ahead;
}

/// The leapfrog's kick at the middle of the step, and its drift to the end.
fn kick_and_drift<const D: usize>(
    particle: &mut Particle<D>,
    saved: &Particle<D>,
    rates: &Rates<D>,
    step: f64,
) {
    let acceleration = rates.acceleration + rates.wall_acceleration;
    particle.velocity = saved.velocity + acceleration * step;
    let mean = (saved.velocity + particle.velocity) * 0.5;
    particle.position = saved.position + (mean + rates.shift) * step;
}

/// Rate of energy that settles the total.
///
/// Forces are paid for at the velocity `v` that they were `evaluated` at; the kinetic energy
/// changes by their work at the mean of the velocities before and after. The difference
/// is heat: `-dt a.((u0 + u1) / 2 - v)`, the same in every frame
/// of reference, which settles the total energy to round-off.
fn settled<const D: usize>(
    particle: &Particle<D>,
    saved: &Particle<D>,
    rates: &Rates<D>,
    evaluated: &Vector<D>,
) -> f64 {
    let acceleration = rates.acceleration + rates.wall_acceleration;
    let mean = (saved.velocity + particle.velocity) * 0.5;
    rates.energy - acceleration.dot(&(mean - evaluated))
}

/// Density and smoothing length by the equation of continuity [Villodi & Ramachandran 2024, eqs 10 and 17], at the stage whose
/// density gave the rate.
fn continue_density<const D: usize>(
    particle: &mut Particle<D>,
    saved: &Particle<D>,
    rates: &Rates<D>,
    ahead: f64,
) {
    let growth = -rates.density / (D as f64 * particle.density);
    particle.smoothing_length = saved.smoothing_length
        + (particle.smoothing_length * growth * ahead).min((GROWTH - 1.0) * saved.smoothing_length);
    particle.density = saved.density + rates.density * ahead;
}
