//! Numbers that are known of single bodies, and dimensions that are refused.

use std::f64::consts::{FRAC_PI_3, PI};

use aero_geometry::bodies::{
    Nozzle, biconvex, blunt_wedge, circle, compression_corner, forward_step, rectangle, wall,
};
use aero_geometry::outline::{Outline, Piece};
use aero_geometry::{Shape, Vector};
use approx::assert_relative_eq;

use super::{at, bodies, last_face};

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
fn areas_and_centroids_are_exact() {
    let disc = circle(0.8).unwrap();
    assert_relative_eq!(disc.area().unwrap(), PI * 0.64, max_relative = 1e-14);
    let square = rectangle(1.0, 2.0, 0.1).unwrap();
    let area = 2.0 - (4.0 - PI) * 0.01;
    assert_relative_eq!(square.area().unwrap(), area, max_relative = 1e-14);
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
    assert_eq!(last_face(&aerofoil), 1);
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
