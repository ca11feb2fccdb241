//! Lattices that begin off the corner of the domain, where that puts bodies in step with them.

use aero_geometry::{Placed, Placement, bodies};

use super::flows::stream;
use super::*;
use crate::fixed::FixedSimulation;
use crate::fixed::site::Site;

#[test]
fn cells_are_closed_and_fill_the_domain_wherever_the_lattice_begins() {
    let circle = || -> Vec<Arc<dyn Shape<2>>> { vec![Arc::new(bodies::circle(0.23).unwrap())] };
    for bodies in [Vec::new(), circle()] {
        for off in [-0.5, -0.31, -0.2, 0.13, 0.25, 0.4, 0.5] {
            let mut scene = Scene::new(domain([-0.6, -0.5], [0.63, 0.5]), bodies.clone(), 0.1);
            scene.off = off;
            let whole = scene.made();
            let mut levels = Levels::on(&scene.plot());
            for index in [[0, 0], [0, 4], [3, 0], [5, 5]] {
                levels.split(&Site { level: 0, index });
            }
            let split = scene.made_with(&levels);
            let hole = if bodies.is_empty() {
                0.0
            } else {
                0.23_f64.powi(2) * std::f64::consts::PI
            };
            for made in [whole, split] {
                assert!(made.open(false) < 1e-12, "{off}: {}", made.open(false));
                let lack = made.volume() + hole - 1.23;
                // A circle's cells end at its chords.
                let allowed = if hole > 0.0 { 4e-3 } else { 1e-13 };
                assert!(lack.abs() < allowed, "{off}: {lack}");
            }
        }
    }
}

/// A symmetric body between open sides, at any place on the lattice: no lift, and the same drag.
#[test]
fn slender_bodies_off_the_lattice_have_no_lift() {
    let diamond = [[0.0, 0.0], [0.5, -0.05], [1.0, 0.0], [0.5, 0.05]];
    let forces = [0.0, 0.18, 0.36, 0.5, 0.79].map(|off| {
        let spacing = 0.05;
        let shape = bodies::polygon(&diamond.map(Vector::<2>::from)).unwrap();
        let place = Placement::default().moved(Vector::<2>::new(0.0, off * spacing));
        let body: Arc<dyn Shape<2>> = Arc::new(Placed::new(shape, place));
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
