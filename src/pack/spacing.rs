//! A spacing for a body where none is given.

use aero_geometry::Bounds;

/// Spacings across the thinnest extent of the body: enough to tell its form, few enough to look at
/// at once.
const ACROSS: f64 = 24.0;

/// Most ghosts of a spacing that nobody asked for.
const MOST: f64 = 4e5;

/// A spacing for a body that fills `bounds`, and why that one.
pub(super) fn pick(bounds: &Bounds<3>, layers: usize) -> (f64, String) {
    let size = bounds.size();
    let thinnest = size.min();
    let fine = thinnest / ACROSS;
    let [x, y, z] = [size[0], size[1], size[2]];
    let box_area = 2.0 * (x * y + y * z + z * x);
    let affordable = (box_area * layers as f64 / MOST).sqrt();
    if fine >= affordable {
        let spacing = two_digits(fine);
        let reason = format!("picked: the thinnest extent, {thinnest:.4}, over {ACROSS}");
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
        let (spacing, reason) = pick(&cube, 5);
        assert_eq!(spacing, 0.02);
        assert!(reason.contains("thinnest"));
    }

    #[test]
    fn a_thin_plate_is_not_packed_with_millions() {
        let plate = Bounds::new(Vector::zeros(), Vector::<3>::new(1.0, 1.0, 0.001));
        let (spacing, reason) = pick(&plate, 5);
        assert!(spacing > 0.004 && reason.contains("ghosts below"));
    }
}
