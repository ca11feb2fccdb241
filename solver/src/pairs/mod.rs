//! Pair laws, one published model per file, and the passes that sum them.
//!
//! What a law is stands in [`law`]; which of them a scheme asks for in [`rates`]; how they are summed in [`crate::backend`].

pub mod law;
pub mod pair;
pub mod sum;

pub mod encounter;
pub mod rates;

pub mod advection;
pub mod artificial_conduction;
pub mod artificial_viscosity;
pub mod averaged_pressure;
pub mod density_diffusion;
pub mod diffusion;
pub mod energy_gradient;
pub mod exchange;
pub mod pressure_damping;
pub mod pressure_force;
pub mod pressure_slope;
pub mod velocity_gradient;

pub mod arrangement;
pub mod concentration;
pub mod density_slope;
pub mod renormalisation;

pub mod extrapolation;
pub mod summation;
mod unlike;

pub mod shield;
