//! Flaws of the triangles that are mended, and told of.

use aero_geometry::Shape;
use aero_geometry::bodies::{cuboid, sphere};
use aero_geometry::stl::Facet;
use approx::assert_relative_eq;

use super::{at, flipped, mesh, shifted, unit_block};

#[test]
fn rounding_noise_is_welded() {
    let facets = sphere(1.0).unwrap().tessellate(40);
    let mut state = 1_u32;
    let mut noise = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        2e-7 * (f64::from(state) / f64::from(u32::MAX) - 0.5)
    };
    let noisy: Vec<Facet> = facets
        .iter()
        .map(|f| f.map(|v| v.map(|x| x + noise())))
        .collect();
    let mesh = mesh(noisy);
    assert_eq!(mesh.facet_count(), facets.len());
    assert!(mesh.repairs()[0].starts_with("welded"));
}

#[test]
fn a_single_precision_body_far_from_the_origin_is_welded() {
    let far = shifted(sphere(1.0).unwrap().tessellate(24), at(1000.0, 0.1, 0.3));
    let rounded = far
        .iter()
        .map(|f| f.map(|v| v.map(|x| f64::from(x as f32))))
        .collect();
    assert!(mesh(rounded).signed_distance(&at(1000.0, 0.1, 0.3)) < -0.9);
}

#[test]
fn triangles_that_come_twice_are_dropped_and_an_inside_out_body_is_turned() {
    let mut facets = flipped(unit_block());
    facets.extend_from_within(..5);
    let mesh = mesh(facets);
    assert_eq!(mesh.facet_count(), 12);
    assert_eq!(mesh.measure(), Some(1.0));
    assert!(
        mesh.repairs()
            .iter()
            .any(|r| r == "dropped 5 triangles that came twice")
    );
    assert!(mesh.repairs().iter().any(|r| r.contains("inside out")));
}

#[test]
fn a_body_given_from_both_sides_is_one_body() {
    let mut facets = unit_block();
    facets.extend(flipped(unit_block()));
    assert_eq!(mesh(facets).measure(), Some(1.0));
}

#[test]
fn a_needle_on_an_edge_is_flipped_away() {
    // One face of the block has a vertex in the middle of its edge; a needle fills the seam.
    let mut facets = unit_block();
    let [a, b, c] = facets[0];
    let middle = 0.5 * (a + b);
    facets[0] = [a, middle, c];
    facets.push([middle, b, c]);
    facets.push([a, b, middle]);
    let mesh = mesh(facets);
    assert!(
        mesh.repairs().iter().any(|r| r.contains("needle")),
        "{:?}",
        mesh.repairs()
    );
    assert_relative_eq!(mesh.measure().unwrap(), 1.0, max_relative = 1e-12);
    let exact = cuboid([1.0; 3]).unwrap();
    for k in 0..500 {
        let k = f64::from(k);
        let p = at((0.37 * k).sin(), (0.73 * k).cos(), (1.13 * k).sin());
        assert!((mesh.signed_distance(&p) - exact.signed_distance(&p)).abs() < 1e-12);
    }
}

#[test]
fn a_missing_triangle_among_many_is_filled_and_reported() {
    let mut facets = sphere(1.0).unwrap().tessellate(24);
    facets.remove(100);
    let ball = mesh(facets);
    assert!(ball.repairs()[0].starts_with("filled 1 holes or cracks"));
    assert!(ball.measure().is_some());
    // An edge that is cut on one side only is a crack without area.
    let mut facets = unit_block();
    let [a, b, c] = facets[0];
    let middle = 0.4 * a + 0.6 * b;
    facets[0] = [a, middle, c];
    facets.push([middle, b, c]);
    let cube = mesh(facets);
    assert!(cube.repairs().iter().any(|r| r.starts_with("filled 1")));
    assert_relative_eq!(cube.volume(), 1.0, max_relative = 1e-12);
}
