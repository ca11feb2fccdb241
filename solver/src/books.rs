//! The books of a run: what went into and out of the fluid, and the extremes that it met.

use serde::{Deserialize, Serialize};

use super::frame::Totals;
use super::particles::Particle;

/// What a run keeps account of.
#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
pub struct Books {
    /// What has entered the fluid through open sides minus what has left it.
    pub crossed: Totals,
    /// Impulse and work of walls and open neighbours on the fluid so far.
    pub received: Totals,
    /// Counts and extremes.
    pub extremes: Extremes,
}

impl Books {
    /// Books a particle that enters the fluid, `sign` 1, or leaves it, -1.
    pub fn cross<const D: usize>(&mut self, particle: &Particle<D>, sign: f64) {
        add(&mut self.crossed, particle, sign);
    }

    /// Books what walls and open neighbours gave the fluid in a step.
    pub fn receive(&mut self, received: &Totals) {
        self.received.energy += received.energy;
        for k in 0..3 {
            self.received.momentum[k] += received.momentum[k];
        }
    }

    /// What the fluid received since the start: inflow minus outflow through open sides, the impulse of walls, the work of
    /// moving walls.
    pub fn inflow(&self) -> Totals {
        let mut sum = self.crossed;
        sum.energy += self.received.energy;
        for k in 0..3 {
            sum.momentum[k] += self.received.momentum[k];
        }
        sum
    }
}

/// Running counts and extremes.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Extremes {
    /// Particle updates so far.
    pub updates: u64,
    /// How often gas was brought back that a step had carried into a wall.
    pub returned: u64,
    /// Smallest density met.
    pub min_density: f64,
    /// Smallest specific internal energy met.
    pub min_energy: f64,
}

impl Default for Extremes {
    fn default() -> Self {
        Self {
            updates: 0,
            returned: 0,
            min_density: f64::INFINITY,
            min_energy: f64::INFINITY,
        }
    }
}

impl Extremes {
    /// Takes note of a particle; one whose state makes no sense leaves a density that is not a number.
    pub fn meet<const D: usize>(&mut self, particle: &Particle<D>) {
        let density = if particle.makes_sense() {
            particle.density
        } else {
            f64::NAN
        };
        self.min_density = smaller(self.min_density, density);
        self.min_energy = self.min_energy.min(particle.energy);
    }

    /// What both met.
    pub fn merge(self, other: Self) -> Self {
        Self {
            updates: self.updates + other.updates,
            returned: self.returned + other.returned,
            min_density: smaller(self.min_density, other.min_density),
            min_energy: self.min_energy.min(other.min_energy),
        }
    }

    /// False after a particle whose state made no sense.
    pub fn make_sense(&self) -> bool {
        !self.min_density.is_nan()
    }
}

/// Adds `sign` times a particle's mass, momentum and energy to `totals`.
pub fn add<const D: usize>(totals: &mut Totals, particle: &Particle<D>, sign: f64) {
    let mass = sign * particle.mass;
    totals.mass += mass;
    for k in 0..D {
        totals.momentum[k] += mass * particle.velocity[k];
    }
    totals.energy += mass * (particle.energy + 0.5 * particle.velocity.norm_squared());
}

/// The smaller number; none, where one of the two is none.
fn smaller(a: f64, b: f64) -> f64 {
    if a.is_nan() || a < b { a } else { b }
}
