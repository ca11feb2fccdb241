//! Distances and normals against exact bodies and another library.

use aero_geometry::bodies::{Capsule, cone, cuboid, sphere};
use aero_geometry::{Placed, Placement, Shape, Vector};
use approx::assert_relative_eq;

use super::{at, block, mesh, prism, unit_block};

#[test]
fn a_sphere_of_triangles_is_close_to_the_exact_one() {
    let exact = sphere(1.0).unwrap();
    let facets = exact.tessellate(226);
    assert!(facets.len() > 50_000);
    let mesh = mesh(facets);
    assert!(mesh.repairs().is_empty());
    assert_eq!(mesh.patch_count(), 1);
    assert_relative_eq!(mesh.measure().unwrap(), exact.volume(), max_relative = 1e-3);
    assert_eq!(mesh.mirror_planes(), vec![(0, 0.0), (1, 0.0), (2, 0.0)]);
    for k in 0..2000 {
        let k = f64::from(k);
        let direction = at((0.37 * k).sin(), (0.73 * k).cos(), (1.13 * k).sin()).normalize();
        let p = (0.9 + 0.2 * (0.91 * k).sin().abs()) * direction;
        let closest = mesh.closest(&p);
        assert!((closest.distance - exact.signed_distance(&p)).abs() < 2e-4);
        assert!(closest.normal.angle(&direction).to_degrees() < 0.2);
    }
}

#[test]
fn a_block_of_triangles_answers_like_the_exact_one() {
    let (mesh, exact) = (mesh(unit_block()), cuboid([1.0; 3]).unwrap());
    assert_eq!(mesh.patch_count(), 6);
    assert_eq!(mesh.measure(), Some(1.0));
    for k in 0..2000 {
        let k = f64::from(k);
        let p = at((0.37 * k).sin(), (0.73 * k).cos(), (1.13 * k).sin());
        let (a, b) = (mesh.closest(&p), exact.closest(&p));
        assert!((a.distance - b.distance).abs() < 1e-14);
        if (a.point - b.point).norm() < 1e-12 {
            assert!((a.normal - b.normal).norm() < 1e-12);
        }
    }
}

#[test]
fn what_lies_beyond_an_edge_or_a_corner_sees_the_patch_that_faces_it() {
    let diamond = mesh(prism(&[[0.0, 0.0], [1.0, -0.2], [2.0, 0.0], [1.0, 0.2]]));
    let patch = |x: f64, y: f64, z: f64| diamond.closest(&at(x, y, z)).face;
    let (below, above, end) = (
        patch(0.9, -0.3, 0.5),
        patch(0.9, 0.3, 0.5),
        patch(1.0, 0.0, 1.1),
    );
    for y in [1e-3, 0.02, 0.1] {
        for z in [0.1, 0.5, 0.9] {
            assert_eq!(patch(-0.1, y, z), above);
            assert_eq!(patch(-0.1, -y, z), below);
        }
        // Beyond the corner where both meet the end.
        assert_eq!(patch(-0.1 * y, y, 1.0 + 0.5 * y), above);
        assert_eq!(patch(-0.1 * y, -y, 1.0 + 0.5 * y), below);
        assert_eq!(patch(-0.1 * y, y, 1.0 + 2.0 * y), end);
        assert_eq!(patch(-0.1 * y, -y, 1.0 + 2.0 * y), end);
    }
}

#[test]
fn a_ramp_between_wide_triangles_stays_a_crease_and_a_round_wall_has_none() {
    // A block whose top rises by 15 degrees from the middle on.
    let rise = 15.0_f64.to_radians().tan();
    let low = [
        [0.0, 0.0],
        [1.0, 0.0],
        [2.0, 0.0],
        [2.0, 1.0 + rise],
        [1.0, 1.0],
        [0.0, 1.0],
    ];
    let point = |k: usize, z: f64| at(low[k % 6][0], low[k % 6][1], z);
    let mut facets = Vec::new();
    for k in 0..6 {
        let (a, b, c, d) = (
            point(k, 0.0),
            point(k + 1, 0.0),
            point(k + 1, 1.0),
            point(k, 1.0),
        );
        facets.extend([[a, b, c], [a, c, d]]);
    }
    for [a, b, c, d] in [[0, 1, 4, 5], [1, 2, 3, 4]] {
        for [i, j, k] in [[a, b, c], [a, c, d]] {
            facets.push([point(i, 1.0), point(j, 1.0), point(k, 1.0)]);
            facets.push([point(k, 0.0), point(j, 0.0), point(i, 0.0)]);
        }
    }
    let ramp = mesh(facets);
    let flat = ramp.closest(&at(0.8, 1.1, 0.5));
    let slope = ramp.closest(&at(1.5, 1.3, 0.5));
    assert_relative_eq!(flat.normal, at(0.0, 1.0, 0.0), epsilon = 1e-12);
    assert_relative_eq!(
        slope.normal,
        at(-rise, 1.0, 0.0).normalize(),
        epsilon = 1e-12
    );
    assert_ne!(flat.face, slope.face);
    // The cone's wall is one patch, its base another.
    let spike = mesh(cone(20.0, 1.0).unwrap().tessellate(60));
    assert_eq!(spike.patch_count(), 2);
}

#[test]
fn distances_agree_with_another_library() {
    use parry3d::query::PointQuery;
    let facets = Capsule::apollo().body().unwrap().tessellate(40);
    let mesh = mesh(facets.clone());
    let vertices: Vec<_> = facets
        .iter()
        .flatten()
        .map(|v| parry3d::math::Vector::new(v.x, v.y, v.z))
        .collect();
    let indices = (0..facets.len() as u32).map(|f| [3 * f, 3 * f + 1, 3 * f + 2]);
    let other = parry3d::shape::TriMesh::new(vertices, indices.collect()).unwrap();
    for k in 0..3000 {
        let k = f64::from(k);
        let p = at(
            1.5 + 3.0 * (0.37 * k).sin(),
            3.0 * (0.73 * k).cos(),
            3.0 * (1.13 * k).sin(),
        );
        let distance =
            other.distance_to_local_point(parry3d::math::Vector::new(p.x, p.y, p.z), false);
        assert!((mesh.signed_distance(&p).abs() - distance.abs()).abs() < 1e-12);
    }
}

#[test]
fn the_way_out_of_a_block_is_that_to_its_far_face_and_an_edge_tells_nothing() {
    let block = mesh(unit_block());
    let out = |from: Vector<3>, way: Vector<3>| block.way_out(&from, &way.normalize());
    let from = at(-0.31, 0.12, 0.23);
    for (way, expected) in [
        (at(1.0, 0.0, 0.0), 0.81),
        (at(-1.0, 0.0, 0.0), 0.19),
        (at(0.0, -1.0, 0.0), 0.62),
        (at(0.0, 0.0, 1.0), 0.27),
        (at(3.0, 0.1, 0.2), 0.27 * 9.05_f64.sqrt()),
    ] {
        assert_relative_eq!(out(from, way).unwrap(), expected, max_relative = 1e-12);
    }
    // From outside, towards the block and away from it.
    assert_eq!(out(at(-0.7, 0.1, 0.2), at(1.0, 0.0, 0.0)), Some(0.0));
    assert_eq!(out(at(-0.7, 0.1, 0.2), at(-1.0, 0.0, 0.0)), Some(0.0));
    // Along a face, into an edge, and through a diagonal between two triangles of a face.
    assert_eq!(out(at(0.0, 0.0, 0.0), at(1.0, 1.0, 0.0)), None);
    assert_eq!(out(at(0.0, 0.0, 0.0), at(1.0, 0.0, 0.0)), None);
}

#[test]
fn ways_out_of_a_union_lead_through_all_of_it_and_scale_with_it() {
    let mut facets = block([0.0; 3], [1.0; 3]);
    facets.extend(block([0.7, -0.2, -0.3], [2.0, 1.2, 1.4]));
    let both = mesh(facets);
    let (from, along) = (at(0.11, 0.32, 0.47), at(1.0, 0.0, 0.0));
    assert_relative_eq!(both.way_out(&from, &along).unwrap(), 1.89, epsilon = 1e-12);
    assert_relative_eq!(
        both.way_out(&at(0.83, 0.32, 0.47), &along).unwrap(),
        1.17,
        epsilon = 1e-12
    );
    let placement = Placement::default()
        .scaled(2.5)
        .unwrap()
        .rotated_about(&at(0.0, 0.0, 1.0), 0.4)
        .unwrap()
        .moved(at(3.0, -1.0, 2.0));
    let placed = Placed::new(both, placement);
    let (from, along) = (placement.point(&from), placement.direction(&along));
    assert_relative_eq!(
        placed.way_out(&from, &along).unwrap(),
        2.5 * 1.89,
        epsilon = 1e-12
    );
}

#[test]
fn the_way_out_agrees_with_steps_of_the_distance() {
    let exact = Capsule::apollo().body().unwrap();
    let mesh = mesh(exact.tessellate(40));
    let mut told = 0;
    for k in 0..500 {
        let k = f64::from(k);
        let from = at(
            1.5 + (0.37 * k).sin(),
            (0.73 * k).cos(),
            0.9 * (1.13 * k).sin(),
        );
        let way = at((0.51 * k).sin(), (1.7 * k).cos(), (0.77 * k).sin()).normalize();
        if mesh.signed_distance(&from) >= 0.0 {
            continue;
        }
        let mut travelled = 0.0;
        let room = |travelled: f64| -mesh.signed_distance(&(from + travelled * way));
        while room(travelled) > 1e-10 {
            travelled += room(travelled);
        }
        if let Some(found) = mesh.way_out(&from, &way) {
            assert!((found - travelled).abs() < 1e-6, "{k}: {found} {travelled}");
            told += 1;
        }
    }
    assert!(told > 100, "{told}");
}
