//! The packed particles of one body.

use aero_geometry::Vector;

/// Ghost particles of one body; all arrays have the same length.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ghosts<const D: usize> {
    /// Positions.
    pub position: Vec<Vector<D>>,
    /// Unit normals at the closest surface point, out of the body.
    pub normal: Vec<Vector<D>>,
    /// Signed distance to the surface, negative inside.
    pub distance: Vec<f64>,
    /// Volumes (m^D), constant for the whole run (Villodi & Ramachandran, section 3.5.1).
    pub volume: Vec<f64>,
    /// Layer number, 0 at the wall; layer `k` lies at depth `(k + 1/2) dx`.
    pub layer: Vec<u32>,
    /// Smooth part of the surface that the ghost belongs to.
    pub face: Vec<u32>,
}
