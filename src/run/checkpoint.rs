//! What a run must remember to go on as if it had never stopped. How it is kept on disk is not
//! decided here.

use std::path::Path;

use serde::{Deserialize, Serialize};

use super::steady::Monitor;
use super::swing::Swing;
use super::tally::Sums;
use crate::output::{self, CheckpointError};
use aero_solver::FlowMemory;

/// A run between two steps.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Checkpoint<'a, const D: usize> {
    pub(super) simulation: FlowMemory<'a, D>,
    pub(super) sums: Sums,
    pub(super) pace: Pace,
    pub(super) monitor: Option<Monitor>,
    pub(super) swing: Swing,
}

/// What has been written up to a checkpoint.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(super) struct Written {
    /// Time of each frame.
    pub(super) times: Vec<f64>,
    /// Length of the history.
    pub(super) history: u64,
}

/// How far the loop over the steps is.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub(super) struct Pace {
    /// Frames so far.
    pub frames: u64,
    /// Step of the last one.
    pub framed_step: u64,
    /// Tiny steps in a row.
    pub tiny_steps: u32,
}

/// Reads the checkpoint in `folder`; none where there is no such file.
///
/// # Errors
/// When it belongs to another scene than `scene`, or cannot be read.
pub(super) fn read<const D: usize>(
    folder: &Path,
    scene: &str,
) -> Result<Option<(Written, Checkpoint<'static, D>)>, CheckpointError> {
    let content: Option<(String, Written, Checkpoint<'static, D>)> =
        output::read_checkpoint(folder)?;
    let Some((earlier, written, checkpoint)) = content else {
        return Ok(None);
    };
    match difference(&earlier, scene) {
        None => Ok(Some((written, checkpoint))),
        Some(reason) => Err(CheckpointError::new(folder, reason)),
    }
}

/// The first line in which two scenes differ.
fn difference(earlier: &str, now: &str) -> Option<String> {
    let missing = |from: &str, other: &str| {
        let line = from.lines().find(|line| !other.lines().any(|l| l == *line));
        line.map(str::to_owned)
    };
    match (missing(earlier, now), missing(now, earlier)) {
        (None, None) => None,
        (Some(then), None) => Some(format!("the scene had `{then}` when it was made")),
        (None, Some(now)) => Some(format!("the scene had no `{now}` when it was made")),
        (Some(then), Some(now)) => Some(format!(
            "the scene had `{then}` when it was made and has `{now}` now"
        )),
    }
}
