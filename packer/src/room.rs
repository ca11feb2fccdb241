//! What room for layers is, and on which side of the surface and where it is looked for.

use aero_geometry::Vector;

/// Which side of the surface is packed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Side {
    /// Inside the body.
    Ghosts,
    /// Outside it.
    Fluid,
}

/// How much room a layer has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Room {
    /// The layer lies below a smooth part of the surface.
    Clear,
    /// A ridge of the distance runs through it, as below a corner.
    Ridge,
    /// Too little.
    Thin,
}

/// A cube in which room is looked for.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Probe<const D: usize> {
    /// Centre.
    pub centre: Vector<D>,
    /// Edge length.
    pub step: f64,
    /// Signed distance at the centre.
    pub distance: f64,
    /// Its gradient there.
    pub normal: Vector<D>,
}

impl<const D: usize> Probe<D> {
    /// Half of what it spans along the normal.
    pub fn reach(&self) -> f64 {
        0.5 * self.step * self.normal.abs().sum()
    }
}
