//! What bounds the domain. A problem names a [`Side`] per face; those that gas crosses become objects here, one file per
//! published model, each with its place, its stream and what it makes of its buffer. Closed sides map gas that crosses
//! them back ([`closed`]), or are walls ([`crate::walls`]).
//!
//! A new open side is a file with its [`OpenModel`], a variant of [`Side`] and its line in [`model`], and a word in the scene.

use std::fmt::Debug;

mod buffers;
pub mod closed;
mod domain;
mod inlet;
mod outlet;
mod particle;
mod reservoir;
mod rows;
mod zone;

pub use buffers::{Buffers, Contents};
pub use domain::Domain;
pub use particle::OpenParticle;
pub use reservoir::Reservoir;
pub use rows::Rows;
pub use zone::Zone;

use super::particles::Particle;
use super::problem::{Problem, State};
use super::walls::WallKind;
use aero_geometry::Vector;

/// What bounds the domain on one side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Side {
    /// Buffer of free-stream particles that turn into fluid when they enter.
    Inlet,
    /// Particles that cross freeze their state, drift on and are removed.
    Outlet,
    /// Buffer of free-stream particles along a side that the flow does not disturb.
    FreeStream,
    /// Inlet at less than the speed of sound, from a reservoir at the free stream's stagnation state:
    /// the flow inside decides how fast the gas enters.
    Reservoir,
    /// Mirror plane.
    Symmetry,
    /// The axis that an axisymmetric flow is the same all around.
    Axis,
    /// Joined to the opposite side.
    Periodic,
    /// Plane wall.
    Wall {
        /// Slip or no slip.
        kind: WallKind,
        /// Velocity along the axis at the start.
        velocity: f64,
        /// Constant acceleration along the axis.
        acceleration: f64,
    },
    /// Closed by a body that covers it.
    Body,
}

impl Side {
    /// True where the flow beyond is the mirror image of the flow within.
    pub fn is_mirror(self) -> bool {
        matches!(self, Self::Symmetry | Self::Axis)
    }

    /// True of one that is joined to the opposite side.
    pub fn is_periodic(self) -> bool {
        self == Self::Periodic
    }

    /// True of one that lets gas in or out.
    pub fn is_open(self) -> bool {
        self.lets_in() || self == Self::Outlet
    }

    /// True of one that gas enters through, in a state that is prescribed or follows from a reservoir.
    pub fn lets_in(self) -> bool {
        matches!(self, Self::Inlet | Self::FreeStream | Self::Reservoir)
    }

    /// True of one that keeps the free stream up, whatever the flow inside does.
    pub fn keeps_free_stream(self) -> bool {
        matches!(self, Self::Inlet | Self::FreeStream)
    }

    /// True of a plane wall.
    pub fn is_wall(self) -> bool {
        matches!(self, Self::Wall { .. })
    }
}

/// Where an open side is: a face of the domain.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    /// Axis across the face.
    pub axis: usize,
    /// 0 for the lower face, 1 for the upper one.
    pub end: usize,
    /// Coordinate of the face.
    pub face: f64,
}

impl Place {
    /// How far `position` is beyond the face; negative in front of it.
    pub fn depth<const D: usize>(&self, position: &Vector<D>) -> f64 {
        if self.end == 0 {
            self.face - position[self.axis]
        } else {
            position[self.axis] - self.face
        }
    }

    /// True beyond the face. The lower face belongs to the domain, the upper one does not, so that neighbouring cells of the
    /// lattice never claim the same point.
    pub fn is_beyond(&self, depth: f64) -> bool {
        if self.end == 0 {
            depth > 0.0
        } else {
            depth >= 0.0
        }
    }

    /// Direction into the domain along the axis.
    pub fn inward(&self) -> f64 {
        if self.end == 0 { 1.0 } else { -1.0 }
    }
}

/// How gas crosses an open side: a published model. All but the first have an answer that fits a side that asks nothing of
/// the flow inside.
pub trait OpenModel<const D: usize>: Debug + Send + Sync {
    /// State of the gas that enters at first; none through a side that gas only leaves by.
    fn inflow(&self, problem: &Problem<D>) -> Option<State<D>>;

    /// State in which gas enters from now on, after a step that left the flow inside as `fluid`; none where it stays as it
    /// was, and for a model that never answers.
    fn answer(&self, _problem: &Problem<D>, _fluid: &[Particle<D>]) -> Option<State<D>> {
        None
    }

    /// True where [`Self::answer`] may ever change the state.
    fn answers(&self) -> bool {
        false
    }

    /// State of the gas that enters at `position` of the buffer at `time`, where that of the stream as a whole is
    /// `stream`: a profile in space and time.
    fn profile(&self, stream: &State<D>, _position: &Vector<D>, _time: f64) -> State<D> {
        *stream
    }

    /// What becomes, in a step, of a particle of the buffer that has left the domain here; it has drifted on already.
    fn hold(&self, _problem: &Problem<D>, _gone: &mut OpenParticle<D>) {}
}

/// The model of a kind of side; none of closed ones.
fn model<const D: usize>(
    problem: &Problem<D>,
    side: Side,
    place: Place,
) -> Option<Box<dyn OpenModel<D>>> {
    match side {
        Side::Inlet | Side::FreeStream => Some(Box::new(inlet::Inlet)),
        Side::Reservoir => Some(Box::new(reservoir::Reservoir::new(problem, place))),
        Side::Outlet => Some(Box::new(outlet::Outlet)),
        Side::Symmetry | Side::Axis | Side::Periodic | Side::Wall { .. } | Side::Body => None,
    }
}
