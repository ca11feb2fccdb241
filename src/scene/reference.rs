//! What force coefficients of a body refer to where the scene does not say.

use aero_geometry::{Bounds, Vector};

use aero_solver::problem::{Domain, Side};

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

/// Extent of a box across the axis nearest to the stream in 2D; in 3D, and around an axis, the ellipse that fits its two extents across that
/// axis, which is exact for round bodies along an axis.
pub(super) fn frontal_area<const D: usize>(
    size: &Vector<D>,
    velocity: &Vector<D>,
    domain: &Domain<D>,
) -> f64 {
    if domain.is_axisymmetric() {
        return std::f64::consts::FRAC_PI_4 * size[1] * size[1];
    }
    // The same at any incidence: seen along the axis that the stream is nearest to.
    let along = velocity.iamax();
    let others = (0..D).filter(|&k| k != along);
    let seen: f64 = others.map(|k| size[k]).product();
    let round = if D == 3 {
        std::f64::consts::FRAC_PI_4
    } else {
        1.0
    };
    if seen > 0.0 {
        round * seen
    } else {
        // A wall along the stream shows no front.
        size.max().powi(D as i32 - 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
        let size = Vector::<3>::repeat(2.0);
        let area = frontal_area(
            &size,
            &Vector::<3>::new(0.0, 5.0, 0.0),
            &domain([Side::Outlet; 2]),
        );
        assert!((area - std::f64::consts::PI).abs() < 1e-15);
    }

    #[test]
    fn the_front_of_a_plane_body_is_its_extent_across_the_stream() {
        let size = Vector::<2>::new(4.0, 0.5);
        let plane = domain([Side::Symmetry, Side::FreeStream]);
        assert_eq!(
            frontal_area(&size, &Vector::<2>::new(2.0, 0.0), &plane),
            0.5
        );
        assert_eq!(frontal_area(&size, &Vector::<2>::zeros(), &plane), 0.5);
    }

    #[test]
    fn the_front_of_a_body_about_an_axis_is_round() {
        let size = Vector::<2>::new(4.0, 2.0);
        let area = frontal_area(
            &size,
            &Vector::zeros(),
            &domain([Side::Axis, Side::FreeStream]),
        );
        assert_eq!(area, std::f64::consts::PI);
    }
}
