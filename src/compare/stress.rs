//! Flows on which particle methods and finite volumes are known to fail, each against an exact or
//! agreed answer.
//!
//! A run that stops is a row that fails, not the end of the comparison: the table is there to show
//! where the method ends.

mod base;
mod bodies;
mod edge;
mod fins;
mod line;
mod plate;
mod radial;
mod schemes;
mod slab;
mod smooth;
mod trial;
mod tubes;

use super::suite::Suite;
use super::variant::Levels;

/// The flows along a line.
pub const TUBES: Suite = Suite::of(&[
    (Levels::Both, line::compare),
    (Levels::Both, line::convergence),
]);

/// The implosions and explosions.
pub const BALLS: Suite = Suite::of(&[(Levels::Both, radial::compare)]);

/// The flows without shocks.
pub const SMOOTH: Suite = Suite::of(&[(Levels::Both, smooth::compare)]);

/// The flows around bodies.
pub const BODIES: Suite = Suite::of(&[(Levels::Both, bodies::compare)]);

/// Thin plates in space.
pub const SLABS: Suite = Suite::of(&[(Levels::Both, slab::compare)]);

/// Thin fins on a body in space.
pub const FINS: Suite = Suite::of(&[(Levels::Both, fins::compare)]);
