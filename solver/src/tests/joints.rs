//! Where solids meet, and on ridges: ghosts fill the corners, none twice, and show both faces.

use aero_geometry::{Placed, Placement, Shape, bodies};

use super::seam::body_on_the_lattice;
use super::*;

fn with_boxes(boxes: &[([f64; 2], [f64; 2])]) -> Problem<2> {
    let mut problem = cube::<2>(40, WALL);
    for ([x0, x1], [y0, y1]) in boxes {
        let shape = bodies::rectangle(x1 - x0, y1 - y0, 0.0).expect("a box");
        let middle = Vector::<2>::new(0.5 * (x0 + x1), 0.5 * (y0 + y1));
        let shape: Arc<dyn Shape<2>> =
            Arc::new(Placed::new(shape, Placement::default().moved(middle)));
        let body = body_on_the_lattice(&problem, shape);
        problem.bodies.push(body);
    }
    problem
}

/// Around any gas, walls and gas fill space evenly: the density read off the particles is the gas's own.
fn assert_even(problem: Problem<2>) {
    let mut simulation = start(problem);
    advance(&mut simulation, 3);
    for particle in &simulation.fluid {
        let error = (particle.density / 1.4 - 1.0).abs();
        let place = particle.position;
        assert!(error < 5e-3, "{} at {place:?}", particle.density);
        assert!(
            particle.velocity.norm() < 5e-3,
            "{} at {place:?}",
            particle.velocity
        );
    }
}

#[test]
fn gas_beside_a_box_on_or_through_a_wall_stays_at_rest() {
    for low in [0.0, -0.3] {
        assert_even(with_boxes(&[([1.5, 2.5], [low, 1.2])]));
    }
}

#[test]
fn gas_beside_boxes_that_touch_or_overlap_stays_at_rest() {
    assert_even(with_boxes(&[
        ([1.0, 1.8], [1.0, 2.0]),
        ([1.8, 2.9], [1.0, 2.5]),
    ]));
    assert_even(with_boxes(&[
        ([1.0, 2.1], [1.0, 2.0]),
        ([1.8, 2.9], [1.0, 2.5]),
    ]));
}

#[test]
fn ghosts_under_a_box_on_a_wall_face_the_gas() {
    let problem = with_boxes(&[([1.5, 2.5], [0.0, 1.2])]);
    let simulation = start(problem);
    let mut seen = 0.0;
    for ghost in simulation.walls.own() {
        let [x, y] = [ghost.position[0], ghost.position[1]];
        // Next to the left foot: nearer to the left face than to any other that gas is in front of.
        if (1.5..1.9).contains(&x) && (0.0..0.4).contains(&y) {
            seen += ghost.volume;
            assert!(
                (ghost.normal[0] + 1.0).abs() < 1e-9,
                "{:?} at {x} {y}",
                ghost.normal
            );
            assert!((ghost.depth - (x - 1.5)).abs() < 1e-9);
        }
    }
    // Those as near to the floor are parted; together they fill the corner.
    assert!((seen - 0.16).abs() < 1e-9, "{seen}");
}

#[test]
fn what_two_boxes_fill_counts_once() {
    let volume = |boxes: &[([f64; 2], [f64; 2])]| -> f64 {
        let simulation = start(with_boxes(boxes));
        let own = simulation.walls.own().iter();
        own.filter(|ghost| (ghost.body as usize) < boxes.len())
            .map(|ghost| ghost.volume)
            .sum()
    };
    let one = volume(&[([1.0, 1.8], [1.0, 1.8])]);
    let both = volume(&[([1.0, 1.8], [1.0, 1.8]), ([1.0, 1.8], [1.0, 1.8])]);
    assert!(
        (one - 0.64).abs() < 1e-12 && (both - one).abs() < 0.02,
        "{one} {both}"
    );
}

#[test]
fn a_ghost_in_the_middle_of_a_diamond_shows_all_four_faces() {
    let mut problem = cube::<2>(31, WALL);
    let at = |x: f64, y: f64| Vector::<2>::new(1.55 + x, 1.55 + y);
    let corners = [at(-1.0, 0.0), at(0.0, -0.35), at(1.0, 0.0), at(0.0, 0.35)];
    let diamond = bodies::polygon(&corners).expect("a diamond");
    let body = body_on_the_lattice(&problem, Arc::new(diamond));
    problem.bodies.push(body);
    crate::walls::part_ridges(&mut problem);
    let ghosts = &problem.bodies[0].ghosts;
    let middle =
        (0..ghosts.position.len()).filter(|&g| (ghosts.position[g] - at(0.0, 0.0)).norm() < 1e-9);
    let normals: Vec<Vector<2>> = middle.map(|g| ghosts.normal[g]).collect();
    let sum: Vector<2> = normals.iter().sum();
    assert!(normals.len() == 4 && sum.norm() < 1e-9, "{normals:?}");
}

#[test]
fn a_ghost_on_a_ridge_is_parted_and_keeps_its_volume() {
    let mut problem = with_boxes(&[([1.5, 2.5], [1.5, 2.5])]);
    let count = problem.bodies[0].ghosts.position.len();
    let volume: f64 = problem.bodies[0].ghosts.volume.iter().sum();
    crate::walls::part_ridges(&mut problem);
    let ghosts = &problem.bodies[0].ghosts;
    // Both diagonals, 20 ghosts, are as near to two faces.
    assert_eq!(ghosts.position.len(), count + 20);
    assert!((ghosts.volume.iter().sum::<f64>() - volume).abs() < 1e-12);
    let parted = (count..count + 20).all(|g| {
        let twin = (0..count).find(|&n| ghosts.position[n] == ghosts.position[g]);
        let twin = twin.expect("the ghost that was parted");
        ghosts.normal[g].dot(&ghosts.normal[twin]).abs() < 1e-9
            && ghosts.volume[g] == ghosts.volume[twin]
    });
    assert!(parted);
}
