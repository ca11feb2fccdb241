//! The ghosts of a surface do not depend on how it is cut into triangles.

use std::f64::consts::TAU;

use aero_geometry::{Mesh, Shape, Vector};
use aero_packer::{PackOptions, PackReport, pack};

/// A cone of 15 degrees with `around` sides, each cut into `rings` from tip to base.
fn cone(around: usize, rings: usize) -> Mesh {
    let (length, radius) = (1.6, 1.6 * 15_f64.to_radians().tan());
    let place = |ring: usize, side: usize| {
        let part = ring as f64 / rings as f64;
        let (sin, cos) = (TAU * (side % around) as f64 / around as f64).sin_cos();
        Vector::<3>::new(length * part, radius * part * cos, radius * part * sin)
    };
    let mut facets = Vec::new();
    for side in 0..around {
        facets.push([Vector::zeros(), place(1, side + 1), place(1, side)]);
        for ring in 1..rings {
            let [a, b] = [place(ring, side), place(ring, side + 1)];
            let [c, d] = [place(ring + 1, side + 1), place(ring + 1, side)];
            facets.extend([[a, b, c], [a, c, d]]);
        }
        let centre = Vector::<3>::new(length, 0.0, 0.0);
        facets.push([centre, place(rings, side), place(rings, side + 1)]);
    }
    Mesh::from_facets(facets).unwrap()
}

fn report(mesh: &Mesh) -> PackReport {
    pack(mesh, &PackOptions::new(0.036)).unwrap().report
}

#[test]
fn normals_on_a_fan_are_those_of_its_sides() {
    let fan = cone(24, 1);
    let (sin, cos) = 15_f64.to_radians().sin_cos();
    for part in [0.1, 0.5, 0.9] {
        for turn in [0.0, 0.02, 0.11, 0.31] {
            let (s, c) = (TAU * turn).sin_cos();
            let radius = 1.6 * part * sin / cos;
            let seen = fan.closest(&Vector::<3>::new(1.6 * part, radius * c, radius * s));
            let exact = Vector::<3>::new(-sin, cos * c, cos * s);
            let angle = seen.normal.cross(&exact).norm().asin().to_degrees();
            assert!(angle < 8.0, "{angle} degrees at {part}, {turn}");
        }
    }
}

#[test]
fn fans_and_rings_are_packed_alike() {
    for around in [24, 96] {
        let (fan, rings) = (report(&cone(around, 1)), report(&cone(around, 40)));
        for report in [&fan, &rings] {
            assert!(report.wall_offset_max < 1e-6, "{around}: {report:?}");
            assert!(report.uncovered_area_percent <= 0.0, "{around}: {report:?}");
            assert!(report.warnings.is_empty(), "{around}: {report:?}");
        }
        let apart = fan.density_std_percent - rings.density_std_percent;
        assert!(apart.abs() < 0.3, "{around}: {fan:?} and {rings:?}");
        let counts = fan.ghosts as f64 / rings.ghosts as f64;
        assert!((counts - 1.0).abs() < 5e-3, "{around}: {counts}");
    }
}

/// Largest volume of a ghost, of a full one's: that of a row a spacing and a half thick, and a part of what rounding the number of ghosts
/// leaves.
const FULLEST: f64 = 1.5 * 1.05;

/// Whether the tip gets a ghost of its own is a matter of round-off.
#[test]
fn a_ghost_on_the_axis_of_a_tip_is_no_fuller_than_those_beside_it() {
    for around in [24, 48, 96] {
        let cone = cone(around, 1);
        for spacing in [0.05, 0.04, 0.035, 0.03, 0.025] {
            let ghosts = pack(&cone, &PackOptions::new(spacing)).unwrap().ghosts;
            let fullest = ghosts.volume.iter().fold(0.0_f64, |most, &v| most.max(v));
            let part = fullest / spacing.powi(3);
            assert!(part < FULLEST, "{around}, {spacing}: {part}");
        }
    }
}

/// Four triangles: three corners of 45 degrees, at which most layers have no room.
#[test]
fn a_corner_cut_off_a_cube_has_a_place_for_all_of_its_ghosts() {
    let ends = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Vector::<3>::from);
    let facets = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
    let mesh = Mesh::from_facets(facets.map(|facet| facet.map(|end| ends[end])).to_vec()).unwrap();
    for spacing in [0.05, 0.04, 0.03] {
        let report = pack(&mesh, &PackOptions::new(spacing)).unwrap().report;
        assert!(report.warnings.is_empty(), "{spacing}: {report:?}");
        assert!(report.wall_offset_max < 0.05, "{spacing}: {report:?}");
        assert!(
            report.volume_error_percent.abs() < 0.1,
            "{spacing}: {report:?}"
        );
    }
}
