//! What bounds the domain. A problem names a [`crate::problem::Side`] per face; those that gas crosses become objects here, one file per
//! published model, each with its place, its stream and what it makes of its buffer. Closed sides map gas that crosses
//! them back ([`closed`]), or are walls ([`crate::walls`]).
//!
//! A new open side is a file with its [`model::OpenModel`], a variant of the problem's `Side` and its line in [`zone`], and a word in the scene.

mod buffers;
pub mod closed;
mod held;
mod inlet;
mod model;
mod outlet;
mod particle;
mod plenum;
mod reservoir;
mod rows;
mod upstream;
mod waves;
mod zone;

pub use buffers::{Buffers, Contents};
pub use held::Held;
pub use model::Place;
pub use particle::OpenParticle;
pub use reservoir::Reservoir;
pub use rows::Rows;
pub use waves::Along;
pub use zone::Zone;
