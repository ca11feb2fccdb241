//! Solids as CAD programs export them: parts that overlap, touch, face inwards, or are open where they
//! root inside of others. Volumes and areas are those of the union, known exactly.

use aero_geometry::bodies::sphere;
use aero_geometry::stl::{Facet, Soup};
use aero_geometry::{Mesh, Shape, Watch};
use approx::assert_relative_eq;

use super::{at, block, flipped, mesh, refusal, shifted, unit_block};

fn close_to(mesh: &Mesh, volume: f64, area: f64) {
    assert_relative_eq!(mesh.volume(), volume, max_relative = 1e-9);
    assert_relative_eq!(mesh.area(), area, max_relative = 1e-9);
}

/// A block without the two triangles of its side at the low or high end of an axis.
fn without(low: [f64; 3], high: [f64; 3], axis: usize, end: f64) -> Vec<Facet> {
    let mut facets = block(low, high);
    facets.retain(|f| !f.iter().all(|v| v[axis] == end));
    assert_eq!(facets.len(), 10);
    facets
}

#[test]
fn overlapping_blocks_have_the_volume_and_the_area_of_their_union() {
    for offset in [at(0.5, 0.5, 0.5), at(0.3, 0.1, 0.2), at(0.5, 0.0, 0.0)] {
        let pair = mesh([unit_block(), shifted(unit_block(), offset)].concat());
        let shared = offset.map(|x| 1.0 - x);
        let faces = shared.x * shared.y + shared.y * shared.z + shared.z * shared.x;
        close_to(&pair, 2.0 - shared.product(), 12.0 - 2.0 * faces);
    }
}

#[test]
fn blocks_that_touch_in_part_of_a_face_leave_no_surface_between_them() {
    let high = unit_block();
    for small in [
        block([0.5, -0.2, -0.3], [0.8, 0.1, 0.2]),
        // With a corner, and with an edge, in common.
        block([0.5, -0.5, -0.5], [0.8, -0.2, 0.0]),
        block([0.5, -0.5, -0.5], [0.8, -0.2, 0.5]),
    ] {
        let extent = |k: usize| {
            let along = || small.iter().flatten().map(|v| v[k]);
            along().fold(f64::MIN, f64::max) - along().fold(f64::MAX, f64::min)
        };
        let (x, y, z) = (extent(0), extent(1), extent(2));
        let pair = mesh([high.clone(), small].concat());
        close_to(&pair, 1.0 + x * y * z, 6.0 + 2.0 * (x * y + x * z));
        // In the seam the nearest surface is not the seam.
        let p = at(0.5, -0.4, -0.2);
        assert!(pair.signed_distance(&(p + at(-0.1, 0.0, 0.0))) < -0.09);
    }
}

#[test]
fn a_shell_that_is_open_inside_of_another_part_is_closed_by_that() {
    // A fin whose root is inside of the fuselage; then one whose root lies in its surface.
    for root in [0.3, 0.5] {
        let fin = || without([-0.2, root, -0.01], [0.2, 0.9, 0.01], 1, root);
        for fin in [fin(), flipped(fin())] {
            let both = mesh([unit_block(), fin].concat());
            close_to(&both, 1.0 + 0.4 * 0.4 * 0.02, 6.0 + 2.0 * 0.4 * 0.42);
            let told = both.repairs().join("\n");
            assert!(
                told.contains("openings inside") || told.contains("filled 1"),
                "{told}"
            );
        }
    }
    // A canopy: half of a ball, open below, in the top of the fuselage.
    let mut canopy = shifted(sphere(0.3).unwrap().tessellate(64), at(0.0, 0.4, 0.0));
    canopy.retain(|f| f.iter().all(|v| v.y > 0.3));
    let both = mesh([unit_block(), canopy].concat());
    assert!(both.repairs()[0].contains("ignored openings inside of other parts, 1 hole: "));
    assert!(both.signed_distance(&at(0.0, 0.65, 0.0)) < -0.04);
    assert!((both.signed_distance(&at(0.0, 0.8, 0.0)) - 0.1).abs() < 1e-3);
}

#[test]
fn shells_that_are_open_inside_of_each_other_close_each_other() {
    let body = without([0.0; 3], [1.0; 3], 0, 1.0);
    let tail = without([0.5, 0.25, 0.25], [2.0, 0.75, 0.75], 0, 0.5);
    let message = refusal([body, tail].concat());
    // The step around the tail is a hole.
    assert!(message.contains("open at 1 hole"), "{message}");
    let body = without([0.0; 3], [1.0; 3], 0, 1.0);
    let tail = without([0.5, 0.0, 0.0], [2.0, 1.0, 1.0], 0, 0.5);
    close_to(&mesh([body, tail].concat()), 2.0, 2.0 + 4.0 * 2.0);
}

#[test]
fn a_part_that_faces_inwards_and_reaches_out_of_another_is_turned() {
    let pocket = flipped(block([-0.2, -0.2, 0.0], [0.2, 0.2, 1.0]));
    let both = mesh([unit_block(), pocket].concat());
    close_to(&both, 1.0 + 0.5 * 0.16, 6.0 + 4.0 * 0.5 * 0.4);
    assert!(both.repairs().iter().any(|r| r.contains("turned 1 closed")));
}

#[test]
fn nested_cavities_and_the_solids_in_them_take_turns() {
    let shell = |half: f64| block([-half; 3], [half; 3]);
    let facets = [
        shell(1.0),
        flipped(shell(0.8)),
        shell(0.6),
        flipped(shell(0.4)),
    ]
    .concat();
    let nested = mesh(facets);
    assert_relative_eq!(
        nested.volume(),
        8.0 * (1.0 - 0.512 + 0.216 - 0.064),
        max_relative = 1e-9
    );
    let side = |x: f64| nested.signed_distance(&at(x, 0.01, 0.02)) < 0.0;
    assert_eq!([0.1, 0.5, 0.7, 0.9].map(side), [false, true, false, true]);
}

#[test]
fn a_bare_wall_beside_a_solid_is_refused_not_dropped() {
    let wall = |turned: bool| {
        let [a, b, c, d] =
            [[0.5, 0.5], [2.0, 0.5], [2.0, 2.0], [0.5, 2.0]].map(|[x, y]| at(x, y, 0.0));
        let front = vec![[a, b, c], [a, c, d]];
        let back = vec![[a, d, b], [b, d, c]];
        if turned {
            [front, back].concat()
        } else {
            front
        }
    };
    for (turned, words) in [(false, "open at 1 hole"), (true, "without thickness")] {
        let message = refusal([unit_block(), wall(turned)].concat());
        assert!(message.contains(words), "{message}");
        assert!(message.contains("`--thicken T`"), "{message}");
    }
}

#[test]
fn holes_are_filled_if_that_is_asked_for_and_told_of() {
    let filled = |facets: Vec<Facet>| {
        let soup = Soup {
            facets,
            solids: Vec::new(),
        };
        Mesh::filled(soup, &Watch::default())
    };
    let mut cup = unit_block();
    cup.retain(|f| !f.iter().all(|v| v.z == 0.5));
    let cube = filled(cup.clone()).unwrap();
    close_to(&cube, 1.0, 6.0);
    assert_eq!(
        cube.repairs(),
        ["filled 1 hole: 1.414e0 wide near (0.000000, 0.000000, 0.500000)"]
    );
    // A tube with walls of some thickness, without its ring at one end.
    let bore = flipped(without([0.2, 0.2, -1.0], [0.8, 0.8, 1.0], 2, 1.0));
    let mut tube = [without([0.0, 0.0, -2.0], [1.0, 1.0, 1.0], 2, 1.0), bore].concat();
    let cup = filled(tube.clone()).unwrap();
    close_to(&cup, 3.0 - 0.72, 1.0 + 12.0 + 0.64 + 4.0 * 1.2 + 0.36);
    tube.pop();
    assert!(filled(tube).is_ok());
    // A sheet stays one.
    let sheet = vec![[at(0.0, 0.0, 0.0), at(1.0, 0.0, 0.0), at(0.0, 1.0, 0.0)]];
    let message = filled(sheet).unwrap_err().to_string();
    assert!(message.contains("encloses no volume") && message.contains("--thicken"));
}
