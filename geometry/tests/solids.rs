//! Distances, normals, volumes and symmetry of the exact three-dimensional bodies.

use std::f64::consts::{FRAC_PI_2, PI};

use aero_geometry::bodies::{Capsule, cone, cuboid, round_rod, sphere};
use aero_geometry::outline::Piece;
use aero_geometry::{Bounds, Mesh, Placed, Placement, Revolution, Shape, Vector};
use approx::assert_relative_eq;
use proptest::prelude::*;

fn at(x: f64, y: f64, z: f64) -> Vector<3> {
    Vector::<3>::new(x, y, z)
}

fn ring() -> Revolution {
    let center = Vector::<2>::new(0.2, 1.0);
    Revolution::new(vec![Piece::arc(center, 0.4, 0.0, 2.0 * PI)]).unwrap()
}

/// One of each body, about two units in size, near the origin.
fn bodies() -> Vec<Box<dyn Shape<3>>> {
    vec![
        Box::new(sphere(0.8).unwrap()),
        Box::new(cone(20.0, 1.5).unwrap()),
        Box::new(round_rod(0.5, 2.0).unwrap()),
        Box::new(Capsule::apollo().body().unwrap()),
        Box::new(cuboid([1.0, 2.0, 0.5]).unwrap()),
        Box::new(ring()),
    ]
}

fn config() -> ProptestConfig {
    ProptestConfig {
        cases: 400,
        failure_persistence: None,
        ..ProptestConfig::default()
    }
}

fn anywhere() -> impl Strategy<Value = Vector<3>> {
    (-3.0..3.0_f64, -3.0..3.0_f64, -3.0..3.0_f64).prop_map(|(x, y, z)| at(x, y, z))
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn the_closest_point_lies_on_the_surface_at_the_distance_given(
        body in 0..6_usize, p in anywhere(),
    ) {
        let shape = &bodies()[body];
        let closest = shape.closest(&p);
        prop_assert!(((p - closest.point).norm() - closest.distance.abs()).abs() < 1e-12);
        prop_assert!((closest.normal.norm() - 1.0).abs() < 1e-12);
        prop_assert!(shape.signed_distance(&closest.point).abs() < 1e-12);
        prop_assert!((p - closest.point - closest.distance * closest.normal).norm() < 1e-9);
        prop_assert!(closest.distance > 0.0 || shape.bounds().contains(&p));
    }

    #[test]
    fn the_distance_grows_at_unit_rate_along_the_normal(body in 0..6_usize, p in anywhere()) {
        let shape = &bodies()[body];
        let here = shape.closest(&p);
        let step = 1e-6;
        let mut gradient = at(0.0, 0.0, 0.0);
        for axis in 0..3 {
            let mut e = at(0.0, 0.0, 0.0);
            e[axis] = step;
            let (ahead, behind) = (shape.closest(&(p + e)), shape.closest(&(p - e)));
            // Beside the medial axis the closest point jumps.
            let jumps = [ahead, behind].iter().any(|c| (c.point - here.point).norm() > 1e-3);
            prop_assume!(!jumps && here.distance.abs() > 1e-3);
            gradient[axis] = (ahead.distance - behind.distance) / (2.0 * step);
        }
        prop_assert!((gradient - here.normal).norm() < 1e-4);
    }

    #[test]
    fn turning_moving_and_scaling_a_body_carries_its_distances_along(
        body in 0..6_usize, p in anywhere(), axis in anywhere(), angle in -PI..PI,
        offset in anywhere(), scale in 0.1..5.0_f64,
    ) {
        prop_assume!(axis.norm() > 1e-3);
        let shape = bodies().swap_remove(body);
        let placement = Placement::<3>::default()
            .scaled(scale).unwrap()
            .rotated_about(&axis, angle).unwrap()
            .moved(offset);
        let before = shape.closest(&p);
        let volume = shape.measure().unwrap();
        let placed = Placed::new(shape, placement);
        let after = placed.closest(&placement.point(&p));
        prop_assert!((after.distance - scale * before.distance).abs() < 1e-11);
        prop_assert!((placement.point_back(&placement.point(&p)) - p).norm() < 1e-11);
        prop_assert!((placed.measure().unwrap() / volume - scale.powi(3)).abs() < 1e-11 * scale.powi(3));
        if after.distance < 0.0 {
            prop_assert!(placed.bounds().contains(&placement.point(&p)));
        }
    }

    #[test]
    fn mirror_images_are_equally_far(body in 0..6_usize, p in anywhere()) {
        let shape = &bodies()[body];
        for (axis, position) in shape.mirror_planes() {
            let mut image = p;
            image[axis] = 2.0 * position - image[axis];
            prop_assert!((shape.signed_distance(&p) - shape.signed_distance(&image)).abs() < 1e-12);
        }
    }

    #[test]
    fn a_sphere_is_as_far_as_its_centre_less_the_radius(p in anywhere()) {
        let closest = sphere(0.8).unwrap().closest(&p);
        prop_assert!((closest.distance - (p.norm() - 0.8)).abs() < 1e-14);
        prop_assert!((closest.normal - p.normalize()).norm() < 1e-12);
    }
}

#[test]
fn volumes_and_areas_match_the_textbook() {
    let ball = sphere(0.8).unwrap();
    assert_relative_eq!(ball.volume(), 4.0 / 3.0 * PI * 0.512, max_relative = 1e-14);
    assert_relative_eq!(ball.surface_area(), 4.0 * PI * 0.64, max_relative = 1e-14);
    let spike = cone(30.0, 2.0).unwrap();
    let radius = 2.0 / 3.0_f64.sqrt();
    assert_relative_eq!(
        spike.volume(),
        PI * radius * radius * 2.0 / 3.0,
        max_relative = 1e-14
    );
    let slant = radius.hypot(2.0);
    assert_relative_eq!(
        spike.surface_area(),
        PI * radius * (radius + slant),
        max_relative = 1e-14
    );
    let doughnut = ring();
    assert_relative_eq!(
        doughnut.volume(),
        2.0 * PI * PI * 0.16,
        max_relative = 1e-14
    );
    assert_relative_eq!(
        doughnut.surface_area(),
        4.0 * PI * PI * 0.4,
        max_relative = 1e-14
    );
    assert_eq!(cuboid([1.0, 2.0, 0.5]).unwrap().measure(), Some(1.0));
}

#[test]
fn the_apollo_capsule_has_the_published_shape() {
    let capsule = Capsule::apollo().body().unwrap();
    let pieces = capsule.meridian().pieces();
    let shoulder_end = pieces[2].end();
    assert_relative_eq!(
        shoulder_end,
        Vector::<2>::new(0.374_283, 1.836_739),
        epsilon = 1e-6
    );
    assert_relative_eq!(
        pieces[2].start(),
        Vector::<2>::new(0.660_820, 1.924_242),
        epsilon = 1e-6
    );
    let slope = pieces[1].tangent(0.0);
    assert_relative_eq!(
        (-slope.y / slope.x).atan().to_degrees(),
        33.001,
        epsilon = 1e-3
    );
    let bounds = capsule.bounds();
    assert_relative_eq!(bounds.max, at(3.4306, 1.9558, 1.9558), epsilon = 1e-12);
    assert_relative_eq!(bounds.min.x, 0.0);
    assert!(capsule.meridian().corners().is_empty());
    assert_relative_eq!(PI * bounds.max.y.powi(2), 12.017_07, epsilon = 1e-5);
}

#[test]
fn tips_on_the_axis_are_corners_and_poles_are_not() {
    let spike = cone(20.0, 1.5).unwrap();
    let ahead = spike.closest(&at(-1.0, 0.1, 0.0));
    assert_eq!(ahead.point, at(0.0, 0.0, 0.0));
    assert_relative_eq!(
        ahead.normal,
        at(-1.0, 0.1, 0.0).normalize(),
        epsilon = 1e-12
    );
    let base = spike.closest(&at(2.0, 0.0, 0.0));
    assert_eq!(
        (base.point, base.normal),
        (at(1.5, 0.0, 0.0), at(1.0, 0.0, 0.0))
    );
    let pole = sphere(1.0).unwrap().closest(&at(-0.5, 0.0, 0.0));
    assert_eq!(pole.distance, -0.5);
    assert_relative_eq!(pole.normal, at(-1.0, 0.0, 0.0), epsilon = 1e-15);
}

#[test]
fn mirror_planes_survive_the_placements_that_keep_them() {
    let mut planes = sphere(1.0).unwrap().mirror_planes();
    assert_eq!(planes, vec![(0, 0.0), (1, 0.0), (2, 0.0)]);
    planes = cone(20.0, 1.0).unwrap().mirror_planes();
    assert_eq!(planes, vec![(1, 0.0), (2, 0.0)]);
    let upright = Placement::<3>::default()
        .scaled(2.0)
        .unwrap()
        .rotated_about(&at(0.0, 0.0, 1.0), FRAC_PI_2)
        .unwrap()
        .moved(at(1.0, 2.0, 3.0));
    planes = Placed::new(cone(20.0, 1.0).unwrap(), upright).mirror_planes();
    assert_eq!(planes, vec![(0, 1.0), (2, 3.0)]);
    let pitched = Placement::<3>::default()
        .rotated_about(&Vector::y(), 0.1)
        .unwrap();
    planes = Placed::new(cone(20.0, 1.0).unwrap(), pitched).mirror_planes();
    assert_eq!(planes, vec![(1, 0.0)]);
}

#[test]
fn a_wrong_dimension_is_refused() {
    assert!(sphere(0.0).is_err());
    assert!(
        cone(95.0, 1.0)
            .unwrap_err()
            .to_string()
            .contains("95 degrees")
    );
    assert!(round_rod(1.0, 0.5).is_err());
    assert!(
        cuboid([1.0, -1.0, 1.0])
            .unwrap_err()
            .to_string()
            .contains("y edge is -1")
    );
    let short = Capsule {
        length: 0.3,
        ..Capsule::apollo()
    };
    assert!(short.body().unwrap_err().to_string().contains("aft cone"));
    let sharp = Capsule {
        shoulder_radius: 3.0,
        ..Capsule::apollo()
    };
    assert!(
        sharp
            .body()
            .unwrap_err()
            .to_string()
            .contains("shoulder radius")
    );
    assert!(Placement::<3>::default().scaled(-1.0).is_err());
    let below = vec![Piece::segment(
        Vector::<2>::new(1.0, 0.0),
        Vector::<2>::new(0.0, -1.0),
    )];
    assert!(Revolution::new(below).is_err());
}

#[test]
fn a_body_far_larger_than_the_region_has_facets_near_that_alone() {
    let region = Bounds::new(at(-0.1, -0.8, 0.0), at(1.0, 0.8, 0.8));
    let near = cone(10.0, 2.0).unwrap().facets(0.5, &region);
    let far = cone(10.0, 1e6).unwrap().facets(0.5, &region);
    assert!(!near.is_empty() && far.len() < 1000, "{}", far.len());
    // The same where both are, the base apart.
    let widest = far
        .iter()
        .flatten()
        .fold(0.0_f64, |x, point| x.max(point.x));
    assert!(widest > 1.0, "{widest}");
    let everywhere = region.grown(f64::INFINITY);
    assert_eq!(near, cone(10.0, 2.0).unwrap().facets(0.5, &everywhere));
}

#[test]
fn facets_one_by_one_are_the_same_as_all_at_once() {
    let everywhere = Bounds::new(at(-9.0, -9.0, -9.0), at(9.0, 9.0, 9.0));
    let place = Placement::default().scaled(0.7).unwrap();
    let place = place
        .rotated_about(&at(0.3, 0.9, 0.2), 0.4)
        .unwrap()
        .moved(at(0.1, 0.2, -0.3));
    let mesh = || Mesh::from_facets(sphere(1.0).unwrap().tessellate(12)).unwrap();
    let mut all = bodies();
    all.push(Box::new(mesh()));
    all.push(Box::new(Placed::new(mesh(), place)));
    for body in all {
        let mut one_by_one = Vec::new();
        body.for_each_facet(0.3, &everywhere, &mut |facet| one_by_one.push(facet));
        assert!(!one_by_one.is_empty());
        assert_eq!(one_by_one, body.facets(0.3, &everywhere));
    }
}
