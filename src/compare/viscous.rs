//! Viscous flows with exact solutions: heated shear, a channel, the inside of a shock, vortices that decay, the boundary layer of a plate, wakes; and flows that were
//! measured: gas behind a step, heat into a nose.

mod channel;
mod cylinder;
mod hot_shear;
mod nose;
mod particles;
mod plate;
mod reattachment;
mod shear;
mod shock;
mod turning;
mod vortices;
mod wake;

use super::suite::Suite;
use super::variant::Levels;

const NAME: &str = "viscous";
const GAMMA: f64 = 1.4;
/// J/(kg K), as in the scenes.
const GAS_CONSTANT: f64 = 287.05;

/// Flows between walls and far from them, of points that stay and of particles.
pub const SHEAR: Suite = Suite::of(&[
    (Levels::Both, shear::compare),
    (Levels::Both, hot_shear::compare),
    (Levels::Both, shock::compare),
    (Levels::Both, vortices::compare),
    (Levels::Both, particles::compare),
    (Levels::Both, channel::compare),
    (Levels::Both, turning::compare),
]);

/// Boundary layers, wakes and what parts from walls.
pub const LAYERS: Suite = Suite::of(&[
    (Levels::Both, cylinder::compare),
    (Levels::Full, plate::compare),
    (Levels::Full, reattachment::compare),
    (Levels::Full, wake::compare),
]);

/// Heat into noses.
pub const NOSES: Suite = Suite::of(&[(Levels::Full, nose::compare)]);
