//! A bar that tells the values of colours, right of a frame.

use super::axes::{Frame, MEDIUM, SMALL};
use super::canvas::{Anchor, Pen, Stroke};
use super::colour::{BLACK, Colour};
use super::font::Font;
use super::ticks::{self, Tick};
use plotters::backend::DrawingBackend;

/// Room between the frame and the bar, and up to the bar's far side.
const NEAR: f64 = 24.0;
const FAR: f64 = 46.0;

/// A bar as high as its frame.
pub(super) struct Bar<'a> {
    pub(super) frame: &'a Frame,
    /// Values at its ends.
    pub(super) range: [f64; 2],
    pub(super) label: &'a str,
    /// The colour of a share of the range.
    pub(super) colour: fn(f64) -> Colour,
}

impl Bar<'_> {
    /// What it takes beside the frame, its label included.
    pub(super) fn width(&self) -> f64 {
        FAR + self.widest() + 48.0
    }

    fn widest(&self) -> f64 {
        let ticks = self.ticks().into_iter();
        ticks
            .map(|tick| Font::plain(SMALL).width(&tick.label))
            .fold(0.0, f64::max)
    }

    fn ticks(&self) -> Vec<Tick> {
        let count = ((self.frame.bottom - self.frame.top) / 60.0).max(2.0) as usize;
        ticks::linear(self.range, count)
    }

    pub(super) fn draw<DB: DrawingBackend>(&self, pen: &Pen<'_, DB>) -> Result<(), String> {
        let (left, right) = (self.frame.right + NEAR, self.frame.right + FAR);
        let (top, bottom) = (self.frame.top, self.frame.bottom);
        let bands = 256;
        for k in 0..bands {
            let place = |share: f64| bottom - share * (bottom - top);
            let (from, to) = (
                f64::from(k) / f64::from(bands),
                f64::from(k + 1) / f64::from(bands),
            );
            let colour = (self.colour)(0.5 * (from + to));
            pen.fill_box([left, place(to)], [right, place(from)], colour)?;
        }
        let edge = Stroke {
            colour: BLACK,
            width: 1.0,
            dashed: false,
        };
        let corners = [
            [left, top],
            [right, top],
            [right, bottom],
            [left, bottom],
            [left, top],
        ];
        pen.line(&corners, edge)?;
        for tick in self.ticks() {
            let share = (tick.value - self.range[0]) / (self.range[1] - self.range[0]);
            let y = bottom - share * (bottom - top);
            pen.line(&[[right, y], [right + 5.0, y]], edge)?;
            let number = Font::plain(SMALL);
            pen.text(&tick.label, [right + 10.0, y], number, Anchor::Left)?;
        }
        let label = [right + self.widest() + 28.0, 0.5 * (top + bottom)];
        pen.text(self.label, label, Font::plain(MEDIUM), Anchor::Upwards)
    }
}
