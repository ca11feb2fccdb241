//! How flat a body's front is: what decides, beside its width, how far ahead of it the shock stands.

use aero_geometry::{Bounds, Shape, Vector};

/// Facets of a round front, to its smallest extent.
const AROUND: f64 = 40.0;

/// Mean of the square of the normal's part along x over what of `shape`, which fills `bounds`, faces a stream along x, by the area that the stream
/// sees: one of a flat face, a half of a hemisphere, `sin^2` of a cone's half angle. What another part hides counts too.
pub fn bluntness(shape: &dyn Shape<3>, bounds: &Bounds<3>) -> f64 {
    let (mut seen, mut flat) = (0.0, 0.0);
    shape.for_each_facet(bounds.size().min() / AROUND, bounds, &mut |[a, b, c]| {
        let double: Vector<3> = (b - a).cross(&(c - a));
        let size = double.norm();
        if size > 0.0 && double[0] < 0.0 {
            let towards = -double[0] / size;
            seen += towards * size;
            flat += towards.powi(3) * size;
        }
    });
    if seen > 0.0 { flat / seen } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use aero_geometry::bodies;

    use super::*;

    #[test]
    fn fronts_are_as_blunt_as_they_are() {
        let of = |shape: &dyn Shape<3>| bluntness(shape, &shape.bounds());
        assert!((of(&bodies::cuboid([1.0, 2.0, 3.0]).unwrap()) - 1.0).abs() < 1e-12);
        assert!((of(&bodies::sphere(1.0).unwrap()) - 0.5).abs() < 0.01);
        let cone = bodies::cone(30.0, 1.0).unwrap();
        assert!((of(&cone) - 0.25).abs() < 0.01, "{}", of(&cone));
    }
}
