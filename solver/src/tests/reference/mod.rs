//! The method once more, as plain loops over all pairs in plain numbers: slow, short, and written from the equations
//! rather than from the lanes, which have to match it to round-off.

pub mod diffusion;
pub mod gas;
mod images;
pub mod kernel;
pub mod laws;
pub mod liquids;
pub mod step;
pub mod wall;

use aero_geometry::Vector;
use nalgebra::{SMatrix, Vector3};

pub use images::{Map, images};

/// Ratio of specific heats in all comparisons.
pub const GAMMA: f64 = 1.4;

/// That of the second gas, where there are two.
pub const SECOND: f64 = 5.0 / 3.0;

pub type Matrix<const D: usize> = SMatrix<f64, D, D>;

/// A particle of gas, or what a ghost shows.
#[derive(Clone, Copy, Debug)]
pub struct Point<const D: usize> {
    pub position: Vector<D>,
    pub velocity: Vector<D>,
    pub density: f64,
    pub energy: f64,
    pub pressure: f64,
    pub h: f64,
    /// Mass in the plane sums.
    pub mass: f64,
    pub volume: f64,
    /// What the viscosity leaves alone.
    pub strain: Matrix<D>,
    /// What conduction leaves alone.
    pub energy_slope: Vector<D>,
    pub smoothness: f64,
    pub renormalisation: Matrix<D>,
    pub density_gradient: Vector<D>,
    /// Transport velocity minus velocity.
    pub shift: Vector<D>,
    /// Share of the second gas.
    pub second: f64,
}

impl<const D: usize> Point<D> {
    /// Ratio of specific heats of what it is made of.
    pub fn gamma(&self) -> f64 {
        1.0 + 1.0 / (self.second / (SECOND - 1.0) + (1.0 - self.second) / (GAMMA - 1.0))
    }

    /// What of `all` is in its reach.
    pub fn near(&self, all: &[Self]) -> Vec<Self> {
        in_reach(&self.position, self.h, all)
    }

    /// One of two particles of different gases, zero of others.
    pub fn unlike(&self, other: &Self) -> f64 {
        (self.second - other.second).powi(2)
    }
}

/// What of `all` the kernel of this smoothing length sees from a place.
pub fn in_reach<const D: usize>(place: &Vector<D>, h: f64, all: &[Point<D>]) -> Vec<Point<D>> {
    let is_near = |j: &&Point<D>| (place - j.position).norm() < 3.0 * f64::midpoint(h, j.h);
    all.iter().filter(is_near).copied().collect()
}

/// A ghost.
#[derive(Clone, Copy, Debug)]
pub struct Wall<const D: usize> {
    pub point: Point<D>,
    /// Into the gas.
    pub normal: Vector<D>,
    pub depth: f64,
    pub surface_velocity: Vector<D>,
    pub surface_acceleration: Vector<D>,
    pub surface_pressure: f64,
    /// Angular velocity of its body.
    pub spin: Vector3<f64>,
    /// Shape operator.
    pub curvature: Matrix<D>,
    pub slips: bool,
    /// Velocity of the surface along itself, beside the wall's.
    pub slide: Vector<D>,
    pub heat: Heat,
    pub has_mirror: bool,
    pub body: usize,
}

/// What heat does at a wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Heat {
    Kept,
    /// The wall has this energy.
    Passes {
        energy: f64,
    },
    /// From the wall into the gas.
    Flows(f64),
}

/// Viscosity `mu_0 T^n`, and heat conduction.
#[derive(Clone, Copy, Debug)]
pub struct Viscous {
    pub viscosity: f64,
    pub exponent: f64,
    pub prandtl: f64,
}

/// Rates of one particle.
#[derive(Clone, Copy, Debug)]
pub struct Rate<const D: usize> {
    /// By gas and walls.
    pub acceleration: Vector<D>,
    pub wall_acceleration: Vector<D>,
    pub density: f64,
    pub energy: f64,
    pub acceleration_by_pressure: Vector<D>,
    pub heating_by_pressure: f64,
    pub velocity_gradient: Matrix<D>,
    pub energy_gradient: Vector<D>,
    pub shift: Vector<D>,
}

/// How particles that move otherwise than with the flow leave it in place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Transport {
    None,
    Advection,
    Exchange,
}

/// What of a difference of energies pairs conduct, beside Noh's flux in what is compressed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Conduction {
    /// All, as published: weighed by the other's volume, without Noh's flux.
    ByVolume,
    /// All.
    Pairwise,
    /// What does not vary linearly.
    Limited,
    /// Nothing.
    InShocks,
}

/// Which laws are summed.
#[derive(Clone, Copy, Debug)]
pub struct Laws {
    pub published: bool,
    pub limits_viscosity: bool,
    pub conduction: Conduction,
    pub transport: Transport,
    pub viscous: Option<Viscous>,
}
