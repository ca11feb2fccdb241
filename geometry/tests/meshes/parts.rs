//! Surfaces of several parts: cavities, solids within solids, solids that overlap.

use aero_geometry::bodies::sphere;
use aero_geometry::{Shape, Vector};

use super::{at, block, flipped, mesh, shifted};

#[test]
fn a_cavity_stays_hollow() {
    let mut facets = sphere(1.0).unwrap().tessellate(48);
    facets.extend(flipped(sphere(0.5).unwrap().tessellate(48)));
    let hollow = mesh(facets);
    assert!(hollow.signed_distance(&at(0.0, 0.0, 0.1)) > 0.3);
    assert!(hollow.signed_distance(&at(0.0, 0.0, 0.7)) < -0.1);
    assert!(
        hollow
            .repairs()
            .iter()
            .any(|r| r.contains("kept 1 cavity "))
    );
}

#[test]
fn a_mirrored_file_keeps_its_cavities_and_its_nested_solids() {
    let ball = |radius: f64| sphere(radius).unwrap().tessellate(24);
    let hollow = mesh([flipped(ball(1.0)), ball(0.5)].concat());
    assert!(hollow.signed_distance(&at(0.0, 0.0, 0.1)) > 0.3);
    assert!(hollow.signed_distance(&at(0.0, 0.0, 0.7)) < -0.1);
    let nested = mesh([flipped(ball(1.0)), flipped(ball(0.5))].concat());
    assert!(nested.signed_distance(&at(0.0, 0.0, 0.0)) < -0.9);
}

#[test]
fn overlapping_solids_are_united() {
    let ball = || sphere(1.0).unwrap().tessellate(60);
    let mut facets = ball();
    facets.extend(shifted(ball(), at(1.2, 0.0, 0.0)));
    let both = mesh(facets);
    assert!(both.repairs().iter().any(|r| r.contains("united")));
    // Between the centres the buried caps would be the nearest surface.
    let inside = both.closest(&at(0.5, 0.0, 0.0));
    assert!(inside.distance < -0.7, "{}", inside.distance);
    let outside = both.closest(&at(0.6, 1.5, 0.0));
    assert!((outside.distance - (0.36_f64 + 2.25).sqrt() + 1.0).abs() < 5e-3);
    assert!(both.signed_distance(&at(2.1, 0.0, 0.0)) < 0.0);
    // A solid wholly inside of another does not show at all.
    let mut nested = ball();
    nested.extend(sphere(0.5).unwrap().tessellate(30));
    assert!((mesh(nested).signed_distance(&at(0.0, 0.0, 0.0)) + 1.0).abs() < 5e-3);
}

#[test]
fn triangles_that_reach_into_another_solid_end_where_they_enter_it() {
    let mut facets = block([0.0; 3], [1.0; 3]);
    facets.extend(block([0.5; 3], [1.5; 3]));
    let pair = mesh(facets);
    assert!(pair.repairs().iter().any(|r| r.contains("united")));
    let gap = |p: Vector<3>, distance: f64| {
        let found = pair.closest(&p);
        assert!((found.distance - distance).abs() < 1e-9, "{p:?}: {found:?}");
        found
    };
    // Above what is left of the first block's top, and of the second's bottom.
    gap(at(0.25, 0.25, 1.2), 0.2);
    gap(at(1.25, 1.25, 0.3), 0.2);
    // In the common part the nearest surface is the corner where the blocks enter each other.
    let found = gap(at(0.7, 0.72, 0.95), -(0.04_f64 + 0.0025).sqrt());
    assert!(found.normal.dot(&at(-0.2, 0.0, 0.05).normalize()).abs() > 0.6);
    assert!(pair.signed_distance(&at(0.75, 0.75, 0.75)) < 0.0);
    assert_eq!(pair.closest(&at(0.25, 0.25, 1.2)).normal, at(0.0, 0.0, 1.0));
}

#[test]
fn the_winding_number_is_whole_among_thousands_of_small_solids() {
    // Sums of dipoles were off by more than a half here.
    let place = |n: usize| at((n % 20) as f64, (n / 20 % 20) as f64, (n / 400) as f64);
    let cubes = (0..8000).flat_map(|n| shifted(block([0.0; 3], [0.6; 3]), place(n)));
    let mesh = mesh(cubes.collect());
    assert_eq!(mesh.repairs(), [""; 0]);
    for n in (0..8000).step_by(37) {
        assert_eq!(mesh.winding_number(&(place(n) + at(0.3, 0.31, 1e-4))), 1.0);
        assert_eq!(mesh.winding_number(&(place(n) + at(0.3, 0.31, -1e-4))), 0.0);
        // On a corner, either answer is right.
        assert!([0.0, 1.0].contains(&mesh.winding_number(&place(n))));
    }
}
