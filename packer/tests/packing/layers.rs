//! Layers of ghosts around simple shapes.

use crate::shapes::{Ball, Polygon};
use aero_geometry::{Bounds, Vector};
use aero_packer::{PackOptions, pack};

#[test]
fn ghosts_of_a_flat_wall_continue_the_lattice() {
    let mut options = PackOptions::new(0.1);
    options.region = Some(Bounds::new(
        Vector::from([-1.0, -1.0]),
        Vector::from([-0.0, 1.0]),
    ));
    let ghosts = pack(&Polygon::corner(0.0), &options).unwrap().ghosts;
    assert_eq!(ghosts.position.len(), 50);
    for p in &ghosts.position {
        for k in 0..2 {
            let site = p[k] / 0.1 - 0.5;
            assert!((site - site.round()).abs() < 1e-12);
        }
    }
}

#[test]
fn layers_of_round_bodies_are_evenly_filled() {
    let circle = pack(&Ball::<2>::new(1.0), &PackOptions::new(0.05))
        .unwrap()
        .report;
    assert!(circle.shell_volume_error_percent < 0.1, "{circle:?}");
    assert!(
        circle.wall_offset_max < 1e-6 && circle.min_gap > 0.9,
        "{circle:?}"
    );
    let sphere = pack(&Ball::<3>::new(1.0), &PackOptions::new(0.05))
        .unwrap()
        .report;
    assert!(sphere.shell_volume_error_percent < 0.1, "{sphere:?}");
    assert!(
        sphere.wall_offset_max < 1e-6 && sphere.min_gap > 0.6,
        "{sphere:?}"
    );
}

#[test]
fn a_part_of_a_body_is_packed_without_the_way_to_its_far_plane_of_symmetry() {
    let radius = 1e7;
    let mut options = PackOptions::new(0.05);
    options.region = Some(Bounds::new(
        Vector::from([-radius - 1.0, -0.5]),
        Vector::from([-radius + 1.0, 0.5]),
    ));
    let packing = pack(&Ball::<2>::new(radius), &options).unwrap();
    assert_eq!(packing.ghosts.position.len(), 5 * 20);
    let report = packing.report;
    assert!(report.shell_volume_error_percent.abs() < 0.1, "{report:?}");
}
