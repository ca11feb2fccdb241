//! Curves in one or more panels: profiles of particles against an exact curve, and histories.

use super::PictureError;
use super::axes::{Axis, Frame, range_of};
use super::canvas::save;
use super::colour::{BLACK, Colour};
use super::curve_page::{Page, entries};
use super::legend::legend_size;
use std::path::Path;

/// How a series is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    /// A solid line.
    Line,
    /// A dashed line.
    Dashed,
    /// A dot per point.
    Dots,
}

/// Points under one name.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// Name for the legend; empty for none.
    pub label: String,
    /// Points in drawing order; points that are not numbers break a line.
    pub points: Vec<[f64; 2]>,
    /// Look.
    pub style: Style,
    /// Colour; none takes the next of the palette.
    pub colour: Option<Colour>,
}

impl Series {
    /// A series in the next colour of the palette.
    pub fn new(label: &str, style: Style, points: Vec<[f64; 2]>) -> Self {
        Self {
            label: label.to_owned(),
            points,
            style,
            colour: None,
        }
    }

    /// An exact solution: a solid black line through `samples` values of `exact` over `range`.
    pub fn exact(range: [f64; 2], samples: usize, exact: impl Fn(f64) -> f64) -> Self {
        let last = samples.saturating_sub(1).max(1) as f64;
        let points = (0..samples)
            .map(|k| range[0] + k as f64 / last * (range[1] - range[0]))
            .map(|x| [x, exact(x)])
            .collect();
        Self {
            label: "exact".to_owned(),
            points,
            style: Style::Line,
            colour: Some(BLACK),
        }
    }

    /// Particles at `coordinates` with `values`, as dots.
    pub fn particles(label: &str, coordinates: &[f64], values: &[f64]) -> Self {
        let points = coordinates
            .iter()
            .zip(values)
            .map(|(x, v)| [*x, *v])
            .collect();
        Self::new(label, Style::Dots, points)
    }
}

/// One plot.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// Label of the horizontal axis, with its unit.
    pub x_label: String,
    /// Label of the vertical axis, with its unit.
    pub y_label: String,
    /// Ends of the axes; by default all points with a margin.
    pub window: [Option<[f64; 2]>; 2],
    /// Logarithmic axes.
    pub log: [bool; 2],
    /// What is drawn, first at the bottom.
    pub series: Vec<Series>,
}

impl Panel {
    /// A panel on linear axes that shows all points.
    pub fn new(x_label: &str, y_label: &str, series: Vec<Series>) -> Self {
        Self {
            x_label: x_label.to_owned(),
            y_label: y_label.to_owned(),
            window: [None; 2],
            log: [false; 2],
            series,
        }
    }
}

/// The picture: panels in rows of `columns`.
#[derive(Clone, Debug, PartialEq)]
pub struct Curves {
    /// Heading.
    pub title: String,
    /// Plots, row by row.
    pub panels: Vec<Panel>,
    /// Panels in a row.
    pub columns: usize,
}

/// Width and height of a panel with its labels, for a picture of one column.
const PANEL: [f64; 2] = [960.0, 520.0];
/// The same with several columns.
const NARROW: [f64; 2] = [640.0, 450.0];
/// Legends of more lines stand beside the panel.
pub(super) const LONGEST_LEGEND: usize = 5;
/// Space above the panels for the title.
pub(super) const TOP: f64 = 56.0;

impl Curves {
    /// A picture of one panel.
    pub fn single(title: &str, panel: Panel) -> Self {
        Self {
            title: title.to_owned(),
            panels: vec![panel],
            columns: 1,
        }
    }

    /// Draws the picture into a `.png` or `.svg` file.
    pub fn save(&self, path: &Path) -> Result<(), PictureError> {
        let frames: Option<Vec<Frame>> = (0..self.panels.len()).map(|k| self.frame(k)).collect();
        match frames {
            Some(frames) if !frames.is_empty() => save(
                &Page {
                    picture: self,
                    frames,
                },
                path,
            ),
            _ => Err(PictureError::Empty(self.title.clone())),
        }
    }

    pub(super) fn panel_size(&self) -> [f64; 2] {
        let [width, height] = if self.columns > 1 { NARROW } else { PANEL };
        [width + self.beside(), height]
    }

    /// Width kept free on the right of each panel for legends that are too long to lie on one.
    fn beside(&self) -> f64 {
        let legends = self.panels.iter().map(|panel| entries(&panel.series));
        legends
            .filter(|legend| legend.len() > LONGEST_LEGEND)
            .map(|legend| legend_size(&legend)[0])
            .fold(0.0, f64::max)
    }

    fn frame(&self, k: usize) -> Option<Frame> {
        let panel = &self.panels[k];
        let [width, height] = self.panel_size();
        let points = || panel.series.iter().flat_map(|s| &s.points);
        let axis = |a: usize, label: &str, margin: f64| {
            let found = range_of(points().map(|p| p[a]), panel.log[a], margin);
            panel.window[a].or(found).map(|range| Axis {
                label: label.to_owned(),
                range,
                log: panel.log[a],
            })
        };
        let (x, y) = (
            axis(0, &panel.x_label, 0.02)?,
            axis(1, &panel.y_label, 0.07)?,
        );
        let columns = self.columns.max(1);
        let corner = [
            width * (k % columns) as f64,
            TOP + height * (k / columns) as f64,
        ];
        let left = corner[0] + Frame::margin_left(&y, height - 80.0) + 8.0;
        Some(Frame {
            x,
            y,
            left,
            right: corner[0] + width - 24.0 - self.beside(),
            top: corner[1] + 8.0,
            bottom: corner[1] + height - 72.0,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pictures::colour::palette;
    use crate::pictures::curve_page::{colours, free_corner};
    use crate::pictures::legend::Entry;

    fn panel() -> Panel {
        let x: Vec<f64> = (0..50).map(|k| f64::from(k) / 49.0).collect();
        let v: Vec<f64> = x.iter().map(|x| x * x + 0.01).collect();
        Panel::new(
            "x",
            "density",
            vec![
                Series::exact([0.0, 1.0], 200, |x| x * x),
                Series::particles("SPH", &x, &v),
            ],
        )
    }

    #[test]
    fn one_and_several_panels_are_written() {
        let folder = tempfile::tempdir().unwrap();
        Curves::single("one", panel())
            .save(&folder.path().join("one.png"))
            .unwrap();
        let several = Curves {
            title: "three".to_owned(),
            panels: vec![panel(), panel(), panel()],
            columns: 2,
        };
        let path = folder.path().join("three.svg");
        several.save(&path).unwrap();
        assert!(std::fs::read_to_string(path).unwrap().contains("density"));
    }

    #[test]
    fn the_legend_keeps_clear_of_the_curve() {
        let panel = panel();
        let frame = Curves::single("one", panel.clone()).frame(0).unwrap();
        let entries = [Entry {
            label: "exact".to_owned(),
            colour: BLACK,
            line: Some(false),
            dots: false,
        }];
        let corner = free_corner(&panel, &frame, &entries);
        // The parabola leaves the upper left free.
        assert!(corner[0] < 0.5 * (frame.left + frame.right));
        assert!(corner[1] < 0.5 * (frame.top + frame.bottom));
    }

    #[test]
    fn a_picture_of_no_points_is_refused() {
        let empty = Curves::single("none", Panel::new("x", "y", Vec::new()));
        assert!(matches!(
            empty.save(Path::new("n.png")),
            Err(PictureError::Empty(_))
        ));
    }

    #[test]
    fn given_colours_do_not_use_up_the_palette() {
        let found = colours(&panel().series);
        assert_eq!(found, [BLACK, palette(0)]);
    }
}
