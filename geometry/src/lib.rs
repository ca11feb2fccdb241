//! Geometry that the packer and the solver share: shapes with signed distance,
//! the smoothing kernel and the neighbour grid.
//!
//! Not responsible for particles' physics or for how layers are laid.

pub mod bodies;
mod bounds;
mod crease;
mod error;
pub mod files;
mod halves;
pub mod kernel;
mod mending;
mod mesh;
mod mirrored;
pub mod outline;
pub mod parallel;
mod pencils;
mod placement;
mod real;
mod revolution;
mod shape;
pub mod stl;
mod tessellate;
mod watch;

pub use bounds::Bounds;
pub use crease::Crease;
pub use error::GeometryError;
pub use halves::{made_whole, may_be_half, whole_from_half};
pub use mending::{Mending, Solid};
pub use mesh::{Mesh, Sheet};
pub use mirrored::{MirrorPlane, Mirrored};
pub use outline::Outline;
pub use pencils::Pencils;
pub use placement::{Placed, Placement};
pub use real::Real;
pub use revolution::Revolution;
pub use shape::{Closest, Shape};
pub use watch::Watch;

/// A point or a vector in `D` dimensions, SI units (metres) unless a case says otherwise.
pub type Vector<const D: usize> = nalgebra::SVector<f64, D>;
