//! Why a run has no good end.

use crate::output::{CheckpointError, OutputError, Summary};

/// Why a run has no good end.
#[derive(Debug, thiserror::Error)]
pub enum RunError {
    /// The case cannot be set up.
    #[error("{0}")]
    SetUp(String),
    /// The run cannot go on; the summary tells how far it came.
    #[error("{reason}")]
    Stopped {
        /// Where and why.
        reason: String,
        /// The run up to there.
        summary: Box<Summary>,
    },
    /// The folder is taken.
    #[error("{0}")]
    Occupied(String),
    /// A file cannot be written.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// There is nothing to go on from.
    #[error(transparent)]
    Resume(#[from] CheckpointError),
}
