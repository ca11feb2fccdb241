//! What the caller asks of the packer.

use aero_geometry::{Bounds, Vector, Watch};

use crate::PackError;

/// Most particles that one packing may produce, ghosts and fluid together.
pub const MAX_PARTICLES: f64 = 5e8;

/// How to pack.
#[derive(Clone, Debug)]
pub struct PackOptions<const D: usize> {
    /// Spacing `dx` of the ghosts.
    pub spacing: f64,
    /// Number of ghost layers; five cover the support at `h = 1.5 dx`.
    pub layers: usize,
    /// Only ghosts inside this box are kept; needed for endless walls.
    pub region: Option<Bounds<D>>,
    /// Which faces of that box, the low and the high one across each axis, are mirrors: a body that one cuts goes on beyond it as its own
    /// image, and no ghost stands beside that of itself. Of two mirrors across one axis the first that cuts the body counts.
    pub mirrors: [[bool; 2]; D],
    /// Number of conforming fluid layers to pack outside the body as well; 0 for none.
    pub fluid_layers: usize,
    /// A corner of the fluid lattice, whose points are `anchor + (i + 1/2) dx`. Walls along the
    /// lattice get ghosts that continue it.
    pub anchor: Vector<D>,
    /// Pack a body all the same that loses more than two per cent of its surface.
    pub allow_loss: bool,
    /// Told how far the packing is.
    pub watch: Watch,
}

impl<const D: usize> PackOptions<D> {
    /// Five layers at `spacing`, no fluid, lattice corner at the origin, nobody told.
    pub fn new(spacing: f64) -> Self {
        Self {
            spacing,
            layers: 5,
            region: None,
            mirrors: [[false; 2]; D],
            fluid_layers: 0,
            anchor: Vector::zeros(),
            allow_loss: false,
            watch: Watch::default(),
        }
    }

    pub(crate) fn check(&self) -> Result<(), PackError> {
        if !(self.spacing.is_finite() && self.spacing > 0.0) {
            return Err(PackError::Spacing(self.spacing));
        }
        if self.layers == 0 {
            return Err(PackError::NoLayers);
        }
        Ok(())
    }
}
