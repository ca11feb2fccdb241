//! Everything that is written to disk, one format per file. Takes snapshots, never the solver's
//! own state, and decides nothing about when to write.

mod atomic;
mod background;
mod checkpoint;
mod ghosts;
mod history;
mod memory;
mod packing;
mod packing_picture;
mod particles;
mod pvd;
mod summary;
mod surface;
mod vtp;

pub use atomic::write_json;
pub use background::Background;
pub use checkpoint::{
    CHECKPOINT, CheckpointError, checkpoint_bytes, read_checkpoint, remove_checkpoint,
    write_checkpoint,
};
use ghosts::write_ghosts;
pub use history::{History, HistoryRow};
pub use memory::peak_memory;
pub use packing::write_packing;
pub use particles::write_frame;
pub use pvd::Collection;
pub use summary::{BodySummary, Conservation, Particles, Summary};
pub use surface::write_surface;

use std::path::{Path, PathBuf};

/// A file that could not be written.
#[derive(Debug, thiserror::Error)]
#[error("cannot write `{}`: {source}", path.display())]
pub struct OutputError {
    path: PathBuf,
    source: std::io::Error,
}

impl OutputError {
    /// The error of the file at `path`.
    pub fn new(path: &Path, source: std::io::Error) -> Self {
        Self {
            path: path.to_owned(),
            source,
        }
    }
}

/// Makes the folder for output, and those above it.
pub fn make_folder(path: &Path) -> Result<(), OutputError> {
    std::fs::create_dir_all(path).map_err(|source| OutputError::new(path, source))
}
