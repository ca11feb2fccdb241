//! Bodies that mirrors of the region cut.

use std::sync::LazyLock;

use aero_geometry::{Bounds, Mesh, Placed, Placement, Vector, bodies};
use aero_packer::{Ghosts, PackOptions, pack};

const SPACING: f64 = 0.05;

/// A cone of triangles, of which a turn by a part of a facet leaves no plane of symmetry through its axis.
static CONE: LazyLock<Placed<Mesh, 3>> = LazyLock::new(|| {
    let cone = bodies::cone(15.0, 1.6).unwrap().tessellate(96);
    let turned = Placement::default()
        .rotated_about(&Vector::x(), 1.1_f64.to_radians())
        .unwrap();
    Placed::new(Mesh::from_facets(cone).unwrap(), turned)
});

/// A quarter of space on the given sides of the planes through the axis, which are mirrors.
fn quarter(above: [bool; 2]) -> PackOptions<3> {
    let mut options = PackOptions::new(SPACING);
    let mut region = Bounds::new(Vector::repeat(-2.0), Vector::repeat(2.0));
    for (axis, above) in [1, 2].into_iter().zip(above) {
        if above {
            region.min[axis] = 0.0;
        } else {
            region.max[axis] = 0.0;
        }
        options.mirrors[axis] = [above, !above];
    }
    options.region = Some(region);
    options
}

/// Smallest distance between a ghost and any, or an image of any, in spacings.
fn smallest_gap(ghosts: &Ghosts<3>) -> f64 {
    let mut all = ghosts.position.clone();
    for axis in [1, 2] {
        let off_plane = all.iter().filter(|place| place[axis] != 0.0);
        let images: Vec<Vector<3>> = off_plane
            .map(|place| {
                let mut image = *place;
                image[axis] = -image[axis];
                image
            })
            .collect();
        all.extend(images);
    }
    let others = |n: usize| all[n + 1..].iter().map(move |other| (n, other));
    let pairs = (0..ghosts.position.len()).flat_map(others);
    let gaps = pairs.map(|(n, other)| (ghosts.position[n] - other).norm());
    gaps.fold(f64::INFINITY, f64::min) / SPACING
}

#[test]
fn no_ghost_stands_beside_its_image_where_a_mirror_cuts_a_body_off_its_own_planes() {
    for above in [[true, true], [true, false], [false, false]] {
        let packing = pack(&*CONE, &quarter(above)).unwrap();
        let gap = smallest_gap(&packing.ghosts);
        assert!(gap >= 0.5, "{above:?}: {gap}");
        let report = packing.report;
        assert!(report.warnings.is_empty(), "{above:?}: {report:?}");
        assert!(
            report.shell_volume_error_percent < 0.1 && report.wall_offset_max < 1e-6,
            "{above:?}: {report:?}"
        );
    }
}

#[test]
fn a_mirror_in_which_a_body_is_symmetric_changes_nothing() {
    let cone = bodies::cone(15.0, 1.6).unwrap();
    let mirrors = quarter([true, true]);
    let none = PackOptions {
        mirrors: [[false; 2]; 3],
        ..mirrors.clone()
    };
    let [with, without] = [mirrors, none].map(|options| pack(&cone, &options).unwrap().ghosts);
    assert_eq!(with.position, without.position);
    assert_eq!(with.volume, without.volume);
}
