//! The stable time step.

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
    let each = particles.iter().zip(rates).map(|(particle, rates)| {
        let acceleration = (rates.acceleration + rates.wall_acceleration).norm();
        (
            particle.smoothing_length,
            sound_speed(gamma, particle.energy),
            acceleration,
        )
    });
    match equations {
        Equations::Paper => {
            let (h, c, a) = each.fold((f64::INFINITY, 0.0_f64, 0.0_f64), |most, one| {
                (most.0.min(one.0), most.1.max(one.1), most.2.max(one.2))
            });
            cfl * (h / c).min(C_FORCE * (h / a).sqrt())
        }
        Equations::Conservative => {
            let courant = each.fold(f64::INFINITY, |least: f64, (h, c, a)| {
                least.min(h / c).min(C_FORCE * (h / a).sqrt())
            });
            let changes = particles.iter().zip(rates).map(|(particle, rates)| {
                let thins = particle.density / rates.density.abs();
                let cools = particle.energy / (-rates.energy).max(0.0);
                C_CHANGE * thins.min(cools)
            });
            cfl * changes.fold(courant, f64::min)
        }
    }
}

/// The bound from the speed of sound alone, known before any rate.
pub fn acoustic_step<const D: usize>(cfl: f64, gamma: f64, particles: &[Particle<D>]) -> f64 {
    cfl * particles
        .iter()
        .fold(f64::INFINITY, |least: f64, particle| {
            least.min(particle.smoothing_length / sound_speed(gamma, particle.energy))
        })
}

/// Speed of sound of an ideal gas, `sqrt(gamma (gamma - 1) e)`.
fn sound_speed(gamma: f64, energy: f64) -> f64 {
    (gamma * (gamma - 1.0) * energy).sqrt()
}
