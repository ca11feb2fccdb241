//! Directions of a file, as they are typed.

use std::fmt;
use std::str::FromStr;

use aero_geometry::Vector;
use aero_solver::problem::AXES;
use serde::Deserialize;

/// A direction along an axis of a body's file: -x, +z.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(try_from = "String")]
pub struct Way {
    /// The axis.
    pub axis: usize,
    /// True of the way down it.
    pub is_negative: bool,
}

impl Way {
    /// A step that way.
    pub fn vector(self) -> Vector<3> {
        let mut vector = Vector::<3>::zeros();
        vector[self.axis] = if self.is_negative { -1.0 } else { 1.0 };
        vector
    }
}

impl fmt::Display for Way {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sign = if self.is_negative { "-" } else { "+" };
        write!(f, "{sign}{}", AXES[self.axis])
    }
}

impl FromStr for Way {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let text = text.trim();
        let (is_negative, letter) = match text.strip_prefix('-') {
            Some(rest) => (true, rest),
            None => (false, text.strip_prefix('+').unwrap_or(text)),
        };
        let axis = AXES.iter().position(|name| *name == letter);
        let axis =
            axis.ok_or_else(|| format!("`{text}` is not a direction of the file, as -x or +z"))?;
        Ok(Self { axis, is_negative })
    }
}

impl TryFrom<String> for Way {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        text.parse()
    }
}
