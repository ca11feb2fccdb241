//! Bodies that the gas moves: what they get is what the gas loses.

use std::sync::Arc;

use aero_geometry::{Placed, Placement, Shape, Vector, bodies};
use nalgebra::Matrix3;

use super::seam::problems::body_on_the_lattice;
use super::{advance, cube, start};
use crate::Simulation;
use crate::problem::{Field, Freedom, Initial, Problem, Side, State};

/// A heavy square in a periodic box, askew, and gas that blows at it from one corner.
fn square_in_the_wind() -> Problem<2> {
    let mut problem = cube::<2>(40, Side::Periodic);
    let shape = bodies::rectangle(1.0, 1.0, 0.0).expect("a square");
    let middle = Vector::<2>::new(2.03, 1.96);
    let place = Placement::default().rotated(0.3).moved(middle);
    let shape: Arc<dyn Shape<2>> = Arc::new(Placed::new(shape, place));
    let mut body = body_on_the_lattice(&problem, shape);
    body.moment_centre = Vector::<2>::new(2.4, 1.7);
    body.motion.pivot = middle;
    body.motion.free = Some(Freedom {
        mass: 3.0,
        inertia: Matrix3::identity() * 0.4,
        is_held: [false, false, true],
        keeps_turn: [true, true, false],
    });
    problem.bodies.push(body);
    let wave = std::f64::consts::TAU / problem.domain.bounds.max[0];
    problem.initial = Initial::Field(Field(Arc::new(move |position: &Vector<2>| State {
        density: 1.4,
        velocity: Vector::<2>::new(0.4, 0.2) * (1.0 + 0.5 * (wave * position[1]).cos()),
        pressure: 1.0 + 0.2 * (wave * position[0]).sin(),
    })));
    problem
}

/// Momentum of the gas, and of all.
fn momenta(simulation: &Simulation<2>) -> [Vector<2>; 2] {
    let gas = simulation.fluid.iter();
    let gas: Vector<2> = gas.map(|particle| particle.velocity * particle.mass).sum();
    let pose = simulation.pose(0);
    let freedom = simulation.problem.bodies[0].motion.free.as_ref();
    let mass = freedom.expect("a free body").mass;
    [gas, gas + pose.velocity(&pose.pivot()) * mass]
}

#[test]
fn gas_and_body_keep_their_momentum_to_round_off() {
    // At rest, and so fast that the wall catches up with gas, which is sent back.
    for speed in [0.0, 2.5] {
        let mut problem = square_in_the_wind();
        problem.bodies[0].motion.velocity[0] = speed;
        let mut simulation = start(problem);
        let [gas, all] = momenta(&simulation);
        for _ in 0..30 {
            advance(&mut simulation, 1);
            let [_, now] = momenta(&simulation);
            assert!((now - all).norm() < 1e-12 * all.norm(), "{now} {all}");
        }
        let [gas_now, _] = momenta(&simulation);
        assert!((gas_now - gas).norm() > 0.02 * gas.norm(), "nothing moves");
        assert!(simulation.pose(0).turn()[2].abs() > 1e-4, "nothing turns");
        let returned = simulation.books.extremes.returned;
        assert!(returned > 0 || speed == 0.0, "nothing is sent back");
    }
}

/// What the gas pushes with goes through the middle of the body's own pressure: turning it about another point than its centre
/// would show as a moment of the gas's impulse.
#[test]
fn gas_and_body_keep_their_angular_momentum_in_a_wide_box() {
    let mut problem = square_in_the_wind();
    problem.initial = Initial::Field(Field(Arc::new(|position: &Vector<2>| {
        let arm = position - Vector::<2>::new(2.0, 2.0);
        let near = (-2.0 * (arm.norm() - 0.9).powi(2) / 0.09).exp();
        State {
            density: 1.4,
            velocity: Vector::<2>::new(-arm[1], arm[0]) * (0.5 * near),
            pressure: 1.0,
        }
    })));
    let mut simulation = start(problem);
    let spin = |simulation: &Simulation<2>| {
        let cross = |r: Vector<2>, p: Vector<2>| r[0] * p[1] - r[1] * p[0];
        let gas = simulation.fluid.iter();
        let gas: f64 = gas.map(|p| cross(p.position, p.velocity * p.mass)).sum();
        let pose = simulation.pose(0);
        let velocity = pose.velocity(&pose.pivot());
        [
            0.4 * pose.angular_velocity()[2],
            gas + cross(pose.pivot(), velocity * 3.0),
        ]
    };
    let before = spin(&simulation);
    advance(&mut simulation, 60);
    let [body, rest] = spin(&simulation);
    let drift = body + rest - before[1];
    assert!(body.abs() > 1e-3, "the gas drags it round: {body}");
    assert!(drift.abs() < 0.05 * body.abs(), "{body} {drift}");
}

#[test]
fn the_point_that_moments_refer_to_is_of_no_matter() {
    let turned = |centre: Vector<2>| {
        let mut problem = square_in_the_wind();
        problem.bodies[0].moment_centre = centre;
        let mut simulation = start(problem);
        advance(&mut simulation, 20);
        simulation.pose(0).turn()[2]
    };
    let [near, far] = [[2.03, 1.96], [2.4, -7.0]].map(|centre| turned(centre.into()));
    assert!((near - far).abs() < 1e-12, "{near} {far}");
}

#[test]
fn a_free_body_goes_on_from_a_memory_with_the_same_bits() {
    let mut straight = start(square_in_the_wind());
    advance(&mut straight, 12);
    let mut resumed = start(square_in_the_wind());
    advance(&mut resumed, 5);
    let problem = square_in_the_wind();
    resumed = Simulation::resume(problem, resumed.memory()).expect("the same problem");
    advance(&mut resumed, 7);
    assert_eq!(straight.walls.free(), resumed.walls.free());
    let velocities = |of: &Simulation<2>| of.fluid.iter().map(|p| p.velocity).collect::<Vec<_>>();
    assert_eq!(velocities(&straight), velocities(&resumed));
}

#[test]
fn a_body_that_comes_too_near_to_another_stops_the_run() {
    let mut problem = square_in_the_wind();
    problem.bodies[0].motion.velocity = Vector::<2>::new(1.5, 0.0);
    let post = bodies::rectangle(0.4, 3.0, 0.0).expect("a post");
    let place = Placement::default().moved(Vector::<2>::new(3.3, 2.0));
    let post: Arc<dyn Shape<2>> = Arc::new(Placed::new(post, place));
    let post = body_on_the_lattice(&problem, post);
    problem.bodies.push(post);
    problem.bodies[1].name = "post".into();
    let mut simulation = start(problem);
    let failure = loop {
        match simulation.step(f64::INFINITY) {
            Ok(_) => assert!(simulation.time() < 1.0, "it went through"),
            Err(failure) => break failure,
        }
    };
    let text = failure.to_string();
    assert!(text.contains("body `body` touches body `post`"), "{text}");
    assert!((failure.position[0] - 3.0).abs() < 0.15, "{text}");
    let mut near = square_in_the_wind();
    near.domain.sides[0] = [super::WALL; 2];
    near.domain.bounds.max[0] = 2.67;
    let refused = Simulation::new(near).map(|_| ());
    let refused = refused.expect_err("there is no room");
    assert!(refused.contains("the side x_max"), "{refused}");
}
