//! Particles coloured by a value, on equal axes, with a colour bar and lines of theory over them.

use super::PictureError;
use super::axes::{Axis, Frame, range_of};
use super::canvas::save;
use super::colour::{BLACK, Colour, RED};
use super::legend::Entry;
use super::particle_page::Page;
use std::path::Path;

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

    /// Draws the picture into a `.png` or `.svg` file.
    pub fn save(&self, path: &Path) -> Result<(), PictureError> {
        for (what, found) in [
            ("value", self.value.len()),
            ("diameter", self.diameter.len()),
        ] {
            if found != self.position.len() {
                return Err(PictureError::Length {
                    title: self.title.to_owned(),
                    what,
                    found,
                    expected: self.position.len(),
                });
            }
        }
        let page = self
            .layout()
            .ok_or_else(|| PictureError::Empty(self.title.to_owned()))?;
        save(&page, path)
    }

    fn layout(&self) -> Option<Page<'_, 'a>> {
        let [across, up] = self.axes.map(|a| a.min(2));
        let in_slab = |p: &[f64; 3]| {
            self.slab
                .is_none_or(|s| (p[s.axis.min(2)] - s.centre).abs() <= s.half)
        };
        let in_window = |p: &[f64; 3]| {
            self.window.is_none_or(|[x, y]| {
                (x[0]..=x[1]).contains(&p[across]) && (y[0]..=y[1]).contains(&p[up])
            })
        };
        let mut shown: Vec<usize> = (0..self.position.len())
            .filter(|&k| self.position[k].iter().all(|v| v.is_finite()))
            .filter(|&k| in_slab(&self.position[k]) && in_window(&self.position[k]))
            .collect();
        // Small discs lie over large ones.
        shown.sort_by(|&a, &b| {
            self.diameter[b]
                .total_cmp(&self.diameter[a])
                .then(a.cmp(&b))
        });
        let span = |axis: usize| {
            let edges = shown.iter().flat_map(|&k| {
                let (middle, half) = (self.position[k][axis], 0.5 * self.diameter[k]);
                [middle - half, middle + half]
            });
            range_of(edges, false, 0.0)
        };
        let [x, y] = match self.window {
            Some(window) => window,
            None => [span(across)?, span(up)?],
        };
        let colours = match self.value_range {
            Some(range) => range,
            None => central_range(shown.iter().map(|&k| self.value[k]).collect())?,
        };
        let axis = |label: &str, range| Axis {
            label: label.to_owned(),
            range,
            log: false,
        };
        let (x, y) = (axis(self.axis_labels[0], x), axis(self.axis_labels[1], y));
        // Equal axes, as large as fits 980 x 760 points; a slender tube is widened to be seen.
        let [dx, dy] = [x.range[1] - x.range[0], y.range[1] - y.range[0]];
        let scale = (980.0 / dx).min(760.0 / dy);
        let (width, height) = ((dx * scale).max(160.0), (dy * scale).max(120.0));
        let left = Frame::margin_left(&y, height);
        let top = if self.legend().is_empty() {
            56.0
        } else {
            56.0 + 32.0
        };
        Some(Page {
            picture: self,
            shown,
            colours,
            scale,
            frame: Frame {
                x,
                y,
                left,
                right: left + width,
                top,
                bottom: top + height,
            },
        })
    }

    pub(super) fn legend(&self) -> Vec<Entry> {
        self.overlays
            .iter()
            .filter(|o| !o.label.is_empty())
            .map(|o| Entry {
                label: o.label.clone(),
                colour: o.colour,
                line: Some(o.dashed),
                dots: false,
            })
            .collect()
    }
}

/// Values that hold the middle 99 per cent, so that one wild particle does not take all colours.
fn central_range(mut values: Vec<f64>) -> Option<[f64; 2]> {
    values.retain(|v| v.is_finite());
    values.sort_by(f64::total_cmp);
    let last = values.len().checked_sub(1)?;
    let at = |share: f64| values[(share * last as f64).round() as usize];
    range_of([at(0.005), at(0.995)].into_iter(), false, 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sheet() -> (Vec<[f64; 3]>, Vec<f64>, Vec<f64>) {
        let position: Vec<[f64; 3]> = (0..200)
            .map(|k| [f64::from(k % 20) * 0.1, f64::from(k / 20) * 0.1, 0.0])
            .collect();
        let value = position.iter().map(|p| p[0] + p[1]).collect();
        let diameter = vec![0.1; position.len()];
        (position, value, diameter)
    }

    #[test]
    fn a_picture_is_written_and_keeps_equal_axes() {
        let (position, value, diameter) = sheet();
        let mut picture = ParticlePicture::new("test", &position, &diameter, &value, "density");
        picture
            .overlays
            .push(Overlay::theory("shock", vec![[0.0, 0.0], [2.0, 1.0]]));
        let page = picture.layout().unwrap();
        let wide = (page.frame.right - page.frame.left) / 2.0;
        let high = page.frame.bottom - page.frame.top;
        assert!((wide / high - 1.0).abs() < 1e-9);
        let folder = tempfile::tempdir().unwrap();
        picture.save(&folder.path().join("p.png")).unwrap();
    }

    #[test]
    fn a_slab_and_a_window_leave_only_their_particles() {
        let (mut position, value, diameter) = sheet();
        for (k, p) in position.iter_mut().enumerate() {
            p[2] = (k % 2) as f64;
        }
        let mut picture = ParticlePicture::new("test", &position, &diameter, &value, "density");
        picture.slab = Some(Slab {
            axis: 2,
            centre: 0.0,
            half: 0.5,
        });
        picture.window = Some([[0.0, 0.95], [0.0, 2.0]]);
        assert_eq!(picture.layout().unwrap().shown.len(), 50);
    }

    #[test]
    fn nothing_to_draw_and_unequal_arrays_are_refused() {
        let (position, value, diameter) = sheet();
        let path = Path::new("never.png");
        let empty = ParticlePicture::new("test", &[], &[], &[], "density");
        assert!(matches!(empty.save(path), Err(PictureError::Empty(_))));
        let short = ParticlePicture::new("test", &position, &diameter, &value[1..], "density");
        let error = short.save(path).unwrap_err();
        assert!(error.to_string().contains("199 entries for 200"), "{error}");
    }
}
