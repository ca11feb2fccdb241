//! A flat side, as the half of a body has where it was cut.

use aero_geometry::{Bounds, Shape, Vector};

use super::attitude::Attitude;
use crate::scene::silhouette::area_along;
use crate::scene::way::Way;

/// A body ends flat where faces in the plane in which it ends are at least this part of what is seen of it from there.
const LEAST: f64 = 0.5;

/// What lies this near to the plane, in parts of the body's size, lies in it.
const ROUNDED: f64 = 1e-5;

/// The side of the file on which the body ends flat, across its length, if it does on one side alone of two.
pub fn flat_side(shape: &dyn Shape<3>, attitude: &Attitude) -> Option<Way> {
    let bounds = shape.bounds();
    let facets = shape.facets(f64::INFINITY, &bounds);
    let across = (0..3).filter(|&axis| axis != attitude.nose.axis);
    across.into_iter().find_map(|axis| {
        let seen = area_along(shape, &bounds, axis);
        let ends = [true, false].map(|is_negative| Way { axis, is_negative });
        let is_flat = ends.map(|way| in_plane(&facets, &bounds, way) >= LEAST * seen);
        match is_flat {
            [true, false] => Some(ends[0]),
            [false, true] => Some(ends[1]),
            _ => None,
        }
    })
}

/// Area of the facets that lie in the plane in which a body ends that way.
fn in_plane(facets: &[[Vector<3>; 3]], bounds: &Bounds<3>, way: Way) -> f64 {
    let end = if way.is_negative {
        bounds.min
    } else {
        bounds.max
    };
    let tolerance = ROUNDED * bounds.size().norm();
    let is_in = |corner: &Vector<3>| (corner[way.axis] - end[way.axis]).abs() <= tolerance;
    let flat = facets.iter().filter(|facet| facet.iter().all(is_in));
    flat.map(|[a, b, c]| 0.5 * (b - a).cross(&(c - a)).norm())
        .sum()
}

#[cfg(test)]
mod tests {
    use aero_geometry::bodies;

    use super::*;

    fn side(shape: &dyn Shape<3>) -> Option<String> {
        let attitude = Attitude::new(shape, None, None, 0.0).unwrap();
        flat_side(shape, &attitude).map(|way| way.to_string())
    }

    #[test]
    fn a_block_and_a_cone_with_its_base_have_two_flat_sides_or_none() {
        assert_eq!(side(&bodies::cuboid([2.0, 0.5, 0.25]).unwrap()), None);
        assert_eq!(side(&bodies::cone(10.0, 2.0).unwrap()), None);
    }
}
