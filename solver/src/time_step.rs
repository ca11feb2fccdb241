//! The stable time step.

use rayon::prelude::*;

use super::gas::Gas;
use super::particles::{Particle, Rates};
use crate::problem::{Equations, Problem};

/// Factor of the force bound (Villodi & Ramachandran 2024, section 3.6).
const C_FORCE: f64 = 0.5;

/// Share of its density or energy, over the Courant number, that a particle may lose or gain in one
/// step: at a wall that is withdrawn at once, neither speed of sound nor acceleration tell how fast
/// the gas thins.
const C_CHANGE: f64 = 1.0;

/// Bounds from the speed of sound and from the acceleration [Villodi & Ramachandran 2024, eqs
/// 33-35]. The paper takes the smallest `h`, the largest `c` and the largest acceleration of all
/// particles, wherever they are; the conservative scheme takes the smallest bound of any particle, and
/// lets no density change and no energy fall by more than [`C_CHANGE`] allows.
pub fn time_step<const D: usize>(
    equations: Equations,
    cfl: f64,
    gas: &Gas,
    particles: &[Particle<D>],
    rates: &[Rates<D>],
) -> f64 {
    match equations {
        Equations::Paper => {
            let extremes = particles.par_iter().zip(rates).map(|(particle, rates)| {
                let acceleration = rates.acceleration + rates.wall_acceleration;
                [
                    particle.smoothing_length,
                    -gas.sound_speed(particle.density, particle.energy),
                    -acceleration.norm_squared(),
                ]
            });
            let [h, sound, acceleration] = extremes.reduce(|| [f64::INFINITY; 3], smaller);
            let acoustic = h / -sound;
            cfl * acoustic.min(C_FORCE * (h / (-acceleration).sqrt()).sqrt())
        }
        Equations::Conservative => {
            let each = particles.par_iter().zip(rates);
            each.map(|(particle, rates)| Bounds::of(particle, rates))
                .reduce(Bounds::default, Bounds::tighter)
                .step(cfl, gas)
        }
    }
}

/// The same for the scheme of `problem`.
pub fn of_rates<const D: usize>(
    problem: &Problem<D>,
    particles: &[Particle<D>],
    rates: &[Rates<D>],
) -> f64 {
    let scheme = &problem.scheme;
    time_step(scheme.equations, scheme.cfl, &problem.gas, particles, rates)
}

/// What bounds the step of the conservative scheme, each over the Courant number.
#[derive(Clone, Copy, Debug)]
pub struct Bounds {
    /// `h^2 / e`, the square of what the speed of sound allows but for the gas' constants.
    courant: f64,
    /// `(h / a)^2`.
    force: f64,
    /// Time in which density or energy would change by all that there is.
    change: f64,
}

impl Default for Bounds {
    fn default() -> Self {
        Self {
            courant: f64::INFINITY,
            force: f64::INFINITY,
            change: f64::INFINITY,
        }
    }
}

impl Bounds {
    /// Those of one particle.
    pub fn of<const D: usize>(particle: &Particle<D>, rates: &Rates<D>) -> Self {
        let h = particle.smoothing_length;
        let acceleration = rates.acceleration + rates.wall_acceleration;
        let thins = particle.density / rates.density.abs();
        let cools = particle.energy / (-rates.energy).max(0.0);
        Self {
            courant: h * h / particle.energy,
            force: h * h / acceleration.norm_squared(),
            change: thins.min(cools),
        }
    }

    /// The smaller ones. Unlike a sum they do not depend on the order, and so not on the threads.
    pub fn tighter(self, other: Self) -> Self {
        Self {
            courant: self.courant.min(other.courant),
            force: self.force.min(other.force),
            change: self.change.min(other.change),
        }
    }

    /// The longest step within all of them.
    pub fn step(self, cfl: f64, gas: &Gas) -> f64 {
        let acoustic = self.courant.sqrt() / gas.sound_speed(1.0, 1.0);
        let force = C_FORCE * self.force.sqrt().sqrt();
        cfl * acoustic.min(force).min(C_CHANGE * self.change)
    }
}

/// The bound from the speed of sound alone, known before any rate.
pub fn acoustic_step<const D: usize>(cfl: f64, gas: &Gas, particles: &[Particle<D>]) -> f64 {
    let each = particles
        .par_iter()
        .map(|p| p.smoothing_length * p.smoothing_length / p.energy);
    let squared = each.reduce(|| f64::INFINITY, f64::min);
    cfl * squared.sqrt() / gas.sound_speed(1.0, 1.0)
}

/// The smaller ones. Unlike a sum they do not depend on the order, and so not on the threads.
fn smaller(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|k| a[k].min(b[k]))
}
