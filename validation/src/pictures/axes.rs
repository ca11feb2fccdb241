//! A frame with marked axes that turns values into places on the paper.

use super::canvas::{Anchor, Pen, Stroke};
use super::colour::{BLACK, PALE};
use super::font::Font;
use super::ticks::{self, Tick};
use plotters::backend::DrawingBackend;

/// Size of the numbers at the marks.
pub(super) const SMALL: f64 = 17.0;
/// Size of axis labels and legends.
pub(super) const MEDIUM: f64 = 19.0;
/// Font of titles.
pub(super) const HEADING: Font = Font {
    bold: true,
    ..Font::plain(22.0)
};

/// One axis: its label with the unit, its ends, and whether it is logarithmic.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Axis {
    pub(super) label: String,
    pub(super) range: [f64; 2],
    pub(super) log: bool,
}

impl Axis {
    /// Share of the axis at which `value` lies; 0 and 1 are its ends.
    pub(super) fn share(&self, value: f64) -> f64 {
        let [low, high] = self.range;
        if self.log {
            (value / low).ln() / (high / low).ln()
        } else {
            (value - low) / (high - low)
        }
    }

    fn ticks(&self, length: f64, apart: f64) -> Vec<Tick> {
        if self.log {
            ticks::logarithmic(self.range)
        } else {
            ticks::linear(self.range, (length / apart).max(2.0) as usize)
        }
    }
}

/// Ends of an axis around `values` with a margin of `margin` of the span; NaN and infinities are
/// passed over. None if nothing is left. On a log axis only positive values count.
pub(super) fn range_of(
    values: impl Iterator<Item = f64>,
    log: bool,
    margin: f64,
) -> Option<[f64; 2]> {
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for value in values.filter(|v| v.is_finite() && (!log || *v > 0.0)) {
        low = low.min(value);
        high = high.max(value);
    }
    if low > high {
        return None;
    }
    if log {
        let stretch = (high / low).max(1.5).powf(margin);
        return Some([low / stretch, high * stretch]);
    }
    let span = high - low;
    let pad = if span > 1e-12 * high.abs().max(low.abs()) {
        margin * span
    } else {
        0.05 * high.abs().max(1.0)
    };
    Some([low - pad, high + pad])
}

/// A frame on the paper between `left`..`right` and `top`..`bottom` (points, downwards).
#[derive(Clone, Debug)]
pub(super) struct Frame {
    pub(super) x: Axis,
    pub(super) y: Axis,
    pub(super) left: f64,
    pub(super) right: f64,
    pub(super) top: f64,
    pub(super) bottom: f64,
}

impl Frame {
    /// Place of a point of the plot.
    pub(super) fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [
            self.left + self.x.share(x) * (self.right - self.left),
            self.bottom - self.y.share(y) * (self.bottom - self.top),
        ]
    }

    /// True for places inside the frame.
    pub(super) fn holds(&self, [x, y]: [f64; 2]) -> bool {
        (self.left..=self.right).contains(&x) && (self.top..=self.bottom).contains(&y)
    }

    /// Grid lines, to lie under the data.
    pub(super) fn draw_grid<DB: DrawingBackend>(&self, pen: &Pen<'_, DB>) -> Result<(), String> {
        let stroke = |tick: &Tick| Stroke {
            colour: if tick.label.is_empty() {
                [242, 242, 245]
            } else {
                PALE
            },
            width: 1.0,
            dashed: false,
        };
        for tick in self.x.ticks(self.right - self.left, 110.0) {
            let [x, _] = self.place([tick.value, self.y.range[0]]);
            pen.line(&[[x, self.top], [x, self.bottom]], stroke(&tick))?;
        }
        for tick in self.y.ticks(self.bottom - self.top, 70.0) {
            let [_, y] = self.place([self.x.range[0], tick.value]);
            pen.line(&[[self.left, y], [self.right, y]], stroke(&tick))?;
        }
        Ok(())
    }

    /// The frame with marks, numbers and labels, to lie over the data.
    pub(super) fn draw_axes<DB: DrawingBackend>(&self, pen: &Pen<'_, DB>) -> Result<(), String> {
        let stroke = Stroke {
            colour: BLACK,
            width: 1.2,
            dashed: false,
        };
        let number = Font::plain(SMALL);
        let mut widest: f64 = 0.0;
        for tick in self.x.ticks(self.right - self.left, 110.0) {
            let [x, _] = self.place([tick.value, self.y.range[0]]);
            let length = if tick.label.is_empty() { 3.0 } else { 6.0 };
            pen.line(&[[x, self.bottom], [x, self.bottom + length]], stroke)?;
            pen.text(&tick.label, [x, self.bottom + 18.0], number, Anchor::Centre)?;
        }
        for tick in self.y.ticks(self.bottom - self.top, 70.0) {
            let [_, y] = self.place([self.x.range[0], tick.value]);
            let length = if tick.label.is_empty() { 3.0 } else { 6.0 };
            pen.line(&[[self.left - length, y], [self.left, y]], stroke)?;
            pen.text(&tick.label, [self.left - 10.0, y], number, Anchor::Right)?;
            widest = widest.max(number.width(&tick.label));
        }
        let (l, r, t, b) = (self.left, self.right, self.top, self.bottom);
        pen.line(&[[l, t], [r, t], [r, b], [l, b], [l, t]], stroke)?;
        let font = Font::plain(MEDIUM);
        let below = [0.5 * (l + r), b + 43.0];
        pen.text(&self.x.label, below, font, Anchor::Centre)?;
        let beside = [l - widest - 28.0, 0.5 * (t + b)];
        pen.text(&self.y.label, beside, font, Anchor::Upwards)
    }

    /// Space that the numbers and the label of the vertical axis need left of the frame.
    pub(super) fn margin_left(y: &Axis, height: f64) -> f64 {
        let number = Font::plain(SMALL);
        let widest = y
            .ticks(height, 70.0)
            .iter()
            .map(|t| number.width(&t.label))
            .fold(0.0, f64::max);
        widest + 48.0
    }

    /// A line through points of the plot, cut at the frame; points that are not numbers break it.
    pub(super) fn draw_line<DB: DrawingBackend>(
        &self,
        pen: &Pen<'_, DB>,
        points: &[[f64; 2]],
        stroke: Stroke,
    ) -> Result<(), String> {
        let mut run: Vec<[f64; 2]> = Vec::new();
        for pair in points.windows(2) {
            let (a, b) = (self.place(pair[0]), self.place(pair[1]));
            let Some([from, to]) = self.cut(a, b) else {
                pen.line(&std::mem::take(&mut run), stroke)?;
                continue;
            };
            if run.last() != Some(&from) {
                pen.line(&std::mem::take(&mut run), stroke)?;
                run.push(from);
            }
            run.push(to);
        }
        pen.line(&run, stroke)
    }

    /// The part of a straight line inside the frame [Liang & Barsky 1984].
    fn cut(&self, a: [f64; 2], b: [f64; 2]) -> Option<[[f64; 2]; 2]> {
        if !a.iter().chain(&b).all(|v| v.is_finite()) {
            return None;
        }
        let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
        for (k, low, high) in [(0, self.left, self.right), (1, self.top, self.bottom)] {
            let step = b[k] - a[k];
            if step == 0.0 {
                if a[k] < low || a[k] > high {
                    return None;
                }
                continue;
            }
            let (first, last) = ((low - a[k]) / step, (high - a[k]) / step);
            enter = enter.max(first.min(last));
            leave = leave.min(first.max(last));
        }
        if enter > leave {
            return None;
        }
        let at = |f: f64| {
            if f == 0.0 {
                a
            } else if f == 1.0 {
                b
            } else {
                [a[0] + f * (b[0] - a[0]), a[1] + f * (b[1] - a[1])]
            }
        };
        Some([at(enter), at(leave)])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frame(log: bool) -> Frame {
        let axis = |range| Axis {
            label: String::new(),
            range,
            log,
        };
        Frame {
            x: axis([1.0, 100.0]),
            y: axis([1.0, 100.0]),
            left: 0.0,
            right: 10.0,
            top: 0.0,
            bottom: 10.0,
        }
    }

    #[test]
    fn values_go_to_their_places_on_linear_and_log_axes() {
        assert_eq!(frame(false).place([1.0, 100.0]), [0.0, 0.0]);
        assert_eq!(frame(true).place([10.0, 10.0]), [5.0, 5.0]);
    }

    #[test]
    fn lines_are_cut_at_the_frame() {
        let frame = frame(false);
        let cut = frame.cut([-5.0, 5.0], [15.0, 5.0]).unwrap();
        assert_eq!(cut, [[0.0, 5.0], [10.0, 5.0]]);
        assert_eq!(frame.cut([-5.0, 0.0], [0.0, -5.0]), None);
        assert_eq!(frame.cut([1.0, 1.0], [f64::NAN, 1.0]), None);
    }

    #[test]
    fn ranges_pass_over_what_has_no_place() {
        let values = [f64::NAN, 1.0, 3.0, f64::INFINITY];
        assert_eq!(range_of(values.into_iter(), false, 0.0), Some([1.0, 3.0]));
        assert_eq!(range_of([-1.0, 0.0].into_iter(), true, 0.1), None);
        let [low, high] = range_of([2.0, 2.0].into_iter(), false, 0.1).unwrap();
        assert!(low < 2.0 && high > 2.0);
    }
}
