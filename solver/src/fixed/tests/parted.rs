//! Bodies off the lattice: lattices that begin off the corner of the domain, where that puts bodies in step with them, and points in pairs
//! at edges, where nothing does.

use aero_geometry::{Mesh, Placed, Placement, bodies};

use super::flows::stream;
use super::*;
use crate::fixed::FixedSimulation;
use crate::fixed::site::Site;

const DIAMOND: [[f64; 2]; 4] = [[0.0, 0.0], [0.5, -0.05], [1.0, 0.0], [0.5, 0.05]];

/// With its nose at a place.
fn diamond(nose: [f64; 2]) -> Arc<dyn Shape<2>> {
    let shape = bodies::polygon(&DIAMOND.map(Vector::<2>::from)).unwrap();
    let place = Placement::default().moved(Vector::from(nose));
    Arc::new(Placed::new(shape, place))
}

#[test]
fn cells_are_closed_and_fill_the_domain_wherever_the_lattice_begins() {
    let circle: Arc<dyn Shape<2>> = Arc::new(bodies::circle(0.23).unwrap());
    // A circle's cells end at its chords.
    let round = (circle, 0.23_f64.powi(2) * std::f64::consts::PI, 4e-3);
    // Lines may miss the tips of edges where they are thinner than a twentieth of a spacing.
    let sharp = (diamond([-0.5, 0.02]), 0.05, 3e-4);
    for (body, hole, allowed) in [round, sharp] {
        for off in [-0.5, -0.31, -0.2, 0.13, 0.25, 0.4, 0.5] {
            let mut scene = Scene::new(domain([-0.6, -0.5], [0.63, 0.5]), vec![body.clone()], 0.1);
            scene.off = off;
            let whole = scene.made();
            let mut levels = Levels::on(&scene.plot());
            for index in [[0, 0], [0, 4], [3, 0], [5, 5]] {
                levels.split(&Site { level: 0, index });
            }
            let split = scene.made_with(&levels);
            for made in [whole, split] {
                assert!(made.open(false) < 1e-12, "{off}: {}", made.open(false));
                assert_eq!(made.cells.lost, 0);
                let lack = made.volume() + hole - 1.23;
                assert!(lack.abs() < allowed, "{off}: {lack}");
            }
        }
    }
}

/// Where the lattice is not in step with a side, cells that are split up to it are as fine there as along it: one that lost its neighbour ends at
/// the side instead, by less than a cell further along each axis.
#[test]
fn split_cells_are_as_fine_at_the_sides_as_elsewhere() {
    for off in [-0.87, -0.5, -0.31, -0.07] {
        let mut scene = Scene::new(domain([-0.6, -0.5], [0.63, 0.56]), Vec::new(), 0.1);
        scene.off = off;
        let mut levels = Levels::on(&scene.plot());
        let [across, up] = scene.plot().counts();
        for level in [0, 1] {
            for i in 0..across << level {
                for j in [0, 1, (up << level) - 2, (up << level) - 1] {
                    levels.split(&Site {
                        level,
                        index: [i, j],
                    });
                }
            }
        }
        let made = scene.made_with(&levels);
        assert!(made.open(false) < 1e-12 && (made.volume() - 1.23 * 1.06).abs() < 1e-12);
        let finest = made.cloud.places.iter().filter(|p| p.spacing < 0.03);
        assert!(finest.count() > 20, "{off}");
        for (volume, place) in made.cells.volumes.iter().zip(&made.cloud.places) {
            let size = volume / (place.spacing * place.spacing);
            assert!(size < 4.0, "{off}: {size} at {}", place.position);
        }
    }
}

/// Both points of a pair are there, as far from the edge's bisector, and each of their cells holds one face of the body.
#[test]
fn a_point_at_a_sharp_edge_becomes_two() {
    for off in [-0.04, 0.0, 0.02, 0.031] {
        let scene = Scene::new(
            domain([-0.6, -0.45], [0.63, 0.45]),
            vec![diamond([-0.5, off])],
            0.1,
        );
        let made = scene.made();
        let twins = made.cloud.places.iter().enumerate();
        let twins: Vec<usize> = twins
            .filter(|(_, place)| place.site.is_none())
            .map(|(number, _)| number)
            .collect();
        // At the nose and at the tail.
        assert_eq!(twins.len(), 2, "{off}");
        for twin in twins {
            for number in [twin - 1, twin] {
                let away = scene.solids.distance(&made.cells.points[number]);
                assert!(away > 0.029, "{off}: {away}");
            }
            let [a, b] =
                [twin - 1, twin].map(|number| made.cells.points[number] - Vector::y() * off);
            assert!(
                (a.x - b.x).abs() < 1e-9 && (a.y + b.y).abs() < 1e-9,
                "{off}: {a} {b}"
            );
        }
        // But for the tip of an edge, of which the cell ahead may hold a little.
        let walls = made.cells.walls.iter();
        for wall in walls.filter(|wall| wall.area.norm() > 2e-3) {
            let point = made.cells.points[wall.i as usize];
            let is_above = wall.area.y < 0.0;
            assert_eq!(is_above, point.y > off, "{off}: {point}");
        }
    }
}

/// A symmetric body between open sides, at any place on the lattice: no lift, and the same drag.
#[test]
fn slender_bodies_off_the_lattice_have_no_lift() {
    let forces = [0.0, 0.18, 0.36, 0.5, 0.79].map(|off| {
        let spacing = 0.05;
        let body = diamond([0.0, off * spacing]);
        let bounds = [[-0.2, -0.6], [1.2, 0.6]];
        let mut flow = FixedSimulation::new(stream(3.0, bounds, spacing, vec![body])).unwrap();
        flow.settle(300).unwrap();
        flow.loads()[0].force
    });
    for force in forces {
        assert!(force[1].abs() < 1e-3 * force[0], "{forces:?}");
        assert!((force[0] / forces[0][0] - 1.0).abs() < 1e-3, "{forces:?}");
    }
}

/// Two bodies that no lattice is in step with at once: each as if it were alone.
#[test]
fn two_slender_bodies_have_the_drag_of_one_and_no_lift() {
    let forces = |off: f64| {
        let spacing = 0.05;
        let bounds = [[-0.2, -0.6], [1.2, 1.8]];
        let bodies = vec![diamond([0.0; 2]), diamond([0.0, 1.2 + off * spacing])];
        let mut flow = FixedSimulation::new(stream(3.0, bounds, spacing, bodies)).unwrap();
        flow.settle(300).unwrap();
        let loads = flow.loads();
        [loads[0].force, loads[1].force]
    };
    let [alone, _] = forces(0.0);
    for off in [0.18, 0.36, 0.5, 0.79] {
        for force in forces(off) {
            // Two thirds of the drag where one cell holds both sides of an edge.
            assert!(force[1].abs() < 0.1 * force[0], "{off}: {force:?}");
            let more = force[0] / alone[0] - 1.0;
            assert!(more.abs() < 0.02, "{off}: {force:?} {alone:?}");
        }
    }
}

/// The edges of a wing that is rolled meet the lattice at all places.
#[test]
fn a_rolled_wing_has_the_drag_of_one_along_the_lattice() {
    let corner = |k: usize, z: f64| Vector::<3>::new(DIAMOND[k][0], DIAMOND[k][1], z);
    let mut facets = Vec::new();
    for (a, b) in [(0, 1), (1, 2), (2, 3), (3, 0)] {
        let [low, high] = [-0.5, 0.5].map(|z| [corner(a, z), corner(b, z)]);
        facets.push([low[0], low[1], high[1]]);
        facets.push([low[0], high[1], high[0]]);
    }
    for z in [-0.5, 0.5] {
        for (a, b) in [(1, 2), (2, 3)] {
            let [b, c] = if z < 0.0 { [b, a] } else { [a, b] };
            facets.push([corner(0, z), corner(b, z), corner(c, z)]);
        }
    }
    let drag = |roll: f64| {
        let mesh = Mesh::from_facets(facets.clone()).unwrap();
        let place = Placement::default()
            .rotated_about(&Vector::x(), roll)
            .unwrap();
        let wing: Arc<dyn Shape<3>> = Arc::new(Placed::new(mesh, place));
        let bounds = [[-0.2, -0.5, -0.9], [1.2, 0.5, 0.9]];
        let mut flow = FixedSimulation::new(stream(3.0, bounds, 0.1, vec![wing])).unwrap();
        flow.settle(200).unwrap();
        flow.loads()[0].force[0]
    };
    let [straight, rolled] = [0.0, 0.2].map(drag);
    assert!(
        (rolled / straight - 1.0).abs() < 0.03,
        "{straight} {rolled}"
    );
}
