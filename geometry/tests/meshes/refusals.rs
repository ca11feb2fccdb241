//! Triangles that enclose no solid, or more than one may be meant.

use aero_geometry::Shape;
use aero_geometry::stl::Facet;

use super::{at, block, flipped, mesh, prism, refusal, unit_block};

#[test]
fn an_open_surface_is_refused_with_the_place_of_the_hole() {
    let mut facets = unit_block();
    facets.truncate(11);
    let message = refusal(facets);
    assert!(
        message.contains("open at 1 hole: 1.414e0 wide near (") && message.contains("`--fill`"),
        "{message}"
    );
    let soup: Vec<Facet> = (0..100)
        .map(|k| {
            let k = f64::from(k);
            let p = |s: f64| at((s * k).sin(), (1.3 * s * k).cos(), (2.1 * s * k + s).sin());
            [p(1.0), p(2.0), p(3.0)]
        })
        .collect();
    assert!(refusal(soup).contains("open at"));
}

#[test]
fn what_encloses_nothing_is_refused() {
    assert!(refusal(Vec::new()).contains("no triangles"));
    let point = [at(1.0, 1.0, 1.0); 3];
    assert!(refusal(vec![point; 4]).contains("no triangles"));
    let sheet = [at(0.0, 0.0, 0.0), at(1.0, 0.0, 0.0), at(0.0, 1.0, 0.0)];
    assert!(refusal(vec![sheet, [sheet[0], sheet[2], sheet[1]]]).contains("surface"));
    // Two squares, each from both sides and with the other diagonal on the back.
    let square = |z: f64| {
        let [a, b, c, d] =
            [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|[x, y]| at(x, y, z));
        [[a, b, c], [a, c, d], [a, d, b], [b, d, c]]
    };
    let message = refusal([square(0.0), square(1.0)].concat());
    assert!(message.contains("encloses no volume"), "{message}");
    let mut broken = unit_block();
    broken[3][1].y = f64::NAN;
    assert!(refusal(broken).contains("triangle 4 has a corner that is not finite"));
}

#[test]
fn a_one_sided_surface_is_refused() {
    // A Klein bottle would be closed; the Moebius strip already cannot be oriented.
    let count = 30;
    let point = |k: i32, side: f64| {
        let angle = f64::from(k) * std::f64::consts::TAU / f64::from(count);
        let width = 0.3 * side;
        let r = 1.0 + width * (0.5 * angle).cos();
        at(
            r * angle.cos(),
            r * angle.sin(),
            width * (0.5 * angle).sin(),
        )
    };
    let facets = (0..count)
        .flat_map(|k| {
            let (a, b) = (point(k, -1.0), point(k, 1.0));
            let (c, d) = (point(k + 1, -1.0), point(k + 1, 1.0));
            [[a, c, b], [b, c, d]]
        })
        .collect();
    assert!(refusal(facets).contains("no inside and outside"));
}

#[test]
fn a_surface_that_turns_inside_out_where_it_crosses_itself_is_refused() {
    // The corners run around the left half of the bow one way and around the right the other.
    let bow = [[-2.0, -2.0], [1.0, 1.0], [1.0, -1.0], [-2.0, 2.0]];
    let message = refusal(prism(&bow));
    assert!(message.contains("inside out, near ("), "{message}");
}

#[test]
fn an_inner_part_that_faces_both_ways_is_refused() {
    let hollow = |turned: usize| {
        let mut wall = flipped(block([-0.25; 3], [0.25; 3]));
        for facet in &mut wall[..turned] {
            facet.swap(1, 2);
        }
        [unit_block(), wall].concat()
    };
    let message = refusal(hollow(5));
    assert!(message.contains("cavity or a solid within"), "{message}");
    assert!(message.contains("12 triangles"), "{message}");
    assert!(
        message.contains("42 % of it facing the other way"),
        "{message}"
    );
    // A few of many are a slip.
    assert!(mesh(hollow(2)).signed_distance(&at(0.0, 0.0, 0.0)) > 0.2);
    assert!(mesh(hollow(10)).signed_distance(&at(0.0, 0.0, 0.0)) < -0.4);
}
