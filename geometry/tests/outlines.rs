//! Distances, signs, normals and symmetry of the two-dimensional bodies.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, PI, TAU};

use aero_geometry::bodies::{
    Nozzle, biconvex, blunt_wedge, circle, compression_corner, expansion_corner, forward_step,
    polygon, rectangle, wall,
};
use aero_geometry::outline::{Outline, Piece};
use aero_geometry::{Placed, Placement, Shape, Vector};
use approx::assert_relative_eq;
use proptest::prelude::*;

fn at(x: f64, y: f64) -> Vector<2> {
    Vector::<2>::new(x, y)
}

/// One of each body, about two units in size, near the origin.
fn bodies() -> Vec<Outline> {
    let star = (0..10)
        .map(|k| {
            (1.0 - 0.6 * f64::from(k % 2))
                * at(
                    (f64::from(k) * PI / 5.0).cos(),
                    (f64::from(k) * PI / 5.0).sin(),
                )
        })
        .collect::<Vec<_>>();
    let wavy = (0..300)
        .map(|k| {
            let angle = TAU * f64::from(k) / 300.0;
            (1.0 + 0.3 * (5.0 * angle).cos()) * at(angle.cos(), angle.sin())
        })
        .collect::<Vec<_>>();
    vec![
        wall(0.2).unwrap(),
        compression_corner(0.0, 20.0).unwrap(),
        expansion_corner(-0.3, 35.0).unwrap(),
        forward_step(0.1, 0.7).unwrap(),
        biconvex(2.0, 0.1).unwrap(),
        Nozzle::back().walls().unwrap(),
        Nozzle::back().upper_wall().unwrap(),
        circle(0.8).unwrap(),
        blunt_wedge(0.5, 14.04, 2.0).unwrap(),
        blunt_wedge(0.5, 14.04, f64::INFINITY).unwrap(),
        rectangle(2.0, 1.0, 0.0).unwrap(),
        rectangle(1.0, 2.0, 0.1).unwrap(),
        polygon(&star).unwrap(),
        polygon(&wavy).unwrap(),
    ]
}

/// Distance by walking along every piece.
fn sampled_distance(outline: &Outline, p: &Vector<2>) -> f64 {
    let mut best = f64::INFINITY;
    for piece in outline.pieces() {
        let [from, to] = piece.range().map(|s| s.clamp(-20.0, 20.0));
        let count = 40_000 / outline.pieces().len();
        for k in 0..=count {
            let s = from + (to - from) * k as f64 / count as f64;
            best = best.min((piece.point(s) - p).norm());
        }
    }
    best
}

/// Inside or not by the winding angle of every piece, closed outlines only.
fn winding(outline: &Outline, p: &Vector<2>) -> f64 {
    let mut total = 0.0;
    for piece in outline.pieces() {
        let mut last = piece.start() - p;
        for k in 1..=400 {
            let next = piece.point(piece.length() * f64::from(k) / 400.0) - p;
            total += (last.x * next.y - last.y * next.x).atan2(last.dot(&next));
            last = next;
        }
    }
    total / TAU
}

fn config() -> ProptestConfig {
    ProptestConfig {
        cases: 400,
        failure_persistence: None,
        ..ProptestConfig::default()
    }
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn the_closest_point_lies_on_the_surface_at_the_distance_given(
        body in 0..14_usize, x in -3.0..3.0_f64, y in -3.0..3.0_f64,
    ) {
        let outline = &bodies()[body];
        let p = at(x, y);
        let closest = outline.closest(&p);
        prop_assert!(((p - closest.point).norm() - closest.distance.abs()).abs() < 1e-12);
        prop_assert!((closest.normal.norm() - 1.0).abs() < 1e-12);
        prop_assert!(outline.signed_distance(&closest.point).abs() < 1e-12);
        prop_assert!((p - closest.point - closest.distance * closest.normal).norm() < 1e-9);
        prop_assert!((closest.face as usize) < outline.face_count());
    }

    #[test]
    fn the_normal_leads_outside(body in 0..14_usize, x in -3.0..3.0_f64, y in -3.0..3.0_f64) {
        let outline = &bodies()[body];
        let closest = outline.closest(&at(x, y));
        let step = 1e-7;
        // Over a tip the way back from a slanting normal may miss the body.
        prop_assume!(outline.corners().iter().all(|c| c.point != closest.point));
        prop_assert!(outline.signed_distance(&(closest.point + step * closest.normal)) > 0.0);
        prop_assert!(outline.signed_distance(&(closest.point - step * closest.normal)) < 0.0);
    }

    #[test]
    fn the_distance_grows_at_unit_rate_along_the_normal(
        body in 0..14_usize, x in -3.0..3.0_f64, y in -3.0..3.0_f64,
    ) {
        let outline = &bodies()[body];
        let p = at(x, y);
        let here = outline.closest(&p);
        let step = 1e-6;
        let shifted = [at(step, 0.0), at(0.0, step)]
            .map(|e| [outline.closest(&(p + e)), outline.closest(&(p - e))]);
        // Beside the medial axis the closest point jumps.
        let jumps = shifted.iter().flatten().any(|c| (c.point - here.point).norm() > 1e-3);
        prop_assume!(!jumps && here.distance.abs() > 1e-3);
        let gradient = at(
            (shifted[0][0].distance - shifted[0][1].distance) / (2.0 * step),
            (shifted[1][0].distance - shifted[1][1].distance) / (2.0 * step),
        );
        prop_assert!((gradient - here.normal).norm() < 1e-4);
    }

    #[test]
    fn turning_moving_and_scaling_a_body_carries_its_distances_along(
        body in 0..14_usize, x in -3.0..3.0_f64, y in -3.0..3.0_f64,
        angle in -PI..PI, dx in -2.0..2.0_f64, dy in -2.0..2.0_f64, scale in 0.1..5.0_f64,
    ) {
        let outline = bodies().swap_remove(body);
        let placement = Placement::<2>::default()
            .scaled(scale).unwrap().rotated(angle).moved(at(dx, dy));
        let p = at(x, y);
        let before = outline.closest(&p);
        let direct = outline.placed(&placement).closest(&placement.point(&p));
        let wrapped = Placed::new(outline, placement).closest(&placement.point(&p));
        for after in [direct, wrapped] {
            prop_assert!((after.distance - scale * before.distance).abs() < 1e-11);
            // On the medial axis rounding picks the side.
            if (after.point - placement.point(&before.point)).norm() < 1e-6 {
                prop_assert!((after.normal - placement.direction(&before.normal)).norm() < 1e-6);
            }
        }
    }

    #[test]
    fn points_are_inside_where_the_outline_winds_around_them(
        body in 0..14_usize, x in -1.5..1.5_f64, y in -1.5..1.5_f64,
    ) {
        let outline = &bodies()[body];
        prop_assume!(outline.area().is_some());
        let p = at(x, y);
        let distance = outline.signed_distance(&p);
        prop_assume!(distance.abs() > 1e-3);
        prop_assert_eq!(distance < 0.0, winding(outline, &p) > 0.5);
    }

    #[test]
    fn random_polygons_agree_with_ray_casting(
        radii in prop::collection::vec(0.2..1.0_f64, 3..40), x in -1.0..1.0_f64, y in -1.0..1.0_f64,
    ) {
        let count = radii.len() as f64;
        let points: Vec<_> = radii
            .iter()
            .enumerate()
            .map(|(k, r)| {
                let angle = TAU * k as f64 / count;
                *r * at(angle.cos(), angle.sin())
            })
            .collect();
        let outline = polygon(&points).unwrap();
        let mut crossings = 0;
        for k in 0..points.len() {
            let (a, b) = (points[k], points[(k + 1) % points.len()]);
            if (a.y > y) != (b.y > y) && x < a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x) {
                crossings += 1;
            }
        }
        let distance = outline.signed_distance(&at(x, y));
        prop_assume!(distance.abs() > 1e-9);
        prop_assert_eq!(distance < 0.0, crossings % 2 == 1);
    }

    #[test]
    fn mirror_images_are_equally_far(
        body in 0..14_usize, x in -3.0..3.0_f64, y in -3.0..3.0_f64,
    ) {
        let outline = &bodies()[body];
        for (axis, position) in outline.mirror_planes() {
            let mut image = at(x, y);
            image[axis] = 2.0 * position - image[axis];
            let difference = outline.signed_distance(&at(x, y)) - outline.signed_distance(&image);
            prop_assert!(difference.abs() < 1e-12);
        }
    }

    #[test]
    fn any_points_make_a_polygon_or_an_error(
        points in prop::collection::vec((-1.0..1.0_f64, -1.0..1.0_f64), 0..12),
    ) {
        let points: Vec<_> = points.into_iter().map(|(x, y)| at(x, y)).collect();
        if let Ok(outline) = polygon(&points) {
            prop_assert!(outline.area().unwrap() > 0.0);
        }
    }
}

#[test]
fn distances_agree_with_a_walk_along_the_curve() {
    for outline in bodies() {
        for k in 0..12 {
            let p = at(
                1.7 * f64::from(k).cos() + 0.1,
                1.3 * (2.3 * f64::from(k)).sin(),
            );
            let distance = outline.signed_distance(&p).abs();
            assert!((distance - sampled_distance(&outline, &p)).abs() < 2e-3);
        }
    }
}

#[test]
fn the_mirror_planes_are_those_one_sees() {
    let planes: Vec<_> = bodies().iter().map(Shape::mirror_planes).collect();
    let x = |position| vec![(0, position)];
    let y = vec![(1, 0.0)];
    let both = |position| vec![(0, position), (1, 0.0)];
    assert_eq!(planes[0], x(0.0));
    assert_eq!(planes[1], vec![]);
    assert_eq!(planes[2], vec![]);
    assert_eq!(planes[3], vec![]);
    assert_eq!(planes[4], both(1.0));
    assert_eq!(planes[5], y);
    assert_eq!(planes[6], vec![]);
    assert_eq!(planes[7], both(0.0));
    assert_eq!(planes[8], y);
    assert_eq!(planes[9], y);
    assert_eq!(planes[10], both(0.0));
    assert_eq!(planes[11], both(0.0));
    assert_eq!(planes[12], y);
    assert_eq!(planes[13], y);
}

#[test]
fn a_quarter_turn_keeps_mirror_planes_and_an_eighth_drops_them() {
    let aerofoil = biconvex(2.0, 0.1).unwrap();
    let upright = Placement::<2>::default()
        .rotated(FRAC_PI_2)
        .moved(at(0.5, 0.0));
    for planes in [
        aerofoil.placed(&upright).mirror_planes(),
        Placed::new(aerofoil.clone(), upright).mirror_planes(),
    ] {
        let mut planes = planes;
        planes.sort_by_key(|plane| plane.0);
        assert_eq!(planes, vec![(0, 0.5), (1, 1.0)]);
    }
    let tilted = Placement::<2>::default().rotated(0.25 * PI);
    assert!(aerofoil.placed(&tilted).mirror_planes().is_empty());
    assert!(Placed::new(aerofoil, tilted).mirror_planes().is_empty());
}

#[test]
fn areas_perimeters_and_centroids_are_exact() {
    let disc = circle(0.8).unwrap();
    assert_relative_eq!(disc.area().unwrap(), PI * 0.64, max_relative = 1e-14);
    assert_relative_eq!(disc.perimeter(), TAU * 0.8, max_relative = 1e-14);
    let square = rectangle(1.0, 2.0, 0.1).unwrap();
    let (area, perimeter) = (2.0 - (4.0 - PI) * 0.01, 6.0 - 0.8 + TAU * 0.1);
    assert_relative_eq!(square.area().unwrap(), area, max_relative = 1e-14);
    assert_relative_eq!(square.perimeter(), perimeter, max_relative = 1e-14);
    // A half disc: its centroid lies 4 R / (3 pi) off the flat side.
    let half = Outline::new(vec![vec![
        Piece::arc(at(1.0, 1.0), 2.0, 0.0, PI),
        Piece::segment(at(-1.0, 1.0), at(3.0, 1.0)),
    ]])
    .unwrap();
    let centroid = half.centroid().unwrap();
    assert_relative_eq!(centroid.x, 1.0, max_relative = 1e-14);
    assert_relative_eq!(centroid.y, 1.0 + 8.0 / (3.0 * PI), max_relative = 1e-14);
    assert_eq!(wall(0.0).unwrap().area(), None);
}

#[test]
fn the_tips_of_the_aerofoil_have_the_angle_of_its_arcs() {
    let aerofoil = biconvex(1.0, 0.1).unwrap();
    let corners = aerofoil.corners();
    assert_eq!(corners.len(), 2);
    for corner in corners {
        // tan(a / 2) = thickness / chord for a tip half-angle a.
        assert_relative_eq!(
            corner.interior_angle,
            4.0 * 0.1_f64.atan(),
            max_relative = 1e-12
        );
    }
    assert_relative_eq!(corners[0].bisector, at(1.0, 0.0), epsilon = 1e-12);
    assert_eq!(aerofoil.face_count(), 2);
    let tip = aerofoil.closest(&at(-0.3, 0.0));
    assert_eq!(tip.point, at(0.0, 0.0));
    assert_relative_eq!(tip.normal, at(-1.0, 0.0));
}

#[test]
fn the_nozzle_has_the_published_joints() {
    let nozzle = Nozzle::back();
    let wall = nozzle.upper_wall().unwrap();
    let points: Vec<_> = wall.pieces()[1..].iter().map(Piece::start).collect();
    let expected = [
        at(-2.118_619, 1.5955),
        at(-1.043_986, 1.179_316),
        at(0.401_170, 0.827_815),
    ];
    for (point, expected) in points.iter().zip(expected) {
        assert_relative_eq!(*point, expected, epsilon = 1e-6);
    }
    assert_relative_eq!(nozzle.half_height(3.0).unwrap(), 1.524_169, epsilon = 1e-6);
    assert!(wall.corners().is_empty());
    for x in [-3.0, -2.0, -1.5, -1.0, -0.3, 0.2, 0.5, 2.0] {
        let height = nozzle.half_height(x).unwrap();
        assert!(wall.signed_distance(&at(x, height)).abs() < 1e-12);
    }
}

#[test]
fn endless_solids_reach_to_infinity_on_the_right_sides() {
    let infinity = f64::INFINITY;
    let bounds = forward_step(0.6, 0.2).unwrap().bounds();
    assert_eq!(
        (bounds.min, bounds.max),
        (at(-infinity, -infinity), at(infinity, 0.2))
    );
    let bounds = compression_corner(0.0, 10.0).unwrap().bounds();
    assert_eq!(
        (bounds.min, bounds.max),
        (at(-infinity, -infinity), at(infinity, infinity))
    );
    let bounds = Nozzle::back().upper_wall().unwrap().bounds();
    assert_eq!(
        (bounds.min.x, bounds.max),
        (-infinity, at(infinity, infinity))
    );
    assert_relative_eq!(bounds.min.y, 0.775, max_relative = 1e-12);
    let bounds = blunt_wedge(1.0, 14.04, infinity).unwrap().bounds();
    assert_eq!(
        (bounds.min, bounds.max),
        (at(-1.0, -infinity), at(infinity, infinity))
    );
    let far = compression_corner(0.0, 45.0)
        .unwrap()
        .signed_distance(&at(1e6, 1e6 + 2.0));
    assert_relative_eq!(far, 2.0_f64.sqrt(), max_relative = 1e-9);
}

#[test]
fn a_re_entrant_corner_answers_from_inside_and_a_convex_one_from_outside() {
    let ramp = compression_corner(0.0, 60.0).unwrap();
    assert_relative_eq!(
        ramp.corners()[0].interior_angle,
        PI + FRAC_PI_3,
        max_relative = 1e-12
    );
    let inside = ramp.closest(&at(0.1, -1.0));
    assert_eq!(inside.point, at(0.0, 0.0));
    assert!(inside.distance < -1.0);
    assert!(inside.normal.dot(&at(0.0, 1.0)) > 0.9);
    assert_eq!(ramp.closest(&at(-1.0, 0.5)).face, 1);
    assert_eq!(ramp.closest(&at(1.0, 2.0)).face, 0);
    // On the corner itself the normal is the bisector.
    let corner = ramp.closest(&at(0.0, 0.0));
    assert_eq!(corner.distance.abs(), 0.0);
    assert_relative_eq!(corner.normal, ramp.corners()[0].bisector, epsilon = 1e-12);
}

#[test]
fn a_wrong_dimension_is_refused_by_name() {
    let message = |result: Result<Outline, _>| match result {
        Ok(_) => panic!("accepted"),
        Err::<_, aero_geometry::GeometryError>(error) => error.to_string(),
    };
    assert_eq!(
        message(compression_corner(0.0, 95.0)),
        "compression corner: angle is 95 degrees, but must be between 0 and 90"
    );
    assert!(message(compression_corner(0.0, 0.0)).contains("angle is 0"));
    assert!(message(compression_corner(f64::NAN, 10.0)).contains("corner is NaN"));
    assert!(message(circle(-1.0)).contains("radius is -1"));
    assert!(message(biconvex(1.0, 1.5)).contains("thickness ratio is 1.5"));
    assert!(message(rectangle(1.0, 2.0, 0.6)).contains("corner radius is 0.6"));
    assert!(message(blunt_wedge(1.0, 10.0, 0.5)).contains("length is 0.5"));
    let wide = Nozzle {
        throat: 2.0,
        ..Nozzle::back()
    };
    assert!(message(wide.walls()).contains("wider than the throat"));
}
