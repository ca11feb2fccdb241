//! Surfaces that touch themselves, in a face, an edge or a vertex.

use std::f64::consts::TAU;

use aero_geometry::stl::Facet;
use aero_geometry::{Shape, Vector};
use approx::assert_relative_eq;

use super::{at, mesh, prism, shifted, unit_block};

#[test]
fn blocks_that_share_a_face_or_an_edge_or_a_corner_are_one_body() {
    let beside = |offset: Vector<3>| {
        let mut facets = unit_block();
        facets.extend(shifted(unit_block(), offset));
        mesh(facets)
    };
    let face = beside(at(1.0, 0.0, 0.0));
    assert_eq!(face.facet_count(), 20);
    assert_relative_eq!(
        face.signed_distance(&at(0.5, 0.0, 0.0)),
        -0.5,
        epsilon = 1e-12
    );
    for offset in [at(1.0, 1.0, 0.0), at(1.0, 1.0, 1.0)] {
        let pair = beside(offset);
        assert_relative_eq!(pair.volume(), 2.0, max_relative = 1e-12);
        assert_relative_eq!(
            pair.signed_distance(&at(0.0, 0.0, 0.1)),
            -0.4,
            epsilon = 1e-12
        );
        assert!(pair.signed_distance(&(offset + at(0.1, 0.0, 0.1))) < 0.0);
        assert!(pair.signed_distance(&at(1.0, -0.1, 0.0)) > 0.0);
    }
}

#[test]
fn pinches_are_kept_and_told_of() {
    let beside = |offset| [unit_block(), shifted(unit_block(), offset)].concat();
    for (offset, words) in [
        (at(1.0, 1.0, 0.0), "kept 1 edges and 0 single"),
        (at(1.0, 1.0, 1.0), "kept 0 edges and 1 single"),
    ] {
        let mesh = mesh(beside(offset));
        assert!(mesh.repairs()[0].contains(words), "{:?}", mesh.repairs());
        assert_relative_eq!(mesh.volume(), 2.0, epsilon = 1e-12);
        assert!(mesh.signed_distance(&(0.9 * offset)) < 0.0);
    }
}

#[test]
fn a_wall_between_blocks_that_is_cut_otherwise_on_each_side_vanishes() {
    // The mirror image of a block has the other diagonals.
    let image = |[a, b, c]: Facet| [a, c, b].map(|v| at(v.x, -v.y, v.z));
    let second = shifted(
        unit_block().into_iter().map(image).collect(),
        at(1.0, 0.0, 0.0),
    );
    let on_wall = |f: &Facet| f.iter().all(|v| v.x == 0.5);
    for turned in 0..3 {
        let mut facets = [unit_block(), second.clone()].concat();
        assert_eq!(facets.iter().filter(|f| on_wall(f)).count(), 4);
        for facet in facets.iter_mut().filter(|f| on_wall(f)).take(turned) {
            facet.swap(1, 2);
        }
        let pair = mesh(facets);
        assert_eq!(pair.measure(), Some(2.0), "{:?}", pair.repairs());
        assert_relative_eq!(
            pair.signed_distance(&at(0.5, 0.1, 0.0)),
            -0.4,
            epsilon = 1e-12
        );
    }
}

#[test]
fn a_wedge_in_a_notch_does_not_turn_the_solid_below_inside_out() {
    let notched = [
        [0.0, -1.0],
        [-2.0, 0.0],
        [-2.0, -2.0],
        [2.0, -2.0],
        [2.0, 0.0],
    ];
    let wedge = [[0.0, -1.0], [1.0, -0.4], [-1.0, -0.4]];
    let facets = [prism(&notched), prism(&wedge)].concat();
    for turn in 0..16 {
        let (sin, cos) = (f64::from(turn) * TAU / 16.0).sin_cos();
        let turned = |v: Vector<3>| at(cos * v.x - sin * v.y, sin * v.x + cos * v.y, v.z);
        let both = mesh(facets.iter().map(|f| f.map(turned)).collect());
        assert!(both.signed_distance(&turned(at(0.0, -0.6, 0.5))) < 0.0);
        assert!(both.signed_distance(&turned(at(0.0, 0.0, 0.5))) > 0.0);
        // Below the notch the edge in which the two touch is what is nearest: four triangles are.
        for k in 0..100 {
            let k = f64::from(k);
            let angle = 0.4 * (1.7 * k).sin();
            let p = at(
                0.3 * angle.sin(),
                -1.0 - 0.3 * angle.cos(),
                0.35 + 0.003 * k,
            );
            assert_relative_eq!(both.signed_distance(&turned(p)), -0.3, epsilon = 1e-12);
        }
    }
}
