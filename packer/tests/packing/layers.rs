//! Layers of ghosts around simple shapes.

use crate::shapes::{Ball, Polygon};
use aero_geometry::{Bounds, Placed, Placement, Vector, bodies};
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

/// The middle of the top layer lies half way between two rows of the lattice; round-off decides which is the nearer one, or none.
#[test]
fn a_face_half_a_spacing_off_the_lattice_has_its_wall_layer_everywhere() {
    for spacing in [0.0002, 0.1, 0.3] {
        for top in [10.5, 35.5, 72.5] {
            let block = bodies::cuboid([14.0 * spacing, 14.0 * spacing, 9.0 * spacing]).unwrap();
            let turned = Placement::default().rotated_about(&Vector::<3>::z(), 0.3);
            let middle = (top - 4.5) * spacing;
            let place = turned.unwrap().moved(Vector::<3>::new(0.0, 0.0, middle));
            let packing = pack(&Placed::new(block, place), &PackOptions::new(spacing)).unwrap();
            let ghosts = &packing.ghosts;
            let wall = (0..ghosts.position.len()).filter(|&n| {
                let at = &ghosts.position[n];
                ghosts.layer[n] == 0 && at[2] > middle && at[0].hypot(at[1]) < 5.0 * spacing
            });
            let (count, exact) = (wall.count() as f64, 25.0 * std::f64::consts::PI);
            assert!(
                (count - exact).abs() < 0.15 * exact,
                "{spacing}, {top}: {count} for {exact}"
            );
        }
    }
}
