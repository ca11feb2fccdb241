//! A card that names the lines and dots of a plot.

use super::axes::SMALL;
use super::canvas::{Anchor, Pen, Stroke};
use super::colour::{Colour, PALE, WHITE};
use super::font::Font;
use plotters::backend::DrawingBackend;

/// One line of a legend.
#[derive(Clone, Debug)]
pub(super) struct Entry {
    pub(super) label: String,
    pub(super) colour: Colour,
    pub(super) line: Option<bool>,
    pub(super) dots: bool,
}

/// Height of a legend's line.
const LEADING: f64 = 25.0;

/// Width and height of a legend.
pub(super) fn legend_size(entries: &[Entry]) -> [f64; 2] {
    let font = Font::plain(SMALL);
    let widest = entries
        .iter()
        .map(|e| font.width(&e.label))
        .fold(0.0, f64::max);
    [widest + 66.0, LEADING * entries.len() as f64 + 10.0]
}

/// Draws a legend on a white card with its upper left corner at `corner`.
pub(super) fn draw_legend<DB: DrawingBackend>(
    pen: &Pen<'_, DB>,
    entries: &[Entry],
    [x, y]: [f64; 2],
) -> Result<(), String> {
    let [width, height] = legend_size(entries);
    pen.fill_box([x, y], [x + width, y + height], WHITE)?;
    let (r, b) = (x + width, y + height);
    let edge = Stroke {
        colour: PALE,
        width: 1.0,
        dashed: false,
    };
    pen.line(&[[x, y], [r, y], [r, b], [x, b], [x, y]], edge)?;
    for (k, entry) in entries.iter().enumerate() {
        let middle = y + 5.0 + LEADING * (k as f64 + 0.5);
        if let Some(dashed) = entry.line {
            let stroke = Stroke {
                colour: entry.colour,
                width: 2.2,
                dashed,
            };
            pen.line(&[[x + 10.0, middle], [x + 46.0, middle]], stroke)?;
        }
        if entry.dots {
            pen.disc([x + 28.0, middle], 4.0, entry.colour)?;
        }
        pen.text(
            &entry.label,
            [x + 56.0, middle],
            Font::plain(SMALL),
            Anchor::Left,
        )?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_legend_grows_with_its_entries_and_its_longest_label() {
        let entry = |label: &str| Entry {
            label: label.to_owned(),
            colour: PALE,
            line: None,
            dots: true,
        };
        let short = legend_size(&[entry("a")]);
        let long = legend_size(&[entry("a"), entry("a longer label")]);
        assert!(long[0] > short[0] + 50.0);
        assert!(long[1] > short[1]);
    }
}
