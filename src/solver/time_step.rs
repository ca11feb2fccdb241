//! The stable time step.

use rayon::prelude::*;

use super::particle::{Particle, Rates};
use crate::case::Equations;

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
    gamma: f64,
    particles: &[Particle<D>],
    rates: &[Rates<D>],
) -> f64 {
    let bounds = match equations {
        Equations::Paper => {
            let extremes = particles.par_iter().zip(rates).map(|(particle, rates)| {
                let acceleration = rates.acceleration + rates.wall_acceleration;
                [
                    particle.smoothing_length,
                    -particle.energy,
                    -acceleration.norm_squared(),
                ]
            });
            let [h, energy, acceleration] = extremes.reduce(|| [f64::INFINITY; 3], smaller);
            [
                h / sound_speed(gamma, -energy),
                C_FORCE * (h / (-acceleration).sqrt()).sqrt(),
                f64::INFINITY,
            ]
        }
        Equations::Conservative => {
            let each = particles.par_iter().zip(rates).map(|(particle, rates)| {
                let h = particle.smoothing_length;
                let acceleration = rates.acceleration + rates.wall_acceleration;
                let thins = particle.density / rates.density.abs();
                let cools = particle.energy / (-rates.energy).max(0.0);
                [
                    h * h / particle.energy,
                    h * h / acceleration.norm_squared(),
                    thins.min(cools),
                ]
            });
            let [courant, force, change] = each.reduce(|| [f64::INFINITY; 3], smaller);
            [
                courant.sqrt() / sound_speed(gamma, 1.0),
                C_FORCE * force.sqrt().sqrt(),
                C_CHANGE * change,
            ]
        }
    };
    cfl * bounds.into_iter().fold(f64::INFINITY, f64::min)
}

/// The bound from the speed of sound alone, known before any rate.
pub fn acoustic_step<const D: usize>(cfl: f64, gamma: f64, particles: &[Particle<D>]) -> f64 {
    let each = particles
        .par_iter()
        .map(|p| p.smoothing_length * p.smoothing_length / p.energy);
    let squared = each.reduce(|| f64::INFINITY, f64::min);
    cfl * squared.sqrt() / sound_speed(gamma, 1.0)
}

/// The smaller ones. Unlike a sum they do not depend on the order, and so not on the threads.
fn smaller(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|k| a[k].min(b[k]))
}

/// Speed of sound of an ideal gas, `sqrt(gamma (gamma - 1) e)`.
fn sound_speed(gamma: f64, energy: f64) -> f64 {
    (gamma * (gamma - 1.0) * energy).sqrt()
}
