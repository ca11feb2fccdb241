//! Why a body cannot be flown.

/// Why a body cannot be flown.
#[derive(Debug, thiserror::Error)]
pub enum FlyError {
    /// The file, or what it holds.
    #[error("{0}")]
    Body(String),
    /// What was asked for.
    #[error("{0}")]
    Asked(String),
    /// A result that cannot be read back, or a report that cannot be written.
    #[error("{0}")]
    Files(String),
}
