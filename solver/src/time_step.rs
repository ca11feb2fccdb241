//! The stable time step.

use aero_geometry::parallel::prelude::*;

use super::gas::{Gas, Gases};
use super::particles::{Particle, Rates};
use crate::each::each;
use crate::scheme::{StepBound, StepRule};

/// Factor of the force bound (Villodi & Ramachandran 2024, section 3.6).
const C_FORCE: f64 = 0.5;

/// Share of its density or energy, over the Courant number, that a particle may lose or gain in one
/// step: at a wall that is withdrawn at once, neither speed of sound nor acceleration tell how fast
/// the gas thins.
const C_CHANGE: f64 = 1.0;

/// Diffusion number of a step, over the square of the smoothing length [Morris, Fox & Zhu 1997, eq. 27].
const C_DIFFUSION: f64 = 0.125;

/// What bounds the step, each the smaller the tighter; what they are is up to the [`StepRule`].
#[derive(Clone, Copy, Debug)]
pub struct Bounds([f64; 4]);

impl Default for Bounds {
    fn default() -> Self {
        Self([f64::INFINITY; 4])
    }
}

impl Bounds {
    /// The smaller ones. Unlike a sum they do not depend on the order, and so not on the threads.
    pub fn tighter(self, other: Self) -> Self {
        Self(each(|k| self.0[k].min(other.0[k])))
    }
}

impl StepBound {
    /// The longest stable step of all `particles`.
    pub fn time_step<const D: usize>(
        self,
        gases: &Gases,
        particles: &[Particle<D>],
        rates: &[Rates<D>],
    ) -> f64 {
        let each = particles.par_iter().zip(rates);
        let bounds = each
            .map(|(particle, rates)| self.bounds(gases, particle, rates))
            .reduce(Bounds::default, Bounds::tighter);
        self.step(bounds, &gases.first)
    }

    /// The bounds of one particle.
    pub fn bounds<const D: usize>(
        self,
        gases: &Gases,
        particle: &Particle<D>,
        rates: &Rates<D>,
    ) -> Bounds {
        let gas = gases.of(particle.is_second);
        let h = particle.smoothing_length;
        let acceleration = rates.acceleration + rates.wall_acceleration;
        let [first, second, third] = match self.rule {
            StepRule::Extremes => [
                h,
                -gas.sound_speed(particle.density, particle.energy),
                -acceleration.norm_squared(),
            ],
            StepRule::EachParticle => {
                let thins = particle.density / rates.density.abs();
                let cools = particle.energy / (-rates.energy).max(0.0);
                [
                    h * h
                        / gases.sound_measure(
                            particle.is_second,
                            particle.density,
                            particle.energy,
                        ),
                    h * h / acceleration.norm_squared(),
                    thins.min(cools),
                ]
            }
        };
        let diffusion = if gas.is_viscous() {
            C_DIFFUSION * h * h / diffusivity(gas, particle.density, particle.energy)
        } else {
            f64::INFINITY
        };
        Bounds([first, second, third, diffusion])
    }

    /// The longest step within `bounds`.
    pub fn step(self, Bounds(bounds): Bounds, gas: &Gas) -> f64 {
        let cfl = self.cfl;
        let [first, second, third, diffusion] = bounds;
        let step = match self.rule {
            StepRule::Extremes => {
                let [h, sound, acceleration] = [first, second, third];
                let acoustic = h / -sound;
                cfl * acoustic.min(C_FORCE * (h / (-acceleration).sqrt()).sqrt())
            }
            StepRule::EachParticle => {
                let [courant, force, change] = [first, second, third];
                let acoustic = courant.sqrt() / gas.unit_sound();
                let force = C_FORCE * force.sqrt().sqrt();
                cfl * acoustic.min(force).min(C_CHANGE * change)
            }
        };
        step.min(diffusion)
    }
}

/// The larger of the diffusivities of momentum, `mu / rho`, and of heat.
fn diffusivity(gas: &Gas, density: f64, energy: f64) -> f64 {
    let coefficients = gas.coefficients(density, energy);
    coefficients.viscosity.max(coefficients.conductivity) / density
}

/// The bound from the speed of sound alone, known before any rate.
pub fn acoustic_step<const D: usize>(cfl: f64, gases: &Gases, particles: &[Particle<D>]) -> f64 {
    let each = particles.par_iter().map(|p| {
        p.smoothing_length * p.smoothing_length
            / gases.sound_measure(p.is_second, p.density, p.energy)
    });
    let squared = each.reduce(|| f64::INFINITY, f64::min);
    cfl * squared.sqrt() / gases.first.unit_sound()
}
