//! Shape in, packed layers of ghost particles with normals out. No gas dynamics.

mod cloud;
mod contour;
mod error;
mod finish;
mod fluid;
mod ghosts;
mod grid;
mod lanes;
mod lattice;
mod level;
mod mirror;
mod on_sheet;
mod options;
mod pack;
mod plan;
mod quality;
mod relax;
mod report;
mod rows;
mod schedule;
mod seeds;
mod sheets;
mod sources;
mod target;
mod thin;
mod wide;

pub use error::PackError;
pub use ghosts::{Ghosts, Packing};
pub use options::{MAX_PARTICLES, PackOptions};
pub use pack::pack;
pub use report::PackReport;
