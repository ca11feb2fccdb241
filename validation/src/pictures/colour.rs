//! Colours: a map for values and a palette for lines.

use plotters::style::RGBColor;

/// Red, green and blue, 0 to 255.
pub type Colour = [u8; 3];

/// Of exact and reference values.
pub const BLACK: Colour = [25, 25, 28];
pub(super) const GREY: Colour = [120, 122, 128];
pub(super) const PALE: Colour = [228, 229, 233];
pub(super) const WHITE: Colour = [255, 255, 255];
/// For lines over particles: stands out from every colour of [`viridis`].
pub(super) const RED: Colour = [214, 39, 40];

/// Colours of lines, told apart by colour-blind readers too. Source: Okabe & Ito, "Color Universal
/// Design" (2008), without black and yellow.
const PALETTE: [Colour; 6] = [
    [0, 114, 178],
    [213, 94, 0],
    [0, 158, 115],
    [204, 121, 167],
    [230, 159, 0],
    [86, 180, 233],
];

/// Colour of line number `k`; the palette repeats.
pub(super) fn palette(k: usize) -> Colour {
    PALETTE[k % PALETTE.len()]
}

pub(super) fn rgb([r, g, b]: Colour) -> RGBColor {
    RGBColor(r, g, b)
}

/// Eleven equally spaced colours of the viridis map (van der Walt & Smith 2015, public domain).
const VIRIDIS: [Colour; 11] = [
    [68, 1, 84],
    [72, 36, 117],
    [65, 68, 135],
    [53, 95, 141],
    [42, 120, 142],
    [33, 145, 140],
    [34, 168, 132],
    [68, 191, 112],
    [122, 209, 81],
    [189, 223, 38],
    [253, 231, 37],
];

/// Grey of a share from 0 (white) to 1 (dark), as schlieren show it.
pub fn schlieren(share: f64) -> Colour {
    /// What a share of one is darkened by.
    const DARK: f64 = 2.2;
    [(255.0 * (-DARK * share.max(0.0)).exp()) as u8; 3]
}

/// Colour of a share from 0 (dark blue) to 1 (yellow); shares outside take the ends' colours, and
/// what is not a number is grey.
pub fn viridis(share: f64) -> Colour {
    if share.is_nan() {
        return GREY;
    }
    let place = share.clamp(0.0, 1.0) * (VIRIDIS.len() - 1) as f64;
    let below = (place as usize).min(VIRIDIS.len() - 2);
    let rest = place - below as f64;
    std::array::from_fn(|c| {
        let (from, to) = (
            f64::from(VIRIDIS[below][c]),
            f64::from(VIRIDIS[below + 1][c]),
        );
        (from + rest * (to - from)).round() as u8
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_map_starts_dark_and_ends_bright() {
        assert_eq!(viridis(0.0), [68, 1, 84]);
        assert_eq!(viridis(1.0), [253, 231, 37]);
        assert_eq!(viridis(-3.0), viridis(0.0));
        assert_eq!(viridis(7.0), viridis(1.0));
        assert_eq!(viridis(f64::NAN), GREY);
    }

    #[test]
    fn lightness_rises_all_along_the_map() {
        let light = |k: u32| {
            let [r, g, b] = viridis(f64::from(k) / 100.0).map(f64::from);
            0.2126 * r + 0.7152 * g + 0.0722 * b
        };
        assert!((0..100).all(|k| light(k + 1) >= light(k) - 0.5));
    }
}
