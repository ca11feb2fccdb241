//! How far a run is.

use super::lately::Coefficients;

/// How far a run is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// Steps taken.
    pub steps: u64,
    /// Time reached.
    pub time: f64,
    /// Time at which the run ends.
    pub end_time: f64,
    /// Length of the last step.
    pub dt: f64,
    /// True of a flow that settles: its steps are iterations, and no time says how far it is.
    pub settles: bool,
    /// Of the first body, where a stream gives it any; as of the last row of the history.
    pub coefficients: Option<Coefficients>,
}
