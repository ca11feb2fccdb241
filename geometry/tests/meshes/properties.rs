//! What holds at any point, and for any triangles.

use std::sync::LazyLock;

use aero_geometry::bodies::cuboid;
use aero_geometry::outline::Piece;
use aero_geometry::stl::Facet;
use aero_geometry::{Mesh, Placed, Placement, Revolution, Shape, Vector};
use proptest::prelude::*;

use super::{at, mesh, unit_block};

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
