//! A flow under way, whatever carries the gas.

use aero_geometry::Bounds;
use serde::{Deserialize, Serialize};

use crate::fixed::{FixedMemory, FixedSimulation, Settled};
use crate::frame::{Frame, Load, PanelFrame, SurfaceFrame, Totals};
use crate::method::Method;
use crate::problem::Problem;
use crate::{Failure, Memory, Simulation, Statistics, compiled};

/// A flow under way.
#[derive(Debug)]
pub enum Flow<const D: usize> {
    /// Of particles that move with the gas.
    WithTheGas(Box<Simulation<D>>),
    /// About points that stay where they are.
    Fixed(Box<FixedSimulation<D>>),
}

/// What a flow must remember to go on with the same bits.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub enum FlowMemory<'a, const D: usize> {
    /// Of particles.
    WithTheGas(Memory<'a, D>),
    /// Of points.
    Fixed(FixedMemory<'a, D>),
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

impl<const D: usize> Flow<D> {
    /// The flow of `problem` at its start.
    ///
    /// # Errors
    /// What its method cannot do.
    pub fn new(problem: Problem<D>) -> Result<Self, String> {
        compiled::start(problem)
    }

    /// Goes on from `memory`, which a flow of the same `problem` left.
    ///
    /// # Errors
    /// A memory of another problem.
    pub fn resume(problem: Problem<D>, memory: FlowMemory<'static, D>) -> Result<Self, String> {
        compiled::resume(problem, memory)
    }

    /// What [`Self::resume`] needs to go on from here.
    pub fn memory(&self) -> FlowMemory<'_, D> {
        match self {
            Self::WithTheGas(flow) => FlowMemory::WithTheGas(flow.memory()),
            Self::Fixed(flow) => FlowMemory::Fixed(flow.memory()),
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

    /// Advances by one time step, no further than `limit`; returns the step taken.
    ///
    /// # Errors
    /// Where the state stops making sense; the flow then stands at its last good state.
    pub fn step(&mut self, limit: f64) -> Result<f64, Failure> {
        compiled::step(self, limit)
    }

    /// One iteration towards the steady flow, of points that stay; particles have none.
    ///
    /// # Errors
    /// As of [`Self::step`].
    pub fn settle_step(&mut self) -> Option<Result<Settled, Failure>> {
        compiled::settle_step(self)
    }

    /// All that carries gas now, with ghosts and buffers.
    pub fn frame(&self) -> Frame {
        compiled::frame(self)
    }

    /// The same within a box.
    pub fn frame_within(&self, region: &Bounds<D>) -> Frame {
        compiled::frame_within(self, region)
    }

    /// State on the bodies' surfaces now.
    pub fn surface(&self) -> SurfaceFrame {
        compiled::surface(self)
    }

    /// The surfaces themselves with the pressure on them now.
    pub fn panels(&self) -> PanelFrame {
        compiled::panels(self)
    }

    /// Loads of a pressure of one everywhere, on bodies, then on wall sides: nothing on what is closed.
    pub fn uniform_loads(&self) -> Vec<Load> {
        compiled::uniform_loads(self)
    }

    /// Loads on bodies, then on wall sides.
    pub fn loads(&self) -> Vec<Load> {
        compiled::loads(self)
    }

    /// Conserved totals of the gas now.
    pub fn totals(&self) -> Totals {
        compiled::totals(self)
    }

    /// What came in through sides and walls so far.
    pub fn inflow(&self) -> Totals {
        of_either!(self, flow => flow.inflow())
    }

    /// Mass of the gas now, and its centre; missing axes zero.
    pub fn mass_and_centre(&self) -> (f64, [f64; 3]) {
        of_either!(self, flow => flow.mass_and_centre())
    }

    /// Counts and extremes.
    pub fn statistics(&self) -> Statistics {
        compiled::statistics(self)
    }
}

/// The same work, for this crate to compile.
impl<const D: usize> Flow<D> {
    pub(crate) fn start(problem: Problem<D>) -> Result<Self, String> {
        match problem.method {
            Method::WithTheGas => Simulation::new(problem).map(|it| Self::WithTheGas(Box::new(it))),
            Method::Fixed(_) => FixedSimulation::new(problem).map(|it| Self::Fixed(Box::new(it))),
        }
    }

    pub(crate) fn go_on(problem: Problem<D>, memory: FlowMemory<'_, D>) -> Result<Self, String> {
        match memory {
            FlowMemory::WithTheGas(memory) => {
                Simulation::resume(problem, memory).map(|it| Self::WithTheGas(Box::new(it)))
            }
            FlowMemory::Fixed(memory) => {
                FixedSimulation::resume(problem, memory).map(|it| Self::Fixed(Box::new(it)))
            }
        }
    }

    pub(crate) fn advance(&mut self, limit: f64) -> Result<f64, Failure> {
        of_either!(self, flow => flow.step(limit))
    }

    pub(crate) fn settle(&mut self) -> Option<Result<Settled, Failure>> {
        match self {
            Self::WithTheGas(_) => None,
            Self::Fixed(flow) => Some(flow.settle_step()),
        }
    }

    pub(crate) fn all_shown(&self) -> Frame {
        of_either!(self, flow => flow.frame())
    }

    pub(crate) fn shown_within(&self, region: &Bounds<D>) -> Frame {
        of_either!(self, flow => flow.frame_within(region))
    }

    pub(crate) fn surface_shown(&self) -> SurfaceFrame {
        of_either!(self, flow => flow.surface())
    }

    pub(crate) fn panels_shown(&self) -> PanelFrame {
        of_either!(self, flow => flow.panels())
    }

    pub(crate) fn uniform_loads_summed(&self) -> Vec<Load> {
        of_either!(self, flow => flow.uniform_loads())
    }

    pub(crate) fn loads_summed(&self) -> Vec<Load> {
        of_either!(self, flow => flow.loads())
    }

    pub(crate) fn totals_summed(&self) -> Totals {
        of_either!(self, flow => flow.totals())
    }

    pub(crate) fn counted(&self) -> Statistics {
        of_either!(self, flow => flow.statistics())
    }
}
