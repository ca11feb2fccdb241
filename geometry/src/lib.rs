//! Geometry that the packer and the solver share: shapes with signed distance,
//! the smoothing kernel and the neighbour grid.
//!
//! Not responsible for particles' physics or for how layers are laid.

mod bounds;
pub mod kernel;
mod pencils;
mod shape;

pub use bounds::Bounds;
pub use pencils::Pencils;
pub use shape::{Closest, Shape};

/// A point or a vector in `D` dimensions, SI units (metres) unless a case says otherwise.
pub type Vector<const D: usize> = nalgebra::SVector<f64, D>;
