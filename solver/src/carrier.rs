//! What carries the gas of a flow.

use std::sync::Arc;

use aero_geometry::Bounds;
use serde::{Deserialize, Serialize};

use crate::fixed::{FixedMemory, FixedSimulation, Settled};
use crate::frame::{CellFrame, Frame, Load, PanelFrame, SurfaceFrame, Totals};
use crate::method::Method;
use crate::problem::{Motion, Problem};
use crate::{Failure, Memory, Pose, Simulation, Statistics};

/// What carries the gas of a flow.
#[derive(Debug)]
pub enum Carrier<const D: usize> {
    /// Of particles that move with the gas.
    WithTheGas(Box<Simulation<D>>),
    /// About points that stay where they are.
    Fixed(Box<FixedSimulation<D>>),
}

/// What a flow must remember to go on with the same bits.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub enum FlowMemory<'a, const D: usize> {
    /// Of particles.
    WithTheGas(Box<Memory<'a, D>>),
    /// Of points.
    Fixed(Box<FixedMemory<'a, D>>),
}

/// Calls the method of the same name on whatever carries the gas.
macro_rules! of_either {
    ($self:ident, $flow:ident => $value:expr) => {
        match $self {
            Self::WithTheGas($flow) => $value,
            Self::Fixed($flow) => $value,
        }
    };
}

impl<const D: usize> Carrier<D> {
    /// The flow of `problem` at its start.
    ///
    /// # Errors
    /// What its method cannot do.
    pub fn new(problem: Problem<D>) -> Result<Self, String> {
        match problem.method {
            Method::WithTheGas => Simulation::new(problem).map(|it| Self::WithTheGas(Box::new(it))),
            Method::Fixed(_) => FixedSimulation::new(problem).map(|it| Self::Fixed(Box::new(it))),
        }
    }

    /// Goes on from `memory`, which a flow of the same `problem` left.
    ///
    /// # Errors
    /// A memory of another problem.
    pub fn resume(problem: Problem<D>, memory: FlowMemory<'_, D>) -> Result<Self, String> {
        match memory {
            FlowMemory::WithTheGas(memory) => {
                Simulation::resume(problem, *memory).map(|it| Self::WithTheGas(Box::new(it)))
            }
            FlowMemory::Fixed(memory) => {
                FixedSimulation::resume(problem, *memory).map(|it| Self::Fixed(Box::new(it)))
            }
        }
    }

    /// Advances by one time step, no further than `limit`; returns the step taken.
    ///
    /// # Errors
    /// Where the state stops making sense; the flow then stands at its last good state.
    pub fn step(&mut self, limit: f64) -> Result<f64, Failure> {
        of_either!(self, flow => flow.step(limit))
    }

    /// One iteration towards the steady flow, of points that stay; particles have none.
    ///
    /// # Errors
    /// As of [`Self::step`].
    pub fn settle_step(&mut self) -> Option<Result<Settled, Failure>> {
        match self {
            Self::WithTheGas(_) => None,
            Self::Fixed(flow) => Some(flow.settle_step()),
        }
    }

    /// All that carries gas now, with ghosts and buffers.
    pub fn frame(&self) -> Frame {
        of_either!(self, flow => flow.frame())
    }

    /// The same within a box.
    pub fn frame_within(&self, region: &Bounds<D>) -> Frame {
        of_either!(self, flow => flow.frame_within(region))
    }

    /// State on the bodies' surfaces now.
    pub fn surface(&self) -> SurfaceFrame {
        of_either!(self, flow => flow.surface())
    }

    /// The surfaces themselves with the pressure on them now.
    pub fn panels(&self) -> PanelFrame {
        of_either!(self, flow => flow.panels())
    }

    /// What the cells look like now, of points that stay in the plane or in space; particles have none.
    pub fn cells(&self) -> Option<Arc<CellFrame>> {
        match self {
            Self::WithTheGas(_) => None,
            Self::Fixed(flow) => Some(flow.cells()),
        }
    }

    /// Loads of a pressure of one everywhere, on bodies, then on wall sides: nothing on what is closed.
    pub fn uniform_loads(&self) -> Vec<Load> {
        of_either!(self, flow => flow.uniform_loads())
    }

    /// Loads on bodies, then on wall sides.
    pub fn loads(&self) -> Vec<Load> {
        of_either!(self, flow => flow.loads())
    }

    /// Conserved totals of the gas now.
    pub fn totals(&self) -> Totals {
        of_either!(self, flow => flow.totals())
    }

    /// Points whose cells were split so often, from those never split; none of particles.
    pub fn points_per_level(&self) -> Vec<usize> {
        match self {
            Self::WithTheGas(_) => Vec::new(),
            Self::Fixed(flow) => flow.points_per_level(),
        }
    }

    /// True where points have been added since the start because the flow asked for them; never among particles.
    pub fn has_refined(&self) -> bool {
        match self {
            Self::WithTheGas(_) => false,
            Self::Fixed(flow) => flow.has_refined(),
        }
    }

    /// Counts and extremes.
    pub fn statistics(&self) -> Statistics {
        of_either!(self, flow => flow.statistics())
    }

    /// What [`Self::resume`] needs to go on from here.
    pub fn memory(&self) -> FlowMemory<'_, D> {
        match self {
            Self::WithTheGas(flow) => FlowMemory::WithTheGas(Box::new(flow.memory())),
            Self::Fixed(flow) => FlowMemory::Fixed(Box::new(flow.memory())),
        }
    }

    /// The problem that runs.
    pub fn problem(&self) -> &Problem<D> {
        of_either!(self, flow => flow.problem())
    }

    /// Time reached.
    pub fn time(&self) -> f64 {
        of_either!(self, flow => flow.time())
    }

    /// Steps taken.
    pub fn steps(&self) -> u64 {
        of_either!(self, flow => flow.steps())
    }

    /// Where body `number` is now, and how it moves.
    pub fn pose(&self, number: usize) -> Pose<D> {
        match self {
            Self::WithTheGas(flow) => flow.pose(number),
            Self::Fixed(_) => Pose::new(&Motion::none(), 0.0),
        }
    }

    /// What came in through sides and walls so far.
    pub fn inflow(&self) -> Totals {
        of_either!(self, flow => flow.inflow())
    }

    /// Mass of the gas now, and its centre; missing axes zero.
    pub fn mass_and_centre(&self) -> (f64, [f64; 3]) {
        of_either!(self, flow => flow.mass_and_centre())
    }
}
