//! The corner of a variant.

use aero_validation::exact::oblique::{ObliqueShock, Strength, oblique_shock};

use crate::context::CompareError;

/// A corner and its stream.
#[derive(Clone, Copy, Debug)]
pub struct Corner {
    pub mach: f64,
    pub gamma: f64,
    /// Degrees.
    pub angle: f64,
    pub end_time: f64,
    /// Largest error of the plateau, per cent.
    pub plateau: f64,
    /// With ghosts of constant volume; without, particles leak through the ramp (Villodi &
    /// Ramachandran 2024, fig. 2a).
    pub is_tight: bool,
}

impl Corner {
    /// The shock that theory has for it.
    pub fn shock(&self) -> Result<ObliqueShock, CompareError> {
        let angle = self.angle.to_radians();
        Ok(oblique_shock(self.mach, angle, self.gamma, Strength::Weak)?)
    }
}
