//! What a particle is, and what its rates are.

use aero_geometry::Vector;
use serde::{Deserialize, Serialize};

use crate::records::Matrix;

/// A particle of gas.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Particle<const D: usize> {
    /// Position.
    pub position: Vector<D>,
    /// Velocity of the gas.
    pub velocity: Vector<D>,
    /// Density.
    pub density: f64,
    /// Specific internal energy.
    pub energy: f64,
    /// Smoothing length.
    pub smoothing_length: f64,
    /// Mass; of a whole ring in an axisymmetric flow.
    pub mass: f64,
    /// Mass that it stood for in the plane sums at the start: all of it, or what its ring had per length.
    pub first_plane_mass: f64,
    /// Rates by pressure at the last evaluation, which the leapfrog predicts with.
    pub by_pressure: ByPressure<D>,
    /// What dissipation leaves alone, by the last evaluation.
    pub spared: Spared<D>,
    /// Made of the second gas of the flow.
    pub is_second: bool,
    /// Moves with the undisturbed free stream ([`crate::neighbourhood::calm`]); without meaning where none is looked for.
    pub is_calm: bool,
    /// Number that the particle keeps for life.
    pub id: u64,
}

impl<const D: usize> Particle<D> {
    /// The same that stands for `share` of what it did.
    #[must_use]
    pub fn of_share(mut self, share: f64) -> Self {
        self.mass *= share;
        self.first_plane_mass *= share;
        self
    }

    /// True of a state that gas can be in.
    pub fn makes_sense(&self) -> bool {
        self.density > 0.0
            && self.energy > 0.0
            && self.smoothing_length > 0.0
            && self.energy.is_finite()
            && self.density.is_finite()
            && self.smoothing_length.is_finite()
            && self
                .position
                .iter()
                .chain(&self.velocity)
                .all(|x| x.is_finite())
    }
}

/// What artificial viscosity and conduction leave alone at a particle.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Spared<const D: usize> {
    /// Rate of strain.
    pub strain: Matrix<D>,
    /// Gradient of the specific internal energy.
    pub energy_slope: Vector<D>,
    /// One in smooth flow, nothing in a shock; one where nobody asks.
    pub smoothness: f64,
}

impl<const D: usize> Spared<D> {
    /// All is smooth, and nothing is known of it.
    pub fn unknown() -> Self {
        Self {
            strain: Matrix::zeros(),
            energy_slope: Vector::zeros(),
            smoothness: 1.0,
        }
    }
}

/// What pressure does to a particle, and what a problem adds: not viscosity, nor conduction.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct ByPressure<const D: usize> {
    /// Acceleration.
    pub acceleration: Vector<D>,
    /// Rate of specific internal energy, by compression.
    pub heating: f64,
}

impl<const D: usize> Default for ByPressure<D> {
    fn default() -> Self {
        Self {
            acceleration: Vector::zeros(),
            heating: 0.0,
        }
    }
}

/// Rates of change of one particle, and what walls contribute to them.
#[derive(Clone, Copy, Debug)]
pub struct Rates<const D: usize> {
    /// Acceleration by gas.
    pub acceleration: Vector<D>,
    /// Acceleration by ghosts, to be added to the one by gas.
    pub wall_acceleration: Vector<D>,
    /// Rate of density.
    pub density: f64,
    /// Rate of specific internal energy.
    pub energy: f64,
    /// That part of acceleration and heating that pressure gives.
    pub by_pressure: ByPressure<D>,
    /// Gradient of the velocity, `du_a / dx_b`.
    pub velocity_gradient: Matrix<D>,
    /// Gradient of the specific internal energy; of the conservative scheme only.
    pub energy_gradient: Vector<D>,
    /// Transport velocity minus velocity: of the penetration shield, and of shifting.
    pub shift: Vector<D>,
}

impl<const D: usize> Default for Rates<D> {
    fn default() -> Self {
        Self {
            acceleration: Vector::zeros(),
            wall_acceleration: Vector::zeros(),
            density: 0.0,
            energy: 0.0,
            by_pressure: ByPressure::default(),
            velocity_gradient: Matrix::zeros(),
            energy_gradient: Vector::zeros(),
            shift: Vector::zeros(),
        }
    }
}
