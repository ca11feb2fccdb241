//! How a surface bends: the shape operator at a ghost's foot. The gas that follows a bent wall feels
//! a pressure gradient across it, which the ghosts have to continue.

use aero_geometry::{Shape, Vector};

use crate::records::Matrix;

/// The shape operator `K = dn/dx` of the surface nearest to `point`: symmetric, tangential, and positive where
/// the body bulges into the gas. Differences of the normal over `reach`, within one smooth part of the
/// surface only, so that an edge is an edge and no strong bend.
pub fn shape_operator<const D: usize>(
    shape: &dyn Shape<D>,
    point: &Vector<D>,
    reach: f64,
) -> Matrix<D> {
    let here = shape.closest(point);
    let mut operator = Matrix::zeros();
    let tangents = tangents(&here.normal);
    for tangent in &tangents {
        let mut slope = Vector::<D>::zeros();
        let mut run = 0.0;
        for side in [-reach, reach] {
            let there = shape.closest(&(here.point + tangent * side));
            // Beyond an edge the closest point is the edge, and the normal points along the tangent.
            let beyond_an_edge = there.normal.dot(&here.normal) < 0.5;
            if there.face == here.face && !beyond_an_edge {
                slope += (there.normal - here.normal) * side.signum();
                run += (there.point - here.point).norm();
            }
        }
        if run > 0.5 * reach {
            slope /= run;
            for other in &tangents {
                operator += other * tangent.transpose() * slope.dot(other);
            }
        }
    }
    (operator + operator.transpose()) * 0.5
}

/// An orthonormal basis of the plane across `normal`.
pub fn tangents<const D: usize>(normal: &Vector<D>) -> Vec<Vector<D>> {
    let mut basis: Vec<Vector<D>> = vec![*normal];
    let mut axes: Vec<usize> = (0..D).collect();
    axes.sort_by(|&a, &b| normal[a].abs().total_cmp(&normal[b].abs()));
    for axis in axes.into_iter().take(D - 1) {
        let mut direction = Vector::<D>::zeros();
        direction[axis] = 1.0;
        for known in &basis {
            direction -= known * known.dot(&direction);
        }
        basis.push(direction.normalize());
    }
    basis.split_off(1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use aero_geometry::bodies;
    use approx::assert_relative_eq;

    #[test]
    fn a_sphere_bends_by_its_inverse_radius_both_ways() {
        let sphere = bodies::sphere(2.0).unwrap();
        let point = Vector::<3>::new(0.7, -0.4, 1.1);
        let operator = shape_operator(&sphere, &point, 0.1);
        let n = point.normalize();
        let exact = (Matrix::<3>::identity() - n * n.transpose()) * 0.5;
        assert_relative_eq!(operator, exact, epsilon = 1e-3);
    }

    #[test]
    fn an_edge_between_flat_sides_does_not_bend() {
        let square = bodies::rectangle(2.0, 2.0, 0.0).unwrap();
        let operator = shape_operator(&square, &Vector::<2>::new(0.97, 0.2), 0.1);
        assert_eq!(operator, Matrix::<2>::zeros());
        let corner = shape_operator(&square, &Vector::<2>::new(0.97, 0.94), 0.1);
        assert_eq!(corner, Matrix::<2>::zeros());
    }
}
