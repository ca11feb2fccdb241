//! What the caller asks of the packer.

use aero_geometry::Bounds;

/// How to pack.
#[derive(Clone, Debug)]
pub struct PackOptions<const D: usize> {
    /// Spacing `dx` of the ghosts.
    pub spacing: f64,
    /// Number of ghost layers; five cover the support at `h = 1.5 dx`.
    pub layers: usize,
    /// Only ghosts inside this box are kept; needed for endless walls.
    pub region: Option<Bounds<D>>,
    /// Number of conforming fluid layers to pack outside the body as well; 0 for none.
    pub fluid_layers: usize,
}
