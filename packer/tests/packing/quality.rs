//! What is asked of packings, body by body: uniform density over both sides, exact volume, wall layers
//! on their offset, no gaps, no holes, mirror symmetry to the last bit. `--example figures` prints the
//! figures themselves.

use crate::bodies::{self, Aim};
use aero_geometry::Shape;
use aero_packer::{Ghosts, PackOptions, Packing, pack};

/// Largest distance from the wall layer's middle level to the nearest ghost, in spacings.
const HOLE: f64 = 1.25;

/// Most ghosts, of as many as have the volume if each is full: tips need a few small ones.
const MORE: f64 = 1.03;

fn packed<const D: usize>(shape: &dyn Shape<D>, spacing: f64) -> Packing<D> {
    let options = PackOptions {
        fluid_layers: 3,
        ..PackOptions::new(spacing)
    };
    pack(shape, &options).unwrap()
}

fn check<const D: usize>(name: &str, packing: &Packing<D>, aim: Aim) {
    let report = &packing.report;
    assert!(report.density_std_percent <= aim.std, "{name}: {report:?}");
    assert!(report.density_max_percent <= aim.max, "{name}: {report:?}");
    assert!(
        report.shell_volume_error_percent <= 0.1,
        "{name}: {report:?}"
    );
    assert!(report.wall_offset_max <= 1e-6, "{name}: {report:?}");
    assert!(report.min_gap >= aim.gap, "{name}: {report:?}");
    assert!(report.layer_hole_max <= HOLE, "{name}: {report:?}");
    let volumes = &packing.ghosts.volume;
    let full = volumes.iter().sum::<f64>() / report.spacing.powi(D as i32);
    assert!(volumes.len() as f64 <= MORE * full, "{name}: {report:?}");
}

/// The images of all particles about a plane through the origin are particles, bit by bit, with
/// mirrored normals. One that lies on the plane as near to one side of the body as to the other has the normal of either.
fn is_symmetric<const D: usize>(set: &Ghosts<D>, axis: usize) -> bool {
    let key = |flip: bool| {
        let mut rows: Vec<Vec<u64>> = (0..set.position.len())
            .map(|n| {
                let (mut position, mut normal) = (set.position[n], set.normal[n]);
                if flip {
                    position[axis] = -position[axis];
                    normal[axis] = -normal[axis];
                }
                if position[axis] == 0.0 {
                    normal[axis] = normal[axis].abs();
                }
                // Adding zero makes -0 and 0 one.
                position
                    .iter()
                    .chain(normal.iter())
                    .chain([&set.volume[n], &set.distance[n]])
                    .map(|x| (x + 0.0).to_bits())
                    .collect()
            })
            .collect();
        rows.sort_unstable();
        rows
    };
    key(false) == key(true)
}

#[test]
fn plane_bodies_reach_what_is_asked_on_and_off_the_lattice() {
    for body in bodies::planes().unwrap() {
        check(body.name, &packed(&body.shape, 1.0), body.aim);
        let turned = packed(&bodies::off_lattice(&body.shape), 1.0);
        check(body.name, &turned, body.aim);
    }
}

#[test]
fn solid_bodies_reach_what_is_asked() {
    for body in bodies::solids().unwrap() {
        check(body.name, &packed(&body.shape, body.spacing), body.aim);
    }
}

#[test]
fn symmetric_bodies_are_packed_symmetric_to_the_last_bit() {
    for body in bodies::planes().unwrap() {
        let packing = packed(&body.shape, 1.0);
        for (axis, position) in body.shape.mirror_planes() {
            if position == 0.0 {
                assert!(is_symmetric(&packing.ghosts, axis), "{}", body.name);
                assert!(is_symmetric(&packing.fluid, axis), "{}", body.name);
            }
            assert_eq!(packing.report.mirror_error_max, Some(0.0), "{}", body.name);
        }
    }
    let (capsule, mesh) = bodies::capsule().unwrap();
    for (name, shape) in [
        ("capsule", &capsule as &dyn Shape<3>),
        ("its triangles", &mesh),
    ] {
        let ghosts = packed(shape, bodies::capsule_spacing()).ghosts;
        assert!(
            is_symmetric(&ghosts, 1) && is_symmetric(&ghosts, 2),
            "{name}"
        );
    }
}

#[test]
fn ghosts_of_triangles_have_the_normals_of_the_surface_they_stand_for() {
    let (exact, mesh) = bodies::capsule().unwrap();
    let ghosts = pack(&mesh, &PackOptions::new(bodies::capsule_spacing()))
        .unwrap()
        .ghosts;
    let angle = |n: usize| {
        let (normal, right) = (ghosts.normal[n], exact.closest(&ghosts.position[n]).normal);
        normal.cross(&right).norm().atan2(normal.dot(&right))
    };
    // Deeper down some lie where the closest point jumps from one side to the other.
    let wall = (0..ghosts.position.len()).filter(|&n| ghosts.layer[n] == 0);
    let worst = wall.map(angle).fold(0.0, f64::max).to_degrees();
    assert!(worst < 1.0, "{worst} degrees");
}
