//! How thick a body is where it is thin, before a spacing is chosen.

use aero_geometry::parallel::prelude::*;
use aero_geometry::{Bounds, Shape};

use crate::midway::chord;
use crate::surface::samples;

/// Samples along the longest extent of a body.
const ACROSS: f64 = 100.0;

/// Part of the surface, in samples, that may be thinner: tips and edges.
const TIPS: f64 = 0.02;

/// See [`crate::thinnest_part`].
pub fn thinnest_part<const D: usize>(shape: &dyn Shape<D>, region: &Bounds<D>) -> Option<f64> {
    let size = shape.bounds().intersection(region).size().max();
    let step = size / ACROSS;
    if !(step.is_finite() && step > 0.0) {
        return None;
    }
    let found = samples(shape, region, step);
    let longest = 0.25 * size;
    let mut chords: Vec<f64> = found
        .par_iter()
        .filter_map(|sample| {
            let seen = (&sample.point, &sample.normal);
            chord(shape, seen, longest, 0.01 * step)
        })
        .collect();
    chords.sort_by(f64::total_cmp);
    chords.get((TIPS * found.len() as f64) as usize).copied()
}

#[cfg(test)]
mod tests {
    use aero_geometry::bodies;

    use super::*;

    #[test]
    fn a_plate_is_as_thick_as_it_is_and_a_block_has_no_thin_part() {
        let region = Bounds::new(
            aero_geometry::Vector::repeat(-9.0),
            aero_geometry::Vector::repeat(9.0),
        );
        let plate = bodies::cuboid([4.0, 3.0, 0.01]).expect("a plate");
        let found = thinnest_part(&plate, &region).expect("a thin part");
        assert!((found - 0.01).abs() < 1e-4, "{found}");
        let block = bodies::cuboid([4.0, 3.0, 2.0]).expect("a block");
        assert_eq!(thinnest_part(&block, &region), None);
    }
}
