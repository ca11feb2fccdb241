//! `picture-NNNNNN.png`: a plane of the flow, coloured; of a flow on a line a curve.

use aero_solver::problem::AXES;
use std::path::Path;

use aero_validation::pictures::curves::{Curves, Panel, Series, Style};
use aero_validation::pictures::raster::RasterPicture;
use aero_validation::pictures::{PictureError, schlieren, viridis};

use super::error::OutputError;
use crate::sample::{Quantity, Raster, View};

/// Parts of all values between which colours range, of schlieren and of the rest.
const STEEPEST: [f64; 2] = [0.0, 0.99];
const NEARLY_ALL: [f64; 2] = [0.002, 0.998];

/// What a picture says beside its colours.
#[derive(Clone, Debug, PartialEq)]
pub struct Caption {
    /// Name of the scene, and what time it is.
    pub title: String,
    /// What it shows.
    pub quantity: Quantity,
    /// Values are in SI units.
    pub is_si: bool,
}

impl Caption {
    /// The quantity with its unit.
    fn quantity(&self) -> String {
        let (name, unit) = match self.quantity {
            Quantity::Mach => ("Mach number", ""),
            Quantity::Pressure => ("pressure", "Pa"),
            Quantity::PressureCoefficient => ("pressure coefficient", ""),
            Quantity::Density => ("density", "kg/m³"),
            Quantity::Temperature => ("temperature", "K"),
            Quantity::Entropy => ("entropy over the free stream's, in c_v", ""),
            Quantity::Speed => ("speed", "m/s"),
            Quantity::Schlieren => ("density gradient", "kg/m⁴"),
        };
        self.with_unit(name, unit)
    }

    fn with_unit(&self, name: &str, unit: &str) -> String {
        if self.is_si && !unit.is_empty() {
            format!("{name}, {unit}")
        } else {
            name.to_owned()
        }
    }

    /// An axis with its unit.
    fn axis(&self, axis: &[f64; 3]) -> String {
        let whole = (0..3).find(|&k| (axis[k] - 1.0).abs() < 1e-12);
        let name = whole.map_or_else(
            || format!("along ({:.3}, {:.3}, {:.3})", axis[0], axis[1], axis[2]),
            |k| AXES[k].to_owned(),
        );
        self.with_unit(&name, "m")
    }
}

/// Draws a plane; colours go over `range`, or over what nearly all values lie in.
pub fn draw_plane(
    path: &Path,
    caption: &Caption,
    view: &View,
    raster: &Raster,
    range: Option<[f64; 2]>,
) -> Result<(), OutputError> {
    let (colour, parts) = match caption.quantity {
        Quantity::Schlieren => (schlieren as fn(f64) -> _, STEEPEST),
        _ => (viridis as fn(f64) -> _, NEARLY_ALL),
    };
    let range = range.unwrap_or_else(|| wide(raster.range(parts)));
    let range = match caption.quantity {
        Quantity::Schlieren => [range[0].min(0.0), range[1]],
        _ => range,
    };
    let labels = view.axes.map(|axis| caption.axis(&axis));
    let picture = RasterPicture {
        title: &caption.title,
        axis_labels: [&labels[0], &labels[1]],
        window: view.window,
        size: view.size,
        pixels: &raster.colours(colour, range),
        value_label: &caption.quantity(),
        value_range: range,
        colour,
    };
    written(path, picture.save(path))
}

/// Draws a curve.
pub fn draw_curve(
    path: &Path,
    caption: &Caption,
    points: Vec<[f64; 2]>,
    range: Option<[f64; 2]>,
) -> Result<(), OutputError> {
    let across = caption.axis(&[1.0, 0.0, 0.0]);
    let series = vec![Series::new("", Style::Line, points)];
    let mut panel = Panel::new(&across, &caption.quantity(), series);
    panel.window[1] = range;
    let curves = Curves::single(&caption.title, panel);
    written(path, curves.save(path))
}

/// A range about a value that is the same everywhere.
fn wide([low, high]: [f64; 2]) -> [f64; 2] {
    /// Less than this, of the values, is round-off.
    const SAME: f64 = 1e-6;
    let size = low.abs().max(high.abs());
    if high - low > SAME * size {
        return [low, high];
    }
    let margin = if size > 0.0 { 0.05 * size } else { 1.0 };
    [low - margin, high + margin]
}

fn written(path: &Path, result: Result<(), PictureError>) -> Result<(), OutputError> {
    result.map_err(|error| OutputError::new(path, std::io::Error::other(error)))
}
