//! The thinnest part of a body, and what to say of it.

use crate::{About, Warning};

/// Thickness, in spacings, below which a part cannot be represented.
pub(crate) const THINNEST: f64 = 0.3;

/// The least of the local thicknesses.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Thinnest {
    /// In spacings.
    pub thickness: f64,
    /// Where.
    pub at: Vec<f64>,
    /// The spacing packed at.
    pub spacing: f64,
}

impl Thinnest {
    /// What to tell the user.
    pub fn warning(&self) -> Warning {
        let text = format!(
            "the body is only {:.2} spacings ({:.3e}) thick near {:.4?}: gas may pass through; a spacing of {:.2e} or less \
             keeps this part",
            self.thickness,
            self.thickness * self.spacing,
            self.at,
            self.thickness * self.spacing / THINNEST
        );
        Warning::new(About::Thin, text)
    }
}
