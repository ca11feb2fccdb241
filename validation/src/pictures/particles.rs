//! Particles coloured by a value, on equal axes, with a colour bar and lines of theory over them.

use super::colour::{BLACK, Colour, RED};

/// A line over the particles, such as the theoretical shock.
#[derive(Clone, Debug, PartialEq)]
pub struct Overlay {
    /// What it is, for the legend; empty for none.
    pub label: String,
    /// Points in the plane of the picture.
    pub points: Vec<[f64; 2]>,
    /// Colour; red stands out from the map.
    pub colour: Colour,
    /// Dashed rather than solid.
    pub dashed: bool,
}

impl Overlay {
    /// A dashed red line of theory.
    pub fn theory(label: &str, points: Vec<[f64; 2]>) -> Self {
        Self {
            label: label.to_owned(),
            points,
            colour: RED,
            dashed: true,
        }
    }

    /// A solid black line, such as a body's outline.
    pub fn outline(points: Vec<[f64; 2]>) -> Self {
        Self {
            label: String::new(),
            points,
            colour: BLACK,
            dashed: false,
        }
    }
}

/// Only particles within `half` of `centre` along an axis are drawn: a cut through a space flow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slab {
    /// Axis across the cut, 0 to 2.
    pub axis: usize,
    /// Its middle.
    pub centre: f64,
    /// Half its thickness, usually half a spacing.
    pub half: f64,
}

/// The picture.
#[derive(Clone, Debug)]
pub struct ParticlePicture<'a> {
    /// Heading.
    pub title: &'a str,
    /// Positions.
    pub position: &'a [[f64; 3]],
    /// Diameters of the discs, in the positions' unit: the spacing, or `(m/rho)^(1/D)`.
    pub diameter: &'a [f64],
    /// Values to colour by.
    pub value: &'a [f64],
    /// What the values are, with their unit.
    pub value_label: &'a str,
    /// Ends of the colour bar; by default the values' 0.5 and 99.5 per cent points.
    pub value_range: Option<[f64; 2]>,
    /// Axes drawn to the right and upwards, 0 to 2.
    pub axes: [usize; 2],
    /// Labels of these axes, with their unit.
    pub axis_labels: [&'a str; 2],
    /// Part of the plane to draw, `[[x_min, x_max], [y_min, y_max]]`; by default all.
    pub window: Option<[[f64; 2]; 2]>,
    /// Cut through a space flow; by default all particles.
    pub slab: Option<Slab>,
    /// Lines over the particles.
    pub overlays: Vec<Overlay>,
}

impl<'a> ParticlePicture<'a> {
    /// A picture of all particles in the plane of the first two axes.
    pub fn new(
        title: &'a str,
        position: &'a [[f64; 3]],
        diameter: &'a [f64],
        value: &'a [f64],
        value_label: &'a str,
    ) -> Self {
        Self {
            title,
            position,
            diameter,
            value,
            value_label,
            value_range: None,
            axes: [0, 1],
            axis_labels: ["x", "y"],
            window: None,
            slab: None,
            overlays: Vec::new(),
        }
    }
}
