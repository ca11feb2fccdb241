//! The packed scene before it runs: gas, buffers and ghosts, in space a slice.

use std::path::Path;

use aero_solver::frame::Frame;
use aero_validation::pictures::particles::{ParticlePicture, Slab};

use super::error::OutputError;

/// Diameter of the discs in particle sizes: small enough to see each by itself.
const DISC: f64 = 0.8;

/// Draws what `frame` holds of a scene, in space at `slice` along z: gas, inlet, outlet and ghosts in four colours.
pub fn draw_scene(
    path: &Path,
    name: &str,
    slice: Option<f64>,
    spacing: f64,
    frame: &Frame,
) -> Result<(), OutputError> {
    let kinds: Vec<f64> = frame.kind.iter().map(|&kind| f64::from(kind)).collect();
    let sizes = vec![DISC * spacing; kinds.len()];
    let title = format!("{name}: 0 gas, 1 inlet, 2 outlet, 3 ghosts");
    let mut picture = ParticlePicture::new(&title, &frame.position, &sizes, &kinds, "kind");
    picture.value_range = Some([0.0, 3.0]);
    picture.slab = slice.map(|centre| Slab {
        axis: 2,
        centre,
        half: 0.5 * spacing,
    });
    picture
        .save(path)
        .map_err(|error| OutputError::new(path, std::io::Error::other(error)))
}
