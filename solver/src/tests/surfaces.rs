//! What bodies and sides report: pressure coefficients, forces and moments of bodies that planes cut, and gas from a reservoir.

use aero_geometry::{Placed, Placement, bodies};

use super::seam::{DEFAULT, Solver, body_on_the_lattice, instructions};
use super::*;

#[test]
fn a_wall_under_more_than_the_free_streams_pressure_has_a_positive_coefficient() {
    for (pressure, expected) in [(3.8, 1.0), (0.3, -0.25)] {
        let mut problem = cube::<2>(8, WALL);
        // Dynamic pressure 2.8.
        problem.free_stream.velocity[0] = 2.0;
        problem.initial = Initial::Field(Field(Arc::new(move |_| State {
            density: 1.4,
            velocity: Vector::zeros(),
            pressure,
        })));
        let surface = start(problem).surface();
        let mut seen = 0;
        for (number, place) in surface.position.iter().enumerate() {
            // Behind a corner there is no gas.
            if !place[..2].iter().any(|&x| x > 0.01 && x < 0.79) {
                continue;
            }
            seen += 1;
            let found = surface.pressure[number];
            let coefficient = surface.pressure_coefficient[number];
            assert!((found - pressure).abs() < 1e-9, "pressure {found}");
            let error = coefficient - expected;
            assert!(error.abs() < 1e-9, "coefficient {coefficient}");
        }
        assert_eq!(seen, 4 * 8);
    }
}

/// A square in gas whose flow is symmetric about `y = 3`, whole or above a symmetry plane there; moments refer to a point off
/// the plane.
fn square(is_half: bool) -> Problem<2> {
    let mut problem = cube::<2>(30, WALL);
    problem.domain.bounds.min = Vector::<2>::new(0.0, 1.5);
    problem.domain.bounds.max = Vector::<2>::new(3.0, 4.5);
    let shape = bodies::rectangle(1.2, 1.4, 0.0).expect("a square");
    let place = Placement::default().moved(Vector::<2>::new(1.43, 3.0));
    if is_half {
        problem.domain.bounds.min[1] = 3.0;
        problem.domain.sides[1][0] = Side::Symmetry;
    }
    let mut body = body_on_the_lattice(&problem, Arc::new(Placed::new(shape, place)));
    body.moment_centre = Vector::<2>::new(0.3, 0.7);
    problem.bodies.push(body);
    problem.initial = Initial::Field(Field(Arc::new(|position: &Vector<2>| State {
        density: 1.4,
        velocity: Vector::<2>::new(0.4, 0.3 * (position[1] - 3.0)),
        pressure: 1.0 + 0.3 * position[0] + 0.1 * (position[1] - 3.0).powi(2),
    })));
    problem
}

#[test]
fn a_body_cut_by_a_plane_has_the_force_and_the_moment_of_the_whole() {
    let [whole, half] = [false, true].map(|is_half| {
        let mut simulation = start(square(is_half));
        advance(&mut simulation, 10);
        simulation.loads()[0]
    });
    // The drag is `F`; it passes 2.3 above the centre.
    let drag = whole.force[0];
    assert!(drag.abs() > 0.1, "drag {drag}");
    assert!((whole.moment[2] + 2.3 * drag).abs() < 1e-9, "{whole:?}");
    for k in 0..3 {
        assert!(
            (whole.force[k] - half.force[k]).abs() < 1e-9,
            "{whole:?} {half:?}"
        );
        assert!(
            (whole.moment[k] - half.moment[k]).abs() < 1e-9,
            "{whole:?} {half:?}"
        );
    }
}

/// A reservoir at the free stream's stagnation state, upstream of the free stream itself: nothing has to change.
#[test]
fn gas_from_a_reservoir_enters_as_the_stream_that_it_feeds() {
    for speed in [0.2, 0.6] {
        let mut problem = cube::<2>(12, Side::Symmetry);
        problem.domain.sides[0] = [Side::Reservoir { relaxation: None }, Side::Outlet];
        problem.free_stream.velocity[0] = speed;
        let mut solver = Solver::new(DEFAULT.of(problem), instructions()[0]);
        for _ in 0..3 {
            solver.step();
        }
        let entering = solver.buffers();
        let mut seen = 0;
        for point in entering.iter().filter(|point| point.position[0] < 0.0) {
            seen += 1;
            assert!((point.pressure - 1.0).abs() < 1e-10, "{}", point.pressure);
            assert!((point.density - 1.4).abs() < 1e-10, "{}", point.density);
            assert!(
                (point.velocity[0] - speed).abs() < 1e-10,
                "{}",
                point.velocity
            );
        }
        assert!(seen > 60, "{seen} particles of the reservoir");
    }
}
