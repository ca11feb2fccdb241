//! What bounds the domain. A problem names a [`crate::problem::Side`] per face; those that gas crosses become objects here, one file per
//! published model, each with its place, its stream and what it makes of its buffer. Closed sides map gas that crosses
//! them back ([`closed`]), or are walls ([`crate::walls`]).
//!
//! A new open side is a file with its model, its lines below, a variant of the problem's `Side`, and a word in the scene.

mod buffers;
pub mod closed;
mod come_back;
mod fill_up;
mod held;
mod held_outlet;
mod incoming;
mod inlet;
mod model;
mod outlet;
mod particle;
mod parting;
mod plenum;
mod reservoir;
mod rows;
mod upstream;
mod waves;
mod zone;

pub use buffers::{Buffers, Contents};
pub use held::Held;
pub use incoming::Incoming;
pub use model::Place;
pub use particle::OpenParticle;
pub use parting::parted;
pub use rows::Rows;
pub use waves::Along;
pub use zone::Zone;

use crate::method::Time;
use crate::problem::{Given, Problem, Side, State};
use held_outlet::HeldOutlet;
use inlet::{Inlet, SoftInlet};
use model::OpenModel;
use outlet::Outlet;
use reservoir::Reservoir;

/// The model of a kind of side that particles cross, with gas beyond it that may be `given`; none of closed ones.
fn model_of<const D: usize>(
    problem: &Problem<D>,
    side: Side,
    place: Place,
    given: Option<&Given<D>>,
) -> Option<Box<dyn OpenModel<D>>> {
    match side {
        Side::Inlet | Side::FreeStream => Some(Box::new(Inlet::new(problem, place, given))),
        Side::SoftInlet => Some(Box::new(SoftInlet::new(problem, place, given))),
        Side::Reservoir { relaxation } => {
            Some(Box::new(Reservoir::new(problem, place, relaxation)))
        }
        Side::Outlet => Some(Box::new(Outlet)),
        Side::HeldOutlet {
            pressure,
            relaxation,
        } => {
            let held = Held::new(problem, place, pressure, Some(relaxation));
            Some(Box::new(HeldOutlet::new(held, given)))
        }
        Side::Symmetry | Side::Axis | Side::Periodic | Side::Wall { .. } | Side::Body => None,
    }
}

/// A side beyond which gas answers to the cell in front of it.
#[derive(Clone, Copy, Debug)]
pub enum Answering {
    /// A reservoir.
    Reservoir(Reservoir),
    /// Gas that is held at a pressure.
    Held(Held),
}

impl Answering {
    /// That of a kind of side; none of those that do not answer. A flow that settles has no time in which sound could leave: what is
    /// to be held is held at once.
    pub fn of<const D: usize>(problem: &Problem<D>, side: Side, place: Place) -> Option<Self> {
        let settles = problem.method.fixed().map(|points| points.time) == Some(Time::Settle);
        match side {
            Side::Reservoir { relaxation } => {
                let relaxation = relaxation.filter(|_| !settles);
                let reservoir = Reservoir::new(problem, place, relaxation);
                Some(Self::Reservoir(reservoir))
            }
            Side::HeldOutlet {
                pressure,
                relaxation,
            } => {
                let relaxation = Some(relaxation).filter(|_| !settles);
                let held = Held::new(problem, place, pressure, relaxation);
                Some(Self::Held(held))
            }
            _ => None,
        }
    }

    /// True where gas beyond moves along the side as the free stream does; else it comes from rest.
    pub fn drifts(&self) -> bool {
        match self {
            Self::Reservoir(_) => false,
            Self::Held(_) => true,
        }
    }

    /// The state beyond a face that `gas` reaches from a cell whose `mean` is at this `distance` before it; all speeds are out of the domain.
    pub fn beyond(&self, gas: &Along, mean: &Along, distance: f64) -> Along {
        match self {
            Self::Reservoir(reservoir) => reservoir
                .beyond(&gas.turned(), &mean.turned(), distance)
                .turned(),
            Self::Held(held) => held.beyond(gas),
        }
    }

    /// The same beside gas whose state, of an outlet the pressure, is now this.
    #[must_use]
    pub fn at<const D: usize>(self, given: &State<D>) -> Self {
        match self {
            Self::Held(held) => Self::Held(held.at(given.pressure)),
            Self::Reservoir(_) => self,
        }
    }
}
