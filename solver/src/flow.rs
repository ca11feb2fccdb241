//! A flow under way, whatever carries the gas.

use std::sync::Arc;

use aero_geometry::Bounds;

use crate::carrier::Carrier;
use crate::compiled;
use crate::fixed::Settled;
use crate::frame::{CellFrame, Frame, Load, PanelFrame, SurfaceFrame, Totals};
use crate::panels::shown_forces;
use crate::problem::Problem;
use crate::{Failure, Pose, Statistics};

pub use crate::carrier::FlowMemory;

/// A flow under way.
#[derive(Debug)]
pub struct Flow<const D: usize>(Carrier<D>);

impl<const D: usize> Flow<D> {
    /// The flow of `problem` at its start.
    ///
    /// # Errors
    /// What its method cannot do.
    pub fn new(problem: Problem<D>) -> Result<Self, String> {
        compiled::start(problem).map(Self)
    }

    /// Goes on from `memory`, which a flow of the same `problem` left.
    ///
    /// # Errors
    /// A memory of another problem.
    pub fn resume(problem: Problem<D>, memory: FlowMemory<'static, D>) -> Result<Self, String> {
        compiled::resume(problem, memory).map(Self)
    }

    /// What [`Self::resume`] needs to go on from here.
    pub fn memory(&self) -> FlowMemory<'_, D> {
        self.0.memory()
    }

    /// The problem that runs.
    pub fn problem(&self) -> &Problem<D> {
        self.0.problem()
    }

    /// Time reached.
    pub fn time(&self) -> f64 {
        self.0.time()
    }

    /// Steps taken.
    pub fn steps(&self) -> u64 {
        self.0.steps()
    }

    /// Advances by one time step, no further than `limit`; returns the step taken.
    ///
    /// # Errors
    /// Where the state stops making sense; the flow then stands at its last good state.
    pub fn step(&mut self, limit: f64) -> Result<f64, Failure> {
        compiled::step(&mut self.0, limit)
    }

    /// One iteration towards the steady flow, of points that stay; particles have none.
    ///
    /// # Errors
    /// As of [`Self::step`].
    pub fn settle_step(&mut self) -> Option<Result<Settled, Failure>> {
        compiled::settle_step(&mut self.0)
    }

    /// All that carries gas now, with ghosts and buffers.
    pub fn frame(&self) -> Frame {
        compiled::frame(&self.0)
    }

    /// The same within a box.
    pub fn frame_within(&self, region: &Bounds<D>) -> Frame {
        compiled::frame_within(&self.0, region)
    }

    /// State on the bodies' surfaces now.
    pub fn surface(&self) -> SurfaceFrame {
        compiled::surface(&self.0)
    }

    /// The surfaces themselves with the pressure on them now.
    pub fn panels(&self) -> PanelFrame {
        compiled::panels(&self.0)
    }

    /// What the cells look like now, of points that stay in the plane or in space; particles have none.
    pub fn cells(&self) -> Option<Arc<CellFrame>> {
        compiled::cells(&self.0)
    }

    /// Loads of a pressure of one everywhere, on bodies, then on wall sides: nothing on what is closed.
    pub fn uniform_loads(&self) -> Vec<Load> {
        compiled::uniform_loads(&self.0)
    }

    /// Forces on the bodies by what `panels`, those of now, show: pressure over the free stream's and friction, but for what of
    /// it is spread. Those of [`Self::loads`] are
    /// what the gas itself is held off with.
    pub fn shown_forces(&self, panels: &PanelFrame) -> Vec<[f64; 3]> {
        shown_forces(self.problem(), panels)
    }

    /// Loads on bodies, then on wall sides.
    pub fn loads(&self) -> Vec<Load> {
        compiled::loads(&self.0)
    }

    /// Conserved totals of the gas now.
    pub fn totals(&self) -> Totals {
        compiled::totals(&self.0)
    }

    /// Where body `number` is now, and how it moves.
    pub fn pose(&self, number: usize) -> Pose<D> {
        self.0.pose(number)
    }

    /// What came in through sides and walls so far.
    pub fn inflow(&self) -> Totals {
        self.0.inflow()
    }

    /// Mass of the gas now, and its centre; missing axes zero.
    pub fn mass_and_centre(&self) -> (f64, [f64; 3]) {
        self.0.mass_and_centre()
    }

    /// Points whose cells were split so often, from those never split; none of particles.
    pub fn points_per_level(&self) -> Vec<usize> {
        self.0.points_per_level()
    }

    /// True where points have been added since the start because the flow asked for them.
    pub fn has_refined(&self) -> bool {
        self.0.has_refined()
    }

    /// Counts and extremes.
    pub fn statistics(&self) -> Statistics {
        compiled::statistics(&self.0)
    }
}
