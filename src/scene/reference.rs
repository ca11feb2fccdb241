//! What force coefficients of a body refer to where the scene does not say.

use aero_geometry::{Bounds, Shape, Vector};

use aero_solver::problem::{Domain, Side};

use super::silhouette::area_along;

/// The part of a body that forces are reported for: what the domain holds of it, and its image behind the axis and symmetry
/// planes that halve it.
pub(super) fn modelled_part<const D: usize>(bounds: &Bounds<D>, domain: &Domain<D>) -> Bounds<D> {
    let mut part = bounds.intersection(&domain.bounds);
    for k in 0..D {
        let plane = match domain.sides[k][0] {
            Side::Axis => (bounds.min[k] < domain.face(k, 0)).then_some((0, domain.face(k, 0))),
            _ => domain.plane_through(k, bounds),
        };
        match plane {
            Some((0, plane)) => part.min[k] = 2.0 * plane - part.max[k],
            Some((_, plane)) => part.max[k] = 2.0 * plane - part.min[k],
            None => {}
        }
    }
    part
}

/// A silhouette this near to the ellipse in its box is that of a round body.
const ROUND: f64 = 0.005;

/// What a stream along the axis nearest to it sees of the part of a body in a box: its extent in 2D, its silhouette in 3D, a circle around an axis.
pub(super) fn frontal_area<const D: usize>(
    shape: &dyn Shape<D>,
    part: &Bounds<D>,
    velocity: &Vector<D>,
    domain: &Domain<D>,
) -> f64 {
    let size = part.size();
    if domain.is_axisymmetric() {
        return std::f64::consts::FRAC_PI_4 * size[1] * size[1];
    }
    // The same at any incidence: seen along the axis that the stream is nearest to.
    let along = velocity.iamax();
    let others = (0..D).filter(|&k| k != along);
    let seen: f64 = others.map(|k| size[k]).product();
    if seen <= 0.0 {
        // A wall along the stream shows no front.
        return size.max().powi(D as i32 - 1);
    }
    if D < 3 {
        return seen;
    }
    let round = std::f64::consts::FRAC_PI_4 * seen;
    let silhouette = area_along(shape, part, along);
    let is_round = (silhouette - round).abs() < ROUND * round;
    if is_round || silhouette == 0.0 {
        round
    } else {
        silhouette
    }
}

#[cfg(test)]
mod tests {
    use aero_geometry::bodies;

    use super::*;

    fn box_of(length: f64, height: f64) -> (impl Shape<2>, Bounds<2>) {
        let solid = bodies::rectangle(length, height, 0.0).unwrap();
        let bounds = solid.bounds();
        (solid, bounds)
    }

    /// A box whose second axis has these sides.
    fn domain<const D: usize>(sides: [Side; 2]) -> Domain<D> {
        let mut domain = Domain {
            bounds: Bounds::new(Vector::repeat(-3.0), Vector::repeat(3.0)),
            sides: [[Side::Inlet, Side::Outlet]; D],
            openings: Vec::new(),
        };
        domain.bounds.min[1] = 0.0;
        domain.sides[1] = sides;
        domain
    }

    #[test]
    fn half_a_body_behind_a_symmetry_plane_counts_whole() {
        let unit = Bounds::new(Vector::<2>::repeat(-1.0), Vector::<2>::repeat(1.0));
        assert_eq!(
            modelled_part(&unit, &domain([Side::Symmetry, Side::FreeStream])),
            unit
        );
    }

    #[test]
    fn a_body_through_both_planes_of_an_axis_counts_as_far_as_it_is_inside() {
        let tall = Bounds::new(Vector::<2>::repeat(-9.0), Vector::<2>::repeat(9.0));
        let part = modelled_part(&tall, &domain([Side::Symmetry; 2]));
        assert_eq!((part.min[1], part.max[1]), (0.0, 3.0));
    }

    #[test]
    fn the_front_of_a_sphere_is_its_great_circle() {
        let sphere = bodies::sphere(1.0).unwrap();
        let area = frontal_area(
            &sphere,
            &sphere.bounds(),
            &Vector::<3>::new(0.0, 5.0, 0.0),
            &domain([Side::Outlet; 2]),
        );
        assert!((area - std::f64::consts::PI).abs() < 1e-15);
    }

    #[test]
    fn the_front_of_a_block_is_a_rectangle_and_of_a_sphere_cut_off_what_is_left() {
        let far = domain([Side::Outlet; 2]);
        let stream = Vector::<3>::new(1.0, 0.2, 0.0);
        let block = bodies::cuboid([1.0, 0.6, 0.9]).unwrap();
        let area = frontal_area(&block, &block.bounds(), &stream, &far);
        assert!((area / 0.54 - 1.0).abs() < 1e-9, "{area}");
        let sphere = bodies::sphere(1.0).unwrap();
        let mut upper = sphere.bounds();
        upper.min[2] = 0.5;
        let area = frontal_area(&sphere, &upper, &stream, &far);
        let exact = std::f64::consts::FRAC_PI_3 - 0.5 * 0.75_f64.sqrt();
        assert!((area / exact - 1.0).abs() < 4e-3, "{area} for {exact}");
    }

    #[test]
    fn the_front_of_a_plane_body_is_its_extent_across_the_stream() {
        let (box_, part) = box_of(4.0, 0.5);
        let plane = domain([Side::Symmetry, Side::FreeStream]);
        assert_eq!(
            frontal_area(&box_, &part, &Vector::<2>::new(2.0, 0.0), &plane),
            0.5
        );
        assert_eq!(
            frontal_area(&box_, &part, &Vector::<2>::zeros(), &plane),
            0.5
        );
    }

    #[test]
    fn the_front_of_a_body_about_an_axis_is_round() {
        let (box_, part) = box_of(4.0, 2.0);
        let area = frontal_area(
            &box_,
            &part,
            &Vector::zeros(),
            &domain([Side::Axis, Side::FreeStream]),
        );
        assert_eq!(area, std::f64::consts::PI);
    }
}
