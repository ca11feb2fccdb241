//! Rectangular blocks about the origin.

use crate::error::positive;
use crate::{Bounds, Closest, GeometryError, Shape, Vector};

/// A block with its sides along the axes, centred on the origin. Faces are numbered -x, +x, -y,
/// +y, -z, +z from 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cuboid {
    half: Vector<3>,
}

/// A block of the given edge lengths.
///
/// # Errors
/// An edge that is not above zero.
pub fn cuboid(edges: [f64; 3]) -> Result<Cuboid, GeometryError> {
    let mut half = Vector::<3>::zeros();
    for (axis, name) in ["x edge", "y edge", "z edge"].iter().enumerate() {
        half[axis] = 0.5 * positive("cuboid", name, edges[axis])?;
    }
    Ok(Cuboid { half })
}

impl Shape<3> for Cuboid {
    fn bounds(&self) -> Bounds<3> {
        Bounds::new(-self.half, self.half)
    }

    fn closest(&self, p: &Vector<3>) -> Closest<3> {
        let excess = p.abs() - self.half;
        let axis = excess.imax();
        let side = if p[axis] < 0.0 { -1.0 } else { 1.0 };
        let mut normal = Vector::<3>::zeros();
        normal[axis] = side;
        let face = 2 * axis as u32 + u32::from(side > 0.0);
        if excess[axis] <= 0.0 {
            let mut point = *p;
            point[axis] = side * self.half[axis];
            return Closest {
                point,
                distance: excess[axis],
                normal,
                face,
            };
        }
        let point = p.zip_map(&self.half, |x, half| x.clamp(-half, half));
        let offset = p - point;
        let distance = offset.norm();
        Closest {
            point,
            distance,
            normal: offset / distance,
            face,
        }
    }

    fn mirror_planes(&self) -> Vec<(usize, f64)> {
        vec![(0, 0.0), (1, 0.0), (2, 0.0)]
    }

    fn facets(&self, _: f64, _: &Bounds<3>) -> Vec<[Vector<3>; 3]> {
        let mut facets = Vec::with_capacity(12);
        for axis in 0..3 {
            for side in [-1.0, 1.0] {
                let corner = |u: f64, v: f64| {
                    let mut point = Vector::<3>::zeros();
                    point[axis] = side * self.half[axis];
                    point[(axis + 1) % 3] = side * u * self.half[(axis + 1) % 3];
                    point[(axis + 2) % 3] = v * self.half[(axis + 2) % 3];
                    point
                };
                let [a, b] = [corner(-1.0, -1.0), corner(1.0, -1.0)];
                let [c, d] = [corner(1.0, 1.0), corner(-1.0, 1.0)];
                facets.extend([[a, b, c], [a, c, d]]);
            }
        }
        facets
    }

    fn measure(&self) -> Option<f64> {
        Some(8.0 * self.half.product())
    }
}
