//! The quality report of one packing.

use serde::Serialize;

/// What `NAME-pack.json` holds; percentages and degrees as named.
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
    /// Standard deviation of the summed density, per cent.
    pub density_std_percent: f64,
    /// Largest deviation of the summed density from one, per cent.
    pub density_max_percent: f64,
    /// Ghosts' summed volume against the exact shell volume, per cent.
    pub shell_volume_error_percent: f64,
    /// Largest distance of a wall-layer ghost from depth dx/2, in dx.
    pub wall_offset_max: f64,
    /// Largest angle between a ghost's normal and the exact one, where the exact one is known.
    pub normal_error_max_deg: Option<f64>,
    /// Smallest distance between two ghosts, in dx.
    pub min_gap: f64,
    /// Largest mirror error over the body's symmetry planes, in dx; none without a plane.
    pub mirror_error_max: Option<f64>,
    /// Wall time of the packing.
    pub wall_seconds: f64,
    /// What was wrong with the body and what was done.
    pub repairs: Vec<String>,
    /// What the user should know.
    pub warnings: Vec<String>,
}
