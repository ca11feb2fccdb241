//! The packed scene before it runs: gas, buffers and ghosts, in space a slice through the middle.

use std::path::Path;

use aero_solver::frame::Frame;
use aero_validation::pictures::particles::{ParticlePicture, Slab};

use super::error::OutputError;

/// Diameter of the discs in particle sizes: small enough to see each by itself.
const DISC: f64 = 0.8;

/// Draws what `frame` holds of a scene of that many dimensions: gas, inlet, outlet and ghosts in four colours.
pub fn draw_scene(
    path: &Path,
    name: &str,
    dimension: usize,
    spacing: f64,
    frame: &Frame,
) -> Result<(), OutputError> {
    let kinds: Vec<f64> = frame.kind.iter().map(|&kind| f64::from(kind)).collect();
    let sizes = vec![DISC * spacing; kinds.len()];
    let title = format!("{name}: 0 gas, 1 inlet, 2 outlet, 3 ghosts");
    let mut picture = ParticlePicture::new(&title, &frame.position, &sizes, &kinds, "kind");
    picture.value_range = Some([0.0, 3.0]);
    if dimension == 3 {
        // Where a body is: through the middle of the ghosts, else of the gas.
        let ghosts = frame.position.iter().zip(&frame.kind);
        let mut heights: Vec<f64> = ghosts
            .filter(|(_, kind)| **kind == 3)
            .map(|(position, _)| position[2])
            .collect();
        if heights.is_empty() {
            heights = frame.position.iter().map(|position| position[2]).collect();
        }
        heights.sort_by(f64::total_cmp);
        let centre = heights.get(heights.len() / 2).copied().unwrap_or(0.0);
        picture.slab = Some(Slab {
            axis: 2,
            centre,
            half: 0.5 * spacing,
        });
    }
    picture
        .save(path)
        .map_err(|error| OutputError::new(path, std::io::Error::other(error)))
}
