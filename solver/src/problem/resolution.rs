//! How finely the gas is resolved, as a function of place.

use aero_geometry::Vector;

/// The distance `dx(x)` between neighbouring particles as they start, in lengths of the scene: the same everywhere. Cells of points
/// that stay are split from the lattice, and know their own.
///
/// Whatever looks at a place asks [`Self::at`] it; what lays out the lattice and reaches around all of it asks for
/// [`Self::lattice`], and what must not miss the smallest part for [`Self::finest`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Resolution {
    lattice: f64,
}

impl Resolution {
    /// One spacing everywhere.
    pub const fn uniform(spacing: f64) -> Self {
        Self { lattice: spacing }
    }

    /// Spacing at `place`.
    pub fn at<const D: usize>(&self, _place: &Vector<D>) -> f64 {
        self.lattice
    }

    /// Spacing of the lattice that the gas starts on, the coarsest.
    pub const fn lattice(&self) -> f64 {
        self.lattice
    }

    /// The smallest spacing anywhere.
    pub const fn finest(&self) -> f64 {
        self.lattice
    }
}
