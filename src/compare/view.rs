//! A picture of the particles of a run.

use std::path::PathBuf;

use aero_geometry::kernel::SMOOTHING_RATIO;
use aero_solver::frame::Frame;
use aero_validation::pictures::particles::{Overlay, ParticlePicture, Slab};

use super::context::CompareError;

/// The gas of a run, to be drawn.
pub struct View<'a> {
    title: String,
    path: PathBuf,
    gas: &'a Frame,
    value: (&'a [f64], &'a str),
    /// Length of the picture's unit, in the scene's.
    pub unit: f64,
    /// Where a particle is drawn, in the scene's unit; where it is unless given.
    pub drawn_at: fn([f64; 3]) -> [f64; 3],
    /// Lines on top, in the picture's unit.
    pub overlays: Vec<Overlay>,
    /// The particles that are drawn, where not all.
    pub slab: Option<Slab>,
    /// The part that is drawn, where not all.
    pub window: Option<[[f64; 2]; 2]>,
    /// What the axes are called.
    pub axis_labels: [&'a str; 2],
}

impl<'a> View<'a> {
    pub(super) fn new(
        title: String,
        path: PathBuf,
        gas: &'a Frame,
        value: (&'a [f64], &'a str),
    ) -> Self {
        Self {
            title,
            path,
            gas,
            value,
            unit: 1.0,
            drawn_at: |at| at,
            overlays: Vec::new(),
            slab: None,
            window: None,
            axis_labels: ["x", "y"],
        }
    }

    /// Only the layer of particles beside the plane `z = 0`.
    pub fn beside_symmetry(mut self, spacing: f64) -> Self {
        self.slab = Some(Slab {
            axis: 2,
            centre: 0.5 * spacing,
            half: 0.5 * spacing,
        });
        self
    }

    /// Draws it.
    pub fn save(self) -> Result<(), CompareError> {
        let positions = self.gas.position.iter();
        let position: Vec<[f64; 3]> = positions
            .map(|&at| (self.drawn_at)(at).map(|x| x / self.unit))
            .collect();
        let lengths = self.gas.smoothing_length.iter();
        let diameter: Vec<f64> = lengths.map(|h| h / SMOOTHING_RATIO / self.unit).collect();
        let (value, label) = self.value;
        let mut picture = ParticlePicture::new(&self.title, &position, &diameter, value, label);
        picture.overlays = self.overlays;
        picture.slab = self.slab;
        picture.window = self.window;
        picture.axis_labels = self.axis_labels;
        Ok(picture.save(&self.path)?)
    }
}
