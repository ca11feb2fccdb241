//! What a run must remember to go on as if it had never stopped. How it is kept on disk is not
//! decided here.

use std::path::Path;

use serde::{Deserialize, Serialize};

use super::same::is_same_line;
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
    /// Length of the probes' table.
    pub(super) probes: u64,
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
    /// Time between frames. A longer run keeps it.
    pub interval: f64,
    /// Time at which the run ends.
    pub end: f64,
}

/// Reads the checkpoint in `folder` for a run of `scene` to `end`; none where there is no such file.
///
/// # Errors
/// When it cannot be read, or belongs to a scene that differs in more than a later end.
pub(super) fn read<const D: usize>(
    folder: &Path,
    scene: &str,
    end: f64,
) -> Result<Option<(Written, Checkpoint<'static, D>)>, CheckpointError> {
    let content: Option<(String, Written, Checkpoint<'static, D>)> =
        output::read_checkpoint(folder)?;
    let Some((earlier, written, checkpoint)) = content else {
        return Ok(None);
    };
    let has_monitor = checkpoint.monitor.is_some();
    let earlier_end = checkpoint.pace.end;
    let other = difference(&earlier, scene, has_monitor).map(|difference| {
        format!("{difference}, and a run that goes on may only have another `end_time`")
    });
    let reason = other.or_else(|| {
        (end < earlier_end).then(|| {
            format!(
                "the run was to end at t = {earlier_end}, later than `end_time = {end}`, and can only be made longer"
            )
        })
    });
    match reason {
        None => Ok(Some((written, checkpoint))),
        Some(reason) => Err(CheckpointError::new(folder, reason)),
    }
}

/// The first line in which two scenes differ, the time of their end aside, and for a run that a monitor watched whether that may
/// end it.
fn difference(earlier: &str, now: &str, has_monitor: bool) -> Option<String> {
    /// Where a flow is watched to see when it is steady.
    const WATCHED: &str = "stop = \"steady\"";
    let is_freed = has_monitor && now.lines().all(|line| line != WATCHED);
    let is_free =
        |line: &str| line.starts_with("end_time = ") || (is_freed && line.starts_with("stop = "));
    let missing = |from: &str, other: &str, same: fn(&str, &str) -> bool| {
        let mut lines = from.lines().filter(|line| !is_free(line));
        let line = lines.find(|line| !other.lines().any(|l| same(line, l)));
        line.map(str::to_owned)
    };
    let gone = missing(earlier, now, is_same_line);
    let new = missing(now, earlier, |now, earlier| is_same_line(earlier, now));
    match (gone, new) {
        (None, None) => None,
        (Some(then), None) => Some(format!("the scene had `{then}` when it was made")),
        (None, Some(now)) => Some(format!("the scene had no `{now}` when it was made")),
        (Some(then), Some(now)) => Some(format!(
            "the scene had `{then}` when it was made and has `{now}` now"
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_end_may_differ() {
        let scene = "end_time = 1.0\nspacing = 0.1\nstop = \"steady\"\n";
        let longer = scene.replace("1.0", "2.0");
        assert_eq!(difference(scene, &longer, true), None);
        assert_eq!(
            difference("spacing = 0.1\n", "end_time = 2.0\nspacing = 0.1\n", false),
            None
        );
        let to_the_end = longer.replace("steady", "end-time");
        assert_eq!(difference(scene, &to_the_end, true), None);
        for (now, has_monitor) in [(to_the_end, false), (longer.replace("0.1", "0.2"), true)] {
            assert!(difference(scene, &now, has_monitor).is_some(), "{now}");
        }
        assert!(difference("stop = \"end-time\"\n", "stop = \"steady\"\n", false).is_some());
    }
}
