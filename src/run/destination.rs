//! Where a run writes.

use std::path::Path;

/// Where a run writes, and whether it goes on from what is there.
#[derive(Clone, Copy, Debug)]
pub struct Destination<'a> {
    /// Folder for frames, history, summary and checkpoint.
    pub folder: &'a Path,
    /// All values that the run depends on, one per line.
    pub scene: &'a str,
    /// The same with whole paths, to be run again from anywhere.
    pub noted: &'a str,
    /// Go on from the checkpoint, where there is one.
    pub resume: bool,
    /// Leave out the frame of the start: of a flow that begins as another run's last frame.
    pub skips_start: bool,
    /// Write over what a run of another scene has left.
    pub overwrite: bool,
}
