//! Draws curves: grid, lines, dots, axes, and a legend where it hides least.

use super::axes::{Frame, HEADING};
use super::canvas::{Anchor, Drawing, Pen, Stroke};
use super::colour::{Colour, palette};
use super::curves::{Curves, LONGEST_LEGEND, Panel, Series, Style, TOP};
use super::legend::{Entry, draw_legend, legend_size};
use plotters::backend::DrawingBackend;

/// Colours of a panel's series: given ones, else the palette's in turn.
pub(super) fn colours(series: &[Series]) -> Vec<Colour> {
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
pub(super) struct Page<'a> {
    pub(super) picture: &'a Curves,
    pub(super) frames: Vec<Frame>,
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
pub(super) fn entries(series: &[Series]) -> Vec<Entry> {
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
pub(super) fn free_corner(panel: &Panel, frame: &Frame, entries: &[Entry]) -> [f64; 2] {
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
