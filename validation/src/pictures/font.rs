//! The built-in font: `DejaVu` Sans, part of the program, under the Bitstream Vera licence.

use super::colour::{BLACK, Colour};
use plotters::style::{FontDesc, FontFamily, FontStyle, register_font};
use std::sync::OnceLock;

/// Fine pixels per point.
pub(super) const FINE: u32 = 3;

/// Name under which the built-in font is known; as a generic
/// family it also tells viewers of an SVG what to use.
const FAMILY: FontFamily<'static> = FontFamily::SansSerif;

/// Makes the built-in font known to the drawing library, once.
pub(super) fn load_font() -> Result<(), String> {
    static LOADED: OnceLock<bool> = OnceLock::new();
    let name = FAMILY.as_str();
    let loaded = *LOADED.get_or_init(|| {
        register_font(name, FontStyle::Normal, dejavu::sans::regular()).is_ok()
            && register_font(name, FontStyle::Bold, dejavu::sans::bold()).is_ok()
    });
    if loaded {
        Ok(())
    } else {
        Err("the built-in font does not load".to_owned())
    }
}

/// Size, weight and colour of a text.
#[derive(Clone, Copy, Debug)]
pub(super) struct Font {
    pub(super) size: f64,
    pub(super) bold: bool,
    pub(super) colour: Colour,
}

impl Font {
    /// Black text of ordinary weight.
    pub(super) const fn plain(size: f64) -> Self {
        Self {
            size,
            bold: false,
            colour: BLACK,
        }
    }

    /// Width of `text` in points.
    pub(super) fn width(self, text: &str) -> f64 {
        // Without the font there is no picture either, so the estimate is never used.
        let estimate = 0.6 * self.size * text.chars().count() as f64;
        if load_font().is_err() {
            return estimate;
        }
        self.description()
            .box_size(text)
            .map_or(estimate, |(width, _)| f64::from(width) / f64::from(FINE))
    }

    /// The drawing library's name for it, at the fine size.
    pub(super) fn description(self) -> FontDesc<'static> {
        let style = if self.bold {
            FontStyle::Bold
        } else {
            FontStyle::Normal
        };
        FontDesc::new(FAMILY, self.size * f64::from(FINE), style)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn longer_and_larger_and_bolder_text_is_wider() {
        let plain = Font::plain(20.0);
        assert!(plain.width("shock angle") > plain.width("shock"));
        assert!(Font::plain(30.0).width("shock") > plain.width("shock"));
        let bold = Font {
            bold: true,
            ..plain
        };
        assert!(bold.width("shock") > plain.width("shock"));
    }
}
