//! A plane of coloured pixels with axes and a bar.

use super::PictureError;
use super::axes::{Axis, Frame, HEADING};
use super::bar::Bar;
use super::canvas::{Anchor, Drawing, Pen, save};
use super::colour::Colour;
use plotters::backend::DrawingBackend;
use std::path::Path;

/// Pixels of a window, and what they mean.
#[derive(Clone, Debug)]
pub struct RasterPicture<'a> {
    /// Heading.
    pub title: &'a str,
    /// Labels of the axes to the right and upwards, with their units.
    pub axis_labels: [&'a str; 2],
    /// From and to along both.
    pub window: [[f64; 2]; 2],
    /// Columns and rows.
    pub size: [usize; 2],
    /// Colours, row by row from the top.
    pub pixels: &'a [Colour],
    /// What colours mean, with its unit.
    pub value_label: &'a str,
    /// Values at the ends of the bar.
    pub value_range: [f64; 2],
    /// The colour of a share of that range.
    pub colour: fn(f64) -> Colour,
}

impl RasterPicture<'_> {
    /// Draws the picture into a `.png` or `.svg` file.
    pub fn save(&self, path: &Path) -> Result<(), PictureError> {
        if self.pixels.is_empty() || self.pixels.len() != self.size[0] * self.size[1] {
            return Err(PictureError::Empty(self.title.to_owned()));
        }
        save(&self.layout(), path)
    }

    fn layout(&self) -> Page<'_, '_> {
        let axis = |k: usize| Axis {
            label: self.axis_labels[k].to_owned(),
            range: self.window[k],
            log: false,
        };
        let [width, height] = self.size.map(|n| n as f64);
        let left = Frame::margin_left(&axis(1), height);
        Page {
            picture: self,
            frame: Frame {
                x: axis(0),
                y: axis(1),
                left,
                right: left + width,
                top: 56.0,
                bottom: 56.0 + height,
            },
        }
    }
}

/// A picture laid out.
struct Page<'p, 'a> {
    picture: &'p RasterPicture<'a>,
    frame: Frame,
}

impl Page<'_, '_> {
    fn bar(&self) -> Bar<'_> {
        Bar {
            frame: &self.frame,
            range: self.picture.value_range,
            label: self.picture.value_label,
            colour: self.picture.colour,
        }
    }
}

impl Drawing for Page<'_, '_> {
    fn size(&self) -> [f64; 2] {
        let title = HEADING.width(self.picture.title) + 2.0 * self.frame.left;
        let width = self.frame.right + self.bar().width();
        [width.max(title), self.frame.bottom + 64.0]
    }

    fn draw<DB: DrawingBackend>(&self, pen: &Pen<'_, DB>) -> Result<(), String> {
        let corner = [self.frame.left, self.frame.top];
        pen.pixels(corner, self.picture.size[0], self.picture.pixels)?;
        let title = [self.frame.left, 28.0];
        pen.text(self.picture.title, title, HEADING, Anchor::Left)?;
        self.frame.draw_axes(pen)?;
        self.bar().draw(pen)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pictures::viridis;

    #[test]
    fn pixels_that_do_not_fill_the_picture_are_refused() {
        let mut picture = RasterPicture {
            title: "test",
            axis_labels: ["x", "y"],
            window: [[0.0, 2.0], [0.0, 1.0]],
            size: [20, 10],
            pixels: &[[1, 2, 3]; 200],
            value_label: "mach",
            value_range: [0.0, 1.0],
            colour: viridis,
        };
        let folder = tempfile::tempdir().unwrap();
        picture.save(&folder.path().join("p.png")).unwrap();
        picture.size = [20, 11];
        assert!(picture.save(&folder.path().join("q.png")).is_err());
    }
}
