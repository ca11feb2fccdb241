//! Bodies of which mirrors show one side.

use aero_geometry::bodies::{cuboid, polygon, rectangle};
use aero_geometry::{Bounds, MirrorPlane, Mirrored, Placed, Placement, Shape, Vector};
use approx::assert_relative_eq;

/// A brick pitched by 20 degrees, which `z = 0.1` cuts askew.
fn brick(shows_above: bool) -> Mirrored<Box<dyn Shape<3>>, 3> {
    let pitched = Placement::default()
        .rotated_about(&Vector::y(), 20_f64.to_radians())
        .unwrap();
    let brick = Placed::new(cuboid([2.0, 1.0, 0.8]).unwrap(), pitched);
    let plane = MirrorPlane {
        axis: 2,
        position: 0.1,
        shows_above,
    };
    Mirrored::new(Box::new(brick), vec![plane])
}

fn everywhere<const D: usize>() -> Bounds<D> {
    Bounds::new(Vector::repeat(-9.0), Vector::repeat(9.0))
}

#[test]
fn a_mirrored_body_is_its_own_image() {
    for shows_above in [true, false] {
        let brick = brick(shows_above);
        assert_eq!(brick.mirror_planes(), [(2, 0.1), (1, 0.0)]);
        for place in [[0.3, 0.2, 0.4], [-0.9, 0.1, 0.15], [1.5, -0.7, 1.1]] {
            let place = Vector::<3>::from(place);
            let image = Vector::<3>::new(place.x, place.y, 0.2 - place.z);
            let (seen, other) = (brick.closest(&place), brick.closest(&image));
            assert_relative_eq!(seen.distance, other.distance, epsilon = 1e-12);
            assert_relative_eq!(seen.point.z, 0.2 - other.point.z, epsilon = 1e-12);
            assert_relative_eq!(seen.normal.z, -other.normal.z, epsilon = 1e-12);
            assert_relative_eq!(seen.distance, brick.signed_distance(&place));
        }
    }
}

/// By the theorem of Gauss the volume below a closed surface is a third of the flux of the places on it.
#[test]
fn facets_of_a_mirrored_body_enclose_twice_the_part_that_is_shown() {
    let volumes = [true, false].map(|shows_above| {
        let brick = brick(shows_above);
        let facets = brick.facets(0.1, &everywhere());
        let bounds = brick.bounds();
        let corners = facets.iter().flatten();
        assert!(corners.clone().all(|c| bounds.grown(1e-9).contains(c)));
        let parts = facets.iter().map(|[a, b, c]| a.dot(&b.cross(c)) / 6.0);
        parts.sum::<f64>()
    });
    // Both parts, each with its image, make two bricks.
    assert_relative_eq!(volumes[0] + volumes[1], 2.0 * 1.6, epsilon = 1e-9);
    assert!(volumes[0] < volumes[1]);
}

#[test]
fn segments_of_a_mirrored_outline_enclose_twice_the_part_that_is_shown() {
    let block = rectangle(2.0, 1.0, 0.0).unwrap();
    let plane = MirrorPlane {
        axis: 1,
        position: 0.2,
        shows_above: true,
    };
    let shown = Mirrored::new(block, vec![plane]);
    let facets = shown.facets(0.1, &everywhere());
    let parts = facets.iter().map(|[a, b]| 0.5 * (a.x * b.y - a.y * b.x));
    // The cut itself has no surface.
    assert_relative_eq!(parts.sum::<f64>(), 2.0 * 0.3 * 2.0, epsilon = 1e-9);
    assert_eq!(shown.mirror_planes(), [(1, 0.2), (0, 0.0)]);
}

/// A ramp on a floor, the floor in the plane: what is below it is not there, and the ramp has an image.
#[test]
fn what_lies_in_a_mirror_plane_is_no_surface() {
    let corners = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.5], [2.0, -0.5], [0.0, -0.5]];
    let floor = polygon(&corners.map(Vector::from)).unwrap();
    let plane = MirrorPlane {
        axis: 1,
        position: 0.0,
        shows_above: true,
    };
    let length: f64 = Mirrored::new(floor, vec![plane])
        .facets(0.1, &everywhere())
        .iter()
        .map(|[a, b]| (b - a).norm())
        .sum();
    // The ramp and its back, twice.
    let expected = 2.0 * (1.25_f64.sqrt() + 0.5);
    assert!((length - expected).abs() < 1e-9, "{length} {expected}");
}
