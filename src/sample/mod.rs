//! The gas between the particles or points of a run: its state and slopes at any place, by a linear fit to what lies around. Takes
//! snapshots, writes nothing.

mod cloud;
mod field;
mod fit;
mod gas;
mod lattice;
mod quantity;
mod solids;
mod view;

pub use cloud::{Cloud, Near};
pub use field::Field;
pub use gas::{Gas, Spot, State};
pub use lattice::Lattice;
pub use quantity::{Quantity, Scale};
pub use solids::{Contact, Solids};
pub use view::{Raster, Sample, View, range};
