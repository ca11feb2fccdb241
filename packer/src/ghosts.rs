//! The packed particles of one body.

use aero_geometry::Vector;

use crate::PackReport;

/// Particles packed around one body's surface, ghosts inside it or fluid outside; all arrays have
/// the same length.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ghosts<const D: usize> {
    /// Positions.
    pub position: Vec<Vector<D>>,
    /// Unit normals at the closest surface point, out of the body.
    pub normal: Vec<Vector<D>>,
    /// Signed distance to the surface, negative inside. The mirror point of a ghost is
    /// `position + 2 |distance| normal`.
    pub distance: Vec<f64>,
    /// Volumes (m^D), constant for the whole run (Villodi & Ramachandran, section 3.5.1).
    pub volume: Vec<f64>,
    /// Layer number, 0 at the wall; layer `k` lies at depth (height, for fluid) `(k + 1/2) dx`.
    pub layer: Vec<u32>,
    /// Smooth part of the surface that the ghost belongs to.
    pub face: Vec<u32>,
}

/// The outcome of a packing.
#[derive(Clone, Debug, Default)]
pub struct Packing<const D: usize> {
    /// Ghosts inside the body.
    pub ghosts: Ghosts<D>,
    /// Conforming fluid particles outside; empty where none were asked for.
    pub fluid: Ghosts<D>,
    /// Where fluid was packed: the lattice sites at signed distances up to this give way to it.
    pub lattice_begins: Option<f64>,
    /// How good the packing is.
    pub report: PackReport,
}
