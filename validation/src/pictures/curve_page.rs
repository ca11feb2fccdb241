//! Lays curves out and draws them: grid, lines, dots, axes, and a legend where it hides least.

use super::PictureError;
use super::axes::{Axis, Frame, HEADING, range_of};
use super::canvas::{Anchor, Drawing, Pen, Stroke, save};
use super::colour::{Colour, palette};
use super::curves::{Curves, Panel, Series, Style};
use super::legend::{Entry, draw_legend, legend_size};
use plotters::backend::DrawingBackend;
use std::path::Path;

/// Width and height of a panel with its labels, for a picture of one column.
const PANEL: [f64; 2] = [960.0, 520.0];
/// The same with several columns.
const NARROW: [f64; 2] = [640.0, 450.0];
/// Legends of more lines stand beside the panel.
const LONGEST_LEGEND: usize = 5;
/// Space above the panels for the title.
const TOP: f64 = 56.0;

impl Curves {
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

    fn panel_size(&self) -> [f64; 2] {
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

/// Colours of a panel's series: given ones, else the palette's in turn.
fn colours(series: &[Series]) -> Vec<Colour> {
    let mut next = 0;
    series
        .iter()
        .map(|s| {
            s.colour.unwrap_or_else(|| {
                next += 1;
                palette(next - 1)
            })
        })
        .collect()
}

/// A picture of curves laid out.
struct Page<'a> {
    picture: &'a Curves,
    frames: Vec<Frame>,
}

impl Drawing for Page<'_> {
    fn size(&self) -> [f64; 2] {
        let [width, height] = self.picture.panel_size();
        let columns = self.picture.columns.max(1).min(self.frames.len());
        let rows = self.frames.len().div_ceil(self.picture.columns.max(1));
        [width * columns as f64, TOP + height * rows as f64]
    }

    fn draw<DB: DrawingBackend>(&self, pen: &Pen<'_, DB>) -> Result<(), String> {
        let left = self.frames[0].left;
        pen.text(&self.picture.title, [left, 28.0], HEADING, Anchor::Left)?;
        for (panel, frame) in self.picture.panels.iter().zip(&self.frames) {
            draw_panel(pen, panel, frame)?;
        }
        Ok(())
    }
}

fn draw_panel<DB: DrawingBackend>(
    pen: &Pen<'_, DB>,
    panel: &Panel,
    frame: &Frame,
) -> Result<(), String> {
    frame.draw_grid(pen)?;
    let colours = colours(&panel.series);
    for (series, colour) in panel.series.iter().zip(&colours) {
        if series.style == Style::Dots {
            // Many particles are drawn small.
            let radius = if series.points.len() > 400 { 2.0 } else { 3.2 };
            for place in series.points.iter().map(|p| frame.place(*p)) {
                if frame.holds(place) {
                    pen.disc(place, radius, *colour)?;
                }
            }
        } else {
            let stroke = Stroke {
                colour: *colour,
                width: 2.0,
                dashed: series.style == Style::Dashed,
            };
            frame.draw_line(pen, &series.points, stroke)?;
        }
    }
    frame.draw_axes(pen)?;
    let entries = entries(&panel.series);
    if entries.is_empty() {
        return Ok(());
    }
    let corner = if entries.len() > LONGEST_LEGEND {
        [frame.right + 12.0, frame.top]
    } else {
        free_corner(panel, frame, &entries)
    };
    draw_legend(pen, &entries, corner)
}

/// Lines of the legend of `series`.
fn entries(series: &[Series]) -> Vec<Entry> {
    let named = series.iter().zip(colours(series));
    named
        .filter(|(s, _)| !s.label.is_empty())
        .map(|(s, colour)| Entry {
            label: s.label.clone(),
            colour,
            line: (s.style != Style::Dots).then_some(s.style == Style::Dashed),
            dots: s.style == Style::Dots,
        })
        .collect()
}

/// The corner of the frame where a legend hides the fewest points.
fn free_corner(panel: &Panel, frame: &Frame, entries: &[Entry]) -> [f64; 2] {
    let [width, height] = legend_size(entries);
    let gap = 12.0;
    let corners = [
        [frame.right - width - gap, frame.top + gap],
        [frame.left + gap, frame.top + gap],
        [frame.left + gap, frame.bottom - height - gap],
        [frame.right - width - gap, frame.bottom - height - gap],
    ];
    let hidden = |corner: &[f64; 2]| {
        let points = panel.series.iter().flat_map(|s| &s.points);
        points
            .map(|p| frame.place(*p))
            .filter(|p| {
                (corner[0]..=corner[0] + width).contains(&p[0])
                    && (corner[1]..=corner[1] + height).contains(&p[1])
            })
            .count()
    };
    corners.into_iter().min_by_key(hidden).unwrap_or(corners[0])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pictures::colour::BLACK;

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
