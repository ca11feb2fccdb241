//! Shape in, packed layers of ghost particles with normals out. No gas dynamics.

mod cloud;
#[cfg(not(test))]
mod compiled;
mod contour;
mod cover;
mod cutting;
mod error;
mod finish;
mod flawless;
mod fluid;
mod gaps;
mod ghosts;
mod grid;
mod lanes;
mod lattice;
mod level;
mod limits;
mod midway;
mod mirror;
mod nearest;
mod on_sheet;
mod options;
mod pack;
mod plan;
mod quality;
mod relax;
mod report;
mod room;
mod room_across;
mod room_inside;
mod rows;
mod schedule;
mod seeds;
mod sheets;
mod sources;
mod surface;
mod target;
mod thickness;
mod thin;
mod thinnest;
mod warning;
mod wide;

#[cfg(not(test))]
pub use compiled::{pack, thinnest_part};
pub use error::PackError;
pub use ghosts::{Ghosts, Packing};
pub use options::{MAX_PARTICLES, PackOptions};
// The tests beside the code ask for parts of the packing alone.
#[cfg(test)]
pub use pack::pack;
pub use report::PackReport;
#[cfg(test)]
pub use thickness::thinnest_part;
pub use warning::{About, Warning};
