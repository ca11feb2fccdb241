//! What can be wrong with a scene.

use std::path::PathBuf;

/// Why a scene cannot be read or run.
#[derive(Debug, thiserror::Error)]
pub enum SceneError {
    /// The file cannot be read.
    #[error("cannot read scene `{}`: {source}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// The file is not a scene; the message shows the position.
    #[error("{origin}: {}", .source.to_string().trim_end())]
    Parse {
        /// The file, or the name of a scene in memory.
        origin: String,
        /// What the reader said, with line, column and carets.
        source: Box<toml::de::Error>,
    },
    /// An override cannot be applied.
    #[error("`--set {setting}`: {message}")]
    Override {
        /// What was typed.
        setting: String,
        /// What is wrong with it.
        message: String,
    },
    /// A value makes no sense together with the others.
    #[error("`{place}`: {message}")]
    Value {
        /// Key in the file, with its section.
        place: String,
        /// What is wrong and what would be right.
        message: String,
    },
    /// A body cannot be made or packed.
    #[error("body `{body}`: {message}")]
    Body {
        /// Its name.
        body: String,
        /// What is wrong and what would be right.
        message: String,
    },
}

impl SceneError {
    /// An error about the value at `place`.
    pub(crate) fn value(place: impl Into<String>, message: impl Into<String>) -> Self {
        Self::Value {
            place: place.into(),
            message: message.into(),
        }
    }

    /// The same of a section that is like another one.
    #[must_use]
    pub(crate) fn moved(self, from: &str, to: &str) -> Self {
        match self {
            Self::Value { place, message } => Self::Value {
                place: place.replacen(from, to, 1),
                message,
            },
            other => other,
        }
    }

    /// An error about a body.
    pub(crate) fn body(body: impl Into<String>, message: impl Into<String>) -> Self {
        Self::Body {
            body: body.into(),
            message: message.into(),
        }
    }
}
