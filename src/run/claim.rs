//! A folder for results: one run at a time writes into it, and what another scene has left there is not written over unasked.

use std::fs::{File, TryLockError};
use std::path::Path;

use super::destination::Destination;
use super::error::RunError;
use crate::output::OutputError;

/// Held while a run writes. The system lets go of it when the process ends, however that comes about.
const LOCK: &str = ".lock";

/// The scene as it was run, a line for each value.
const SCENE: &str = "run.toml";

/// A folder that belongs to this run as long as this lives.
#[derive(Debug)]
pub(super) struct Claim {
    _lock: Option<File>,
}

impl Claim {
    /// Claims the folder, which exists.
    ///
    /// # Errors
    /// A folder that another run writes into, or that holds the results of another scene that may not be written over.
    pub(super) fn new(destination: &Destination<'_>) -> Result<Self, RunError> {
        let folder = destination.folder;
        let lock = File::options()
            .create(true)
            .truncate(false)
            .write(true)
            .open(folder.join(LOCK));
        // A folder that takes no files says so when the first is written; one whose system knows no locks has none.
        let lock = lock.ok().map(|file| (file.try_lock(), file));
        let lock = match lock {
            Some((Err(TryLockError::WouldBlock), _)) => {
                return Err(RunError::Occupied(format!(
                    "another run is writing into `{}`; wait for its end, or give `--out` another folder",
                    folder.display()
                )));
            }
            Some((_, file)) => Some(file),
            None => None,
        };
        if !destination.resume && !destination.overwrite && holds_another(folder, destination.noted)
        {
            return Err(RunError::Occupied(format!(
                "`{}` holds the results of another run; give `--out` another folder, or `--overwrite`",
                folder.display()
            )));
        }
        Ok(Self { _lock: lock })
    }

    /// Notes the scene that is run.
    ///
    /// # Errors
    /// A folder that takes no files.
    pub(super) fn note(destination: &Destination<'_>) -> Result<(), OutputError> {
        let path = destination.folder.join(SCENE);
        std::fs::write(&path, destination.noted).map_err(|error| OutputError::new(&path, error))
    }
}

/// True where the results in `folder` are those of `scene`, a line for each value, its paths whole.
pub fn is_of(folder: &Path, scene: &str) -> bool {
    std::fs::read_to_string(folder.join(SCENE)).ok().as_deref() == Some(scene)
}

/// True where a run of another scene has left results.
fn holds_another(folder: &Path, scene: &str) -> bool {
    if !folder.join("summary.json").exists() && !folder.join("history.csv").exists() {
        return false;
    }
    !is_of(folder, scene)
}
