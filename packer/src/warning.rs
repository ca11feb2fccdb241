//! What the user should know, in the words that every command uses.

use std::fmt;

use serde::{Serialize, Serializer};

/// What a warning is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum About {
    /// Surface that no ghost covers.
    Cover,
    /// Volume that the packing lacks or has too much.
    Volume,
    /// Ghosts too close to each other.
    Gap,
    /// A part too thin to be relied on.
    Thin,
    /// A surface that is broken.
    Surface,
    /// The unit of length.
    Unit,
    /// Symmetry that is not kept.
    Symmetry,
    /// How bodies, sides and the flow go together.
    Scene,
}

/// Something that the user should know. It prints, and is serialized, as one line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Warning {
    /// What it is about.
    pub about: About,
    /// The body, where there may be others.
    pub body: Option<String>,
    /// Axis and end of the domain's side that is too near, where that is the matter.
    pub side: Option<(usize, usize)>,
    /// What is the matter, where, and what mends it.
    pub text: String,
}

impl Warning {
    /// A warning about the only body.
    pub fn new(about: About, text: impl Into<String>) -> Self {
        Self {
            about,
            body: None,
            side: None,
            text: text.into(),
        }
    }

    /// The same, of a side of the domain that is too near.
    #[must_use]
    pub fn beside(self, side: (usize, usize)) -> Self {
        Self {
            side: Some(side),
            ..self
        }
    }

    /// The same, of the body of that name.
    #[must_use]
    pub fn of(&self, body: &str) -> Self {
        Self {
            body: Some(body.to_owned()),
            ..self.clone()
        }
    }
}

impl fmt::Display for Warning {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(body) = &self.body {
            write!(formatter, "body `{body}`: ")?;
        }
        formatter.write_str(&self.text)
    }
}

impl Serialize for Warning {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}
