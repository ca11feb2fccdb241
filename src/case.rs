//! What a scene meant: the flow problem that the solver reads, and how it is run.

use aero_geometry::Bounds;
use aero_solver::problem::Problem;

/// A scene, checked and packed, in `D` dimensions.
#[derive(Clone, Debug)]
pub struct Case<const D: usize> {
    /// What flows where.
    pub problem: Problem<D>,
    /// How it is run.
    pub plan: RunPlan<D>,
}

/// How a problem is run.
#[derive(Clone, Debug, PartialEq)]
pub struct RunPlan<const D: usize> {
    /// Name of the scene.
    pub name: String,
    /// Time at which the run ends.
    pub end_time: f64,
    /// Whether it may end before.
    pub stop: Stop,
    /// When to write what.
    pub output: OutputPlan<D>,
}

/// When a run ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// At its end time.
    EndTime,
    /// As soon as the flow is steady, at its end time at the latest.
    Steady,
}

/// When to write what.
#[derive(Clone, Debug, PartialEq)]
pub struct OutputPlan<const D: usize> {
    /// Time between frames; the first and the last state are always written.
    pub frame_interval: f64,
    /// What frames show; everything if none.
    pub region: Option<Bounds<D>>,
    /// Frames are compressed.
    pub is_compressed: bool,
    /// Steps between rows of the history.
    pub history_every: usize,
    /// Longest wall time between checkpoints, s.
    pub checkpoint_seconds: f64,
}
