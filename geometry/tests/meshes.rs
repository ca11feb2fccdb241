//! Bodies made of triangles: distances against exact bodies, repairs, and refusals.

use std::sync::LazyLock;

use aero_geometry::bodies::{Capsule, cone, cuboid, sphere};
use aero_geometry::outline::Piece;
use aero_geometry::stl::Facet;
use aero_geometry::{Mesh, Placed, Placement, Revolution, Shape, Vector};
use approx::assert_relative_eq;
use proptest::prelude::*;

fn at(x: f64, y: f64, z: f64) -> Vector<3> {
    Vector::<3>::new(x, y, z)
}

/// The twelve triangles of a box.
fn block(low: [f64; 3], high: [f64; 3]) -> Vec<Facet> {
    let corner = |k: usize| {
        let pick = |axis: usize| {
            if k >> axis & 1 == 1 {
                high[axis]
            } else {
                low[axis]
            }
        };
        at(pick(0), pick(1), pick(2))
    };
    let quads = [
        [0, 4, 6, 2],
        [1, 3, 7, 5],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 2, 3, 1],
        [4, 5, 7, 6],
    ];
    quads
        .iter()
        .flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]])
        .map(|facet| facet.map(corner))
        .collect()
}

fn unit_block() -> Vec<Facet> {
    block([-0.5; 3], [0.5; 3])
}

fn shifted(facets: Vec<Facet>, offset: Vector<3>) -> Vec<Facet> {
    facets.into_iter().map(|f| f.map(|v| v + offset)).collect()
}

fn flipped(facets: Vec<Facet>) -> Vec<Facet> {
    facets.into_iter().map(|[a, b, c]| [a, c, b]).collect()
}

fn mesh(facets: Vec<Facet>) -> Mesh {
    Mesh::from_facets(facets).unwrap()
}

fn refusal(facets: Vec<Facet>) -> String {
    Mesh::from_facets(facets).unwrap_err().to_string()
}

fn ring() -> Revolution {
    let center = Vector::<2>::new(0.2, 1.0);
    Revolution::new(vec![Piece::arc(center, 0.4, 0.0, std::f64::consts::TAU)]).unwrap()
}

static RING: LazyLock<Mesh> = LazyLock::new(|| mesh(ring().tessellate(48)));

/// Crossings of a ray from `p` with the triangles, without any tree.
fn inside_by_rays(facets: &[Facet], p: &Vector<3>) -> bool {
    let direction = at(0.577_1, 0.348_9, 0.738_2);
    let crossings = facets.iter().filter(|[a, b, c]| {
        // Moeller & Trumbore.
        let (e1, e2) = (b - a, c - a);
        let h = direction.cross(&e2);
        let s = (p - a) / e1.dot(&h);
        let u = s.dot(&h);
        let q = s.cross(&e1);
        let v = direction.dot(&q);
        u >= 0.0 && v >= 0.0 && u + v <= 1.0 && e2.dot(&q) > 0.0
    });
    crossings.count() % 2 == 1
}

fn config(cases: u32) -> ProptestConfig {
    ProptestConfig {
        cases,
        failure_persistence: None,
        ..ProptestConfig::default()
    }
}

fn anywhere() -> impl Strategy<Value = Vector<3>> {
    (-2.0..2.0_f64, -2.0..2.0_f64, -2.0..2.0_f64).prop_map(|(x, y, z)| at(x, y, z))
}

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

proptest! {
    #![proptest_config(config(300))]

    #[test]
    fn the_closest_point_lies_on_the_surface_at_the_distance_given(p in anywhere()) {
        let mesh = &*RING;
        let closest = mesh.closest(&p);
        prop_assert!(((p - closest.point).norm() - closest.distance.abs()).abs() < 1e-12);
        prop_assert!((closest.normal.norm() - 1.0).abs() < 1e-12);
        prop_assert!(mesh.signed_distance(&closest.point).abs() < 1e-12);
    }

    #[test]
    fn the_side_agrees_with_counting_crossings_of_a_ray(p in anywhere()) {
        let inside = inside_by_rays(&ring().tessellate(48), &p);
        let mesh = &*RING;
        prop_assert_eq!(mesh.signed_distance(&p) < 0.0, inside);
        prop_assert_eq!(mesh.winding_number(&p) > 0.5, inside);
    }

    #[test]
    fn the_distance_grows_at_unit_rate(p in anywhere()) {
        let mesh = &*RING;
        let here = mesh.closest(&p);
        let step = 1e-6;
        let mut gradient = at(0.0, 0.0, 0.0);
        for axis in 0..3 {
            let mut e = at(0.0, 0.0, 0.0);
            e[axis] = step;
            let (ahead, behind) = (mesh.closest(&(p + e)), mesh.closest(&(p - e)));
            // Beside the medial axis the closest point jumps.
            let jumps = [ahead, behind].iter().any(|c| (c.point - here.point).norm() > 1e-4);
            prop_assume!(!jumps && here.distance.abs() > 1e-2);
            gradient[axis] = (ahead.distance - behind.distance) / (2.0 * step);
        }
        prop_assert!((gradient.norm() - 1.0).abs() < 1e-4);
        prop_assert!(gradient.dot(&here.normal) > 0.95);
    }

    #[test]
    fn a_placed_mesh_is_the_mesh_of_placed_triangles(
        p in anywhere(), axis in anywhere(), angle in -3.0..3.0_f64, offset in anywhere(),
    ) {
        prop_assume!(axis.norm() > 1e-3);
        let placement = Placement::<3>::default()
            .scaled(0.7).unwrap()
            .rotated_about(&axis, angle).unwrap()
            .moved(offset);
        let facets = unit_block();
        let moved = facets.iter().map(|f| f.map(|v| placement.point(&v))).collect();
        let placed = Placed::new(mesh(facets), placement);
        prop_assert!((placed.signed_distance(&p) - mesh(moved).signed_distance(&p)).abs() < 1e-12);
    }

    #[test]
    fn flipped_and_shuffled_triangles_make_the_same_body(
        flips in prop::collection::vec(any::<bool>(), 12), turn in 0..12_usize, p in anywhere(),
    ) {
        let mut facets: Vec<Facet> = unit_block()
            .into_iter()
            .zip(flips)
            .map(|([a, b, c], flip)| if flip { [a, c, b] } else { [b, c, a] })
            .collect();
        facets.rotate_left(turn);
        let distance = mesh(facets).signed_distance(&p);
        prop_assert!((distance - cuboid([1.0; 3]).unwrap().signed_distance(&p)).abs() < 1e-12);
    }

    #[test]
    fn any_triangles_make_a_body_or_an_error(
        corners in prop::collection::vec(prop::array::uniform3(0..3_u8), 0..60),
    ) {
        // A coarse lattice brings duplicates, needles and folds.
        let facets = corners
            .chunks_exact(3)
            .map(|c| [c[0], c[1], c[2]].map(|v| Vector::<3>::from(v.map(f64::from))))
            .collect();
        if let Ok(mesh) = Mesh::from_facets(facets) {
            prop_assert!(mesh.volume() > 0.0);
            prop_assert!(mesh.closest(&at(0.1, 0.2, 0.3)).distance.is_finite());
        }
    }

    #[test]
    fn a_damaged_block_makes_a_body_or_an_error(
        lost in 0..12_usize, twice in 0..12_usize, moved in 0..36_usize, to in anywhere(),
    ) {
        let mut facets = unit_block();
        facets[moved / 3][moved % 3] = to;
        facets.push(facets[twice]);
        facets.remove(lost);
        let _ = Mesh::from_facets(facets);
    }
}

#[test]
fn rounding_noise_is_welded() {
    let facets = sphere(1.0).unwrap().tessellate(40);
    let mut state = 1_u32;
    let mut noise = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        2e-7 * (f64::from(state) / f64::from(u32::MAX) - 0.5)
    };
    let noisy: Vec<Facet> = facets
        .iter()
        .map(|f| f.map(|v| v.map(|x| x + noise())))
        .collect();
    let mesh = mesh(noisy);
    assert_eq!(mesh.facet_count(), facets.len());
    assert!(mesh.repairs()[0].starts_with("welded"));
}

#[test]
fn a_single_precision_body_far_from_the_origin_is_welded() {
    let far = shifted(sphere(1.0).unwrap().tessellate(24), at(1000.0, 0.1, 0.3));
    let rounded = far
        .iter()
        .map(|f| f.map(|v| v.map(|x| f64::from(x as f32))))
        .collect();
    assert!(mesh(rounded).signed_distance(&at(1000.0, 0.1, 0.3)) < -0.9);
}

#[test]
fn triangles_that_come_twice_are_dropped_and_an_inside_out_body_is_turned() {
    let mut facets = flipped(unit_block());
    facets.extend_from_within(..5);
    let mesh = mesh(facets);
    assert_eq!(mesh.facet_count(), 12);
    assert_eq!(mesh.measure(), Some(1.0));
    assert!(
        mesh.repairs()
            .iter()
            .any(|r| r == "dropped 5 triangles that came twice")
    );
    assert!(mesh.repairs().iter().any(|r| r.contains("inside out")));
}

#[test]
fn a_body_given_from_both_sides_is_one_body() {
    let mut facets = unit_block();
    facets.extend(flipped(unit_block()));
    assert_eq!(mesh(facets).measure(), Some(1.0));
}

#[test]
fn an_open_surface_is_refused_with_the_place_of_the_hole() {
    let mut facets = unit_block();
    facets.truncate(11);
    let message = refusal(facets);
    assert!(
        message.contains("open at 3 edges, the first near ("),
        "{message}"
    );
    let soup: Vec<Facet> = (0..100)
        .map(|k| {
            let k = f64::from(k);
            let p = |s: f64| at((s * k).sin(), (1.3 * s * k).cos(), (2.1 * s * k + s).sin());
            [p(1.0), p(2.0), p(3.0)]
        })
        .collect();
    assert!(refusal(soup).contains("open at"));
}

#[test]
fn what_encloses_nothing_is_refused() {
    assert!(refusal(Vec::new()).contains("no triangles"));
    let point = [at(1.0, 1.0, 1.0); 3];
    assert!(refusal(vec![point; 4]).contains("no triangles"));
    let sheet = [at(0.0, 0.0, 0.0), at(1.0, 0.0, 0.0), at(0.0, 1.0, 0.0)];
    assert!(refusal(vec![sheet, [sheet[0], sheet[2], sheet[1]]]).contains("surface"));
    let mut broken = unit_block();
    broken[3][1].y = f64::NAN;
    assert!(refusal(broken).contains("triangle 4 has a corner that is not finite"));
}

#[test]
fn a_one_sided_surface_is_refused() {
    // A Klein bottle would be closed; the Moebius strip already cannot be oriented.
    let count = 30;
    let point = |k: i32, side: f64| {
        let angle = f64::from(k) * std::f64::consts::TAU / f64::from(count);
        let width = 0.3 * side;
        let r = 1.0 + width * (0.5 * angle).cos();
        at(
            r * angle.cos(),
            r * angle.sin(),
            width * (0.5 * angle).sin(),
        )
    };
    let facets = (0..count)
        .flat_map(|k| {
            let (a, b) = (point(k, -1.0), point(k, 1.0));
            let (c, d) = (point(k + 1, -1.0), point(k + 1, 1.0));
            [[a, c, b], [b, c, d]]
        })
        .collect();
    assert!(refusal(facets).contains("no inside and outside"));
}

#[test]
fn a_needle_on_an_edge_is_flipped_away() {
    // One face of the block has a vertex in the middle of its edge; a needle fills the seam.
    let mut facets = unit_block();
    let [a, b, c] = facets[0];
    let middle = 0.5 * (a + b);
    facets[0] = [a, middle, c];
    facets.push([middle, b, c]);
    facets.push([a, b, middle]);
    let mesh = mesh(facets);
    assert!(
        mesh.repairs().iter().any(|r| r.contains("needle")),
        "{:?}",
        mesh.repairs()
    );
    assert_relative_eq!(mesh.measure().unwrap(), 1.0, max_relative = 1e-12);
    let exact = cuboid([1.0; 3]).unwrap();
    for k in 0..500 {
        let k = f64::from(k);
        let p = at((0.37 * k).sin(), (0.73 * k).cos(), (1.13 * k).sin());
        assert!((mesh.signed_distance(&p) - exact.signed_distance(&p)).abs() < 1e-12);
    }
}

#[test]
fn a_cavity_stays_hollow() {
    let mut facets = sphere(1.0).unwrap().tessellate(48);
    facets.extend(flipped(sphere(0.5).unwrap().tessellate(48)));
    let hollow = mesh(facets);
    assert!(hollow.signed_distance(&at(0.0, 0.0, 0.1)) > 0.3);
    assert!(hollow.signed_distance(&at(0.0, 0.0, 0.7)) < -0.1);
    assert!(hollow.repairs().iter().any(|r| r.contains("cavities")));
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
        assert!((found.distance - distance).abs() < 2e-3, "{p:?}: {found:?}");
        found
    };
    // Above what is left of the first block's top, and of the second's bottom.
    gap(at(0.25, 0.25, 1.2), 0.2);
    gap(at(1.25, 1.25, 0.3), 0.2);
    // In the common part the nearest surface is the corner where the blocks enter each other.
    let found = gap(at(0.7, 0.7, 0.95), -(0.04_f64 + 0.0025).sqrt());
    assert!(found.normal.dot(&at(-0.2, 0.0, 0.05).normalize()).abs() > 0.6);
    assert!(pair.signed_distance(&at(0.75, 0.75, 0.75)) < 0.0);
    assert_eq!(pair.closest(&at(0.25, 0.25, 1.2)).normal, at(0.0, 0.0, 1.0));
}

#[test]
fn a_missing_triangle_among_many_is_filled_and_reported() {
    let mut facets = sphere(1.0).unwrap().tessellate(24);
    facets.remove(100);
    let ball = mesh(facets);
    assert!(ball.repairs()[0].starts_with("filled 1 holes or cracks"));
    assert!(ball.measure().is_some());
    // An edge that is cut on one side only is a crack without area.
    let mut facets = unit_block();
    let [a, b, c] = facets[0];
    let middle = 0.4 * a + 0.6 * b;
    facets[0] = [a, middle, c];
    facets.push([middle, b, c]);
    let cube = mesh(facets);
    assert!(cube.repairs().iter().any(|r| r.starts_with("filled 1")));
    assert_relative_eq!(cube.volume(), 1.0, max_relative = 1e-12);
}

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
