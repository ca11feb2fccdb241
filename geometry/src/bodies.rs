//! Bodies by name: the shapes of the classic cases, from the dimensions one would quote.
//!
//! Angles are in degrees, as people quote them; lengths are in metres or whatever unit the case
//! uses throughout.

mod axisymmetric;
mod biconvex;
mod capsule;
mod cuboid;
mod endless;
mod nose;
mod nozzle;
mod round;

pub use crate::outline::polygon::{parse_points, polygon, polygon_file};
pub use axisymmetric::{cone, round_rod, sphere};
pub use biconvex::biconvex;
pub use capsule::Capsule;
pub use cuboid::{Cuboid, cuboid};
pub use endless::{compression_corner, expansion_corner, forward_step, wall};
pub use nose::blunt_wedge;
pub use nozzle::Nozzle;
pub use round::{circle, rectangle};
