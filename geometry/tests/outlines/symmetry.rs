//! Mirror planes.

use std::f64::consts::{FRAC_PI_2, PI};

use aero_geometry::bodies::{biconvex, polygon};
use aero_geometry::{Outline, Placed, Placement, Shape};

use super::{at, bodies};

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
fn what_lies_beyond_a_tip_sees_the_face_on_its_own_side() {
    let tip = polygon(&[at(0.0, 0.0), at(1.0, -0.2), at(2.0, 0.0), at(1.0, 0.2)]).unwrap();
    let notch = polygon(&[
        at(0.5, 0.0),
        at(0.0, -0.4),
        at(2.0, -0.4),
        at(2.0, 0.4),
        at(0.0, 0.4),
    ])
    .unwrap();
    let face = |body: &Outline, x: f64, y: f64| body.closest(&at(x, y)).face;
    for y in [1e-3, 0.02, 0.1] {
        assert_eq!(tip.closest(&at(-0.1, y)).point, at(0.0, 0.0));
        assert_eq!(face(&tip, -0.1, y), face(&tip, 0.9, 0.3));
        assert_eq!(face(&tip, -0.1, -y), face(&tip, 0.9, -0.3));
        assert_eq!(face(&tip, 2.1, y), face(&tip, 1.1, 0.3));
        assert_eq!(face(&tip, 2.1, -y), face(&tip, 1.1, -0.3));
        // The same from inside, around the bottom of a notch.
        assert_eq!(notch.closest(&at(0.7, y)).point, at(0.5, 0.0));
        assert_eq!(face(&notch, 0.7, y), face(&notch, 0.2, 0.2));
        assert_eq!(face(&notch, 0.7, -y), face(&notch, 0.2, -0.2));
    }
}
