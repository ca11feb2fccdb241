//! A spacing for a body where none is given.

use aero_geometry::Bounds;

use crate::check::shortened;

/// Spacings across the thinnest extent of the body: enough to tell its form, few enough to look at
/// at once.
const ACROSS: f64 = 24.0;

/// Most ghosts of a spacing that nobody asked for.
const MOST: f64 = 4e5;

/// Thickness, in spacings, from which on a part is kept by one row of ghosts.
const ONE_ROW: f64 = 0.3;

/// And by two rows.
const TWO_ROWS: f64 = 1.5;

/// A spacing for a body that fills `bounds`, with parts as thin as `thin`, and why that one.
pub(super) fn pick(bounds: &Bounds<3>, thin: Option<f64>, layers: usize) -> (f64, String) {
    let (spacing, reason) = of_extent(bounds, layers);
    let Some(thin) = thin.filter(|thin| *thin < TWO_ROWS * spacing) else {
        return (spacing, reason);
    };
    let ghosts = |spacing: f64| box_area(bounds) * layers as f64 / (spacing * spacing);
    let one_row = two_digits(0.95 * thin / ONE_ROW);
    if one_row < spacing && ghosts(one_row) <= MOST {
        let reason = format!("picked: the thinnest part, {thin:.2e}, as one row of ghosts");
        return (one_row, reason);
    }
    if one_row < spacing {
        let reason = format!(
            "{reason}; the thinnest part, {thin:.2e}, needs {one_row:.1e} or less, about {:.0e} ghosts",
            ghosts(one_row)
        );
        return (spacing, reason);
    }
    let two_rows = two_digits(0.95 * thin / TWO_ROWS);
    let reason = format!(
        "{reason}; the thinnest part, {thin:.2e}, is one row of ghosts, two at {two_rows:.1e} or less, about {:.0e} ghosts",
        ghosts(two_rows)
    );
    (spacing, reason)
}

/// Surface of the box around the body.
fn box_area(bounds: &Bounds<3>) -> f64 {
    let size = bounds.size();
    let [x, y, z] = [size[0], size[1], size[2]];
    2.0 * (x * y + y * z + z * x)
}

/// A spacing by the body's extent alone.
fn of_extent(bounds: &Bounds<3>, layers: usize) -> (f64, String) {
    let size = bounds.size();
    let thinnest = size.min();
    let fine = thinnest / ACROSS;
    let affordable = (box_area(bounds) * layers as f64 / MOST).sqrt();
    if fine >= affordable {
        let spacing = two_digits(fine);
        let reason = format!(
            "picked: the thinnest extent, {}, over {ACROSS}",
            shortened(thinnest)
        );
        (spacing, reason)
    } else {
        let spacing = two_digits(affordable);
        let reason = format!("picked: the finest that keeps the ghosts below about {MOST:.0e}");
        (spacing, reason)
    }
}

/// Rounded to two significant digits, so that it can be typed again.
fn two_digits(value: f64) -> f64 {
    format!("{value:.1e}").parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use aero_geometry::Vector;

    #[test]
    fn a_cube_gets_so_many_spacings_across() {
        let cube = Bounds::new(Vector::zeros(), Vector::<3>::repeat(0.48));
        let (spacing, reason) = pick(&cube, None, 5);
        assert_eq!(spacing, 0.02);
        assert!(reason.contains("thinnest"));
    }

    #[test]
    fn a_thin_plate_is_not_packed_with_millions() {
        let plate = Bounds::new(Vector::zeros(), Vector::<3>::new(1.0, 1.0, 0.001));
        let (spacing, reason) = pick(&plate, None, 5);
        assert!(spacing > 0.004 && reason.contains("ghosts below"));
    }

    #[test]
    fn a_thin_part_is_kept_where_that_is_affordable_or_the_price_is_told() {
        let cube = Bounds::new(Vector::zeros(), Vector::<3>::repeat(0.48));
        let (spacing, reason) = pick(&cube, Some(0.004), 5);
        assert!(spacing < 0.0134 && reason.contains("thinnest part"));
        let (spacing, reason) = pick(&cube, Some(0.0001), 5);
        assert!(
            spacing == 0.02 && reason.contains("needs 3.2e-4"),
            "{reason}"
        );
        let (spacing, reason) = pick(&cube, Some(0.01), 5);
        assert!(
            spacing == 0.02 && reason.contains("two at 6.3e-3"),
            "{reason}"
        );
    }
}
