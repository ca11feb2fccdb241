//! What can be wrong with a body, said so that its author can mend it.

use std::path::PathBuf;

/// Why a shape could not be made.
#[derive(Debug, thiserror::Error)]
pub enum GeometryError {
    /// A dimension of a named body is out of range.
    #[error("{body}: {reason}")]
    Dimension {
        /// The kind of body, as users write it.
        body: &'static str,
        /// What is wrong with which number, and what is allowed.
        reason: String,
    },
    /// Pieces do not form a curve that bounds a solid.
    #[error("outline: {0}")]
    Curve(String),
    /// A text file of points cannot be read.
    #[error("line {line}: {reason}")]
    Text {
        /// Line number, from 1.
        line: usize,
        /// What is wrong there.
        reason: String,
    },
    /// An STL file cannot be read.
    #[error("stl: {0}")]
    Stl(String),
    /// A file of another format cannot be read, or is of one that is not read.
    #[error("{format}: {reason}")]
    File {
        /// The format.
        format: &'static str,
        /// What is wrong, and what to do.
        reason: String,
    },
    /// Triangles do not enclose a solid.
    #[error("surface: {0}")]
    Surface(String),
    /// A placement is not a similarity.
    #[error("placement: {0}")]
    Placement(String),
    /// A file cannot be opened or read.
    #[error("cannot read `{path}`: {source}")]
    Read {
        /// The file.
        path: PathBuf,
        /// The operating system's reason.
        source: std::io::Error,
    },
    /// A file was read, but what it holds is wrong.
    #[error("`{path}`: {source}")]
    In {
        /// The file.
        path: PathBuf,
        /// What is wrong in it.
        source: Box<GeometryError>,
    },
}

impl GeometryError {
    pub(crate) fn file(format: &'static str, reason: impl Into<String>) -> Self {
        Self::File {
            format,
            reason: reason.into(),
        }
    }

    pub(crate) fn dimension(body: &'static str, reason: impl Into<String>) -> Self {
        Self::Dimension {
            body,
            reason: reason.into(),
        }
    }
}

/// What closes holes.
pub(crate) const FILL: &str = "`--fill` (in a scene, `fill = true`) closes every hole";

/// What makes a solid of a sheet.
pub(crate) const THICKEN: &str =
    "`--thicken T` (in a scene, `thicken = T`) makes a solid T thick of a sheet";

/// What makes a solid of anything.
pub(crate) const WRAP: &str =
    "`--wrap` (in a scene, `wrap = true`) lays a closed surface around whatever it is";

/// Refuses triangles that are closed, but around nothing.
pub(crate) fn no_volume() -> GeometryError {
    GeometryError::Surface(format!(
        "encloses no volume; give a closed surface around a solid, or {THICKEN}"
    ))
}

/// Refuses a number that is not finite and above zero.
pub(crate) fn positive(body: &'static str, name: &str, value: f64) -> Result<f64, GeometryError> {
    if value.is_finite() && value > 0.0 {
        Ok(value)
    } else {
        Err(GeometryError::dimension(
            body,
            format!("{name} is {value}, but must be above zero"),
        ))
    }
}

/// Refuses a number that is not finite.
pub(crate) fn finite(body: &'static str, name: &str, value: f64) -> Result<f64, GeometryError> {
    if value.is_finite() {
        Ok(value)
    } else {
        Err(GeometryError::dimension(
            body,
            format!("{name} is {value}, but must be a finite number"),
        ))
    }
}

/// Refuses an angle in degrees that is not strictly between `low` and `high`.
pub(crate) fn angle_between(
    body: &'static str,
    name: &str,
    degrees: f64,
    [low, high]: [f64; 2],
) -> Result<f64, GeometryError> {
    if degrees > low && degrees < high {
        Ok(degrees.to_radians())
    } else {
        Err(GeometryError::dimension(
            body,
            format!("{name} is {degrees} degrees, but must be between {low} and {high}"),
        ))
    }
}
