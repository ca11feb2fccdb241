//! What holds at any point, and for any polygon.

use std::f64::consts::{PI, TAU};

use aero_geometry::bodies::polygon;
use aero_geometry::outline::Outline;
use aero_geometry::{Placed, Placement, Shape, Vector};
use proptest::prelude::*;

use super::{at, bodies, last_face};

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
        prop_assert!(closest.face <= last_face(outline));
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
