//! Pictures with axes, bars and captions, as parts of a page.

use std::fmt::Write as _;

use super::canvas::Picture;
use aero_validation::pictures::viridis;

/// Room for the axes' numbers.
const LEFT: f64 = 62.0;
const BELOW: f64 = 40.0;
const ABOVE: f64 = 10.0;

/// Room for the bar of colours.
const RIGHT: f64 = 92.0;

/// A picture with numbers on its axes, in m.
#[derive(Clone, Debug)]
pub struct Figure<'a> {
    /// The pixels.
    pub picture: &'a Picture,
    /// What they span, to the right and upwards.
    pub window: [[f64; 2]; 2],
    /// What the axes are called.
    pub axes: [&'a str; 2],
    /// What colours mean, and the values at their ends.
    pub bar: Option<(&'a str, [f64; 2])>,
    /// Direction of the stream in the picture's plane, for an arrow.
    pub stream: Option<[f64; 2]>,
    /// What it shows.
    pub caption: &'a str,
}

impl Figure<'_> {
    /// The figure as HTML.
    pub fn html(&self) -> String {
        let [columns, rows] = self.picture.size.map(|n| n as f64);
        let (width, height) = (columns + LEFT + RIGHT, rows + ABOVE + BELOW);
        let mut svg = format!(
            "<figure><svg viewBox=\"0 0 {width} {height}\" xmlns=\"http://www.w3.org/2000/svg\" role=\"img\">\
             <image x=\"{LEFT}\" y=\"{ABOVE}\" width=\"{columns}\" height=\"{rows}\" href=\"{}\"/>\
             <rect x=\"{LEFT}\" y=\"{ABOVE}\" width=\"{columns}\" height=\"{rows}\" class=\"frame\"/>",
            self.picture.data_uri()
        );
        self.numbers(&mut svg);
        if let Some((label, range)) = self.bar {
            bar(&mut svg, [LEFT + columns + 16.0, ABOVE], rows, label, range);
        }
        if let Some(way) = self.stream {
            arrow(&mut svg, [LEFT + 14.0, ABOVE + 0.5 * rows], way);
        }
        // Writing to a string cannot fail.
        let _ = write!(
            svg,
            "</svg><figcaption>{}</figcaption></figure>",
            escaped(self.caption)
        );
        svg
    }

    fn numbers(&self, svg: &mut String) {
        let [columns, rows] = self.picture.size.map(|n| n as f64);
        let bottom = ABOVE + rows;
        for (k, size) in [columns, rows].into_iter().enumerate() {
            let [low, high] = self.window[k];
            for value in ticks(low, high) {
                let part = (value - low) / (high - low);
                let text = number(value);
                let line = if k == 0 {
                    let x = LEFT + part * size;
                    format!(
                        "<line x1=\"{x:.1}\" y1=\"{bottom}\" x2=\"{x:.1}\" y2=\"{:.1}\" class=\"frame\"/>\
                         <text x=\"{x:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{text}</text>",
                        bottom + 4.0,
                        bottom + 16.0
                    )
                } else {
                    let y = bottom - part * size;
                    format!(
                        "<line x1=\"{:.1}\" y1=\"{y:.1}\" x2=\"{LEFT}\" y2=\"{y:.1}\" class=\"frame\"/>\
                         <text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\">{text}</text>",
                        LEFT - 4.0,
                        LEFT - 7.0,
                        y + 4.0
                    )
                };
                svg.push_str(&line);
            }
        }
        let _ = write!(
            svg,
            "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{}</text>\
             <text transform=\"translate(12 {:.1}) rotate(-90)\" text-anchor=\"middle\">{}</text>",
            LEFT + 0.5 * columns,
            bottom + 33.0,
            escaped(self.axes[0]),
            ABOVE + 0.5 * rows,
            escaped(self.axes[1])
        );
    }
}

fn bar(svg: &mut String, [x, y]: [f64; 2], height: f64, label: &str, [low, high]: [f64; 2]) {
    const STEPS: usize = 48;
    let step = height / STEPS as f64;
    for k in 0..STEPS {
        let [r, g, b] = viridis(1.0 - (k as f64 + 0.5) / STEPS as f64);
        let _ = write!(
            svg,
            "<rect x=\"{x}\" y=\"{:.2}\" width=\"14\" height=\"{:.2}\" fill=\"rgb({r},{g},{b})\"/>",
            y + k as f64 * step,
            step + 0.5
        );
    }
    for value in ticks(low, high) {
        let at = y + height * (1.0 - (value - low) / (high - low));
        let _ = write!(
            svg,
            "<text x=\"{:.1}\" y=\"{:.1}\">{}</text>",
            x + 18.0,
            at + 4.0,
            number(value)
        );
    }
    let _ = write!(
        svg,
        "<text transform=\"translate({:.1} {:.1}) rotate(-90)\" text-anchor=\"middle\">{}</text>",
        x + 68.0,
        y + 0.5 * height,
        escaped(label)
    );
}

/// An arrow along the stream.
fn arrow(svg: &mut String, [x, y]: [f64; 2], [right, up]: [f64; 2]) {
    const LENGTH: f64 = 58.0;
    let size = right.hypot(up);
    if size < 1e-9 {
        return;
    }
    let (dx, dy) = (right / size, -up / size);
    let (ex, ey) = (x + LENGTH * dx, y + LENGTH * dy);
    let wing = |side: f64| {
        let (bx, by) = (ex - 11.0 * dx, ey - 11.0 * dy);
        format!("{:.1},{:.1}", bx - side * 5.0 * dy, by + side * 5.0 * dx)
    };
    let _ = write!(
        svg,
        "<line x1=\"{x:.1}\" y1=\"{y:.1}\" x2=\"{ex:.1}\" y2=\"{ey:.1}\" class=\"stream\"/>\
         <polygon points=\"{ex:.1},{ey:.1} {} {}\" class=\"head\"/>",
        wing(1.0),
        wing(-1.0)
    );
}

/// Round values within a range, about five.
fn ticks(low: f64, high: f64) -> Vec<f64> {
    let span = high - low;
    if !(span > 0.0 && span.is_finite()) {
        return Vec::new();
    }
    let rough = span / 5.0;
    let ten = 10_f64.powf(rough.log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0]
        .into_iter()
        .map(|m| m * ten)
        .find(|step| *step >= rough)
        .unwrap_or(10.0 * ten);
    let first = (low / step).ceil() as i64;
    let last = (high / step).floor() as i64;
    (first..=last).map(|k| k as f64 * step).collect()
}

/// A number of a tick.
fn number(value: f64) -> String {
    let rounded = (value * 1e9).round() / 1e9;
    format!("{}", if rounded == 0.0 { 0.0 } else { rounded })
}

/// Text as pages have it.
pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_and_within() {
        assert_eq!(ticks(-0.1, 1.05), [0.0, 0.5, 1.0]);
        assert!(ticks(1.0, 1.0).is_empty());
    }

    #[test]
    fn what_pages_would_take_for_their_own_is_escaped() {
        assert_eq!(escaped("a<b&\"c\""), "a&lt;b&amp;&quot;c&quot;");
    }
}
