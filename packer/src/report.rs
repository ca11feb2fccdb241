//! The quality report of one packing.

use serde::Serialize;

use crate::Warning;

/// What `NAME-pack.json` holds; percentages and degrees as named.
///
/// Densities are sums `Σ V W` with the flow's kernel, the quintic spline at `h = 1.5 dx`, at the
/// wall layers' particles inside the region. Where fluid was packed they are sums over ghosts,
/// fluid and lattice at the wall layers of both sides, and one is perfect. Without fluid half of
/// the kernel's support is empty; the ghosts' sum is then compared with that of ideal layers, in
/// which each layer's exact volume is spread evenly over its middle level.
#[derive(Clone, Debug, Default, Serialize)]
pub struct PackReport {
    /// Spacing packed at.
    pub spacing: f64,
    /// Number of ghosts.
    pub ghosts: usize,
    /// Number of conforming fluid particles.
    pub fluid: usize,
    /// Ghosts per layer, wall layer first.
    pub layer_counts: Vec<usize>,
    /// Standard deviation of the summed density, per cent; in space, without fluid, away from parts thinner than two spacings.
    pub density_std_percent: f64,
    /// Largest deviation of the summed density, per cent, thin parts included.
    pub density_max_percent: f64,
    /// Where that is, where no fluid was packed.
    pub density_max_at: Vec<f64>,
    /// Ghosts' summed volume against the exact shell volume, per cent; ghosts at the region's
    /// border count with the part of their cell that is inside.
    pub shell_volume_error_percent: f64,
    /// Largest distance of a wall-layer ghost from depth dx/2, in dx; those in thin parts aside.
    pub wall_offset_max: f64,
    /// Largest angle between a ghost's normal and the exact one, where the exact one is known: the
    /// packer takes its normals from the shape, so only who knows a better shape can fill this in.
    pub normal_error_max_deg: Option<f64>,
    /// Smallest distance between two ghosts, in dx.
    pub min_gap: f64,
    /// Ghosts nearer than half a spacing to another one.
    pub coincident_ghosts: usize,
    /// Largest distance from the wall layer's middle level to the nearest ghost, in dx: 0.5 for an
    /// even row, 0.62 to 0.71 for an even sheet. Thin parts aside.
    pub layer_hole_max: f64,
    /// Largest distance from a place of the true surface, sampled by area, to the nearest ghost, in dx: 0.7 to 0.9 where every
    /// part has its ghosts.
    pub hole_max: f64,
    /// The place of the largest hole.
    pub hole_at: Vec<f64>,
    /// Part of the surface farther than 1.25 dx from every ghost, per cent.
    pub uncovered_area_percent: f64,
    /// Area of the surface in the region; length in the plane.
    pub surface_area: f64,
    /// Volume of ghosts and of the core that they enclose against the body's own, per cent; against that of the layers where a region cuts the
    /// body off.
    pub volume_error_percent: f64,
    /// Number of ghosts in parts too thin for the layers of both sides (tips, fins).
    pub thin: usize,
    /// Largest mirror error over the body's symmetry planes, in dx; none without a plane.
    pub mirror_error_max: Option<f64>,
    /// Wall time of the packing.
    pub wall_seconds: f64,
    /// What was wrong with the body and what was done; for the reader of the body to fill in.
    pub repairs: Vec<String>,
    /// What the user should know.
    pub warnings: Vec<Warning>,
}
