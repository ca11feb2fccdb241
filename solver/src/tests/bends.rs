//! Ghosts of a round body that turns and speeds up: bend, Coriolis, mirrors and friction, against the reference.

use aero_geometry::{Placed, Placement, bodies};
use nalgebra::Vector3;

use super::agreement::compare;
use super::reference::Matrix;
use super::seam::{DEFAULT, PUBLISHED, Setup, Solver, body_on_the_lattice, instructions, turn};
use super::*;
use crate::problem::{NoSlip, Slide};

const RADIUS: f64 = 0.6;

/// A cylinder in the middle of a box of disordered gas.
fn cylinder(wall: WallKind) -> Problem<2> {
    let mut problem = cube::<2>(22, WALL);
    problem.disorder = 0.2;
    let centre = problem.domain.bounds.max * 0.5;
    let circle = bodies::circle(RADIUS).expect("a circle");
    let shape = Placed::new(circle, Placement::default().moved(centre));
    let mut body = body_on_the_lattice(&problem, Arc::new(shape));
    body.wall = wall;
    let motion = [Vector::<2>::new(0.3, -0.2), Vector::<2>::new(0.8, 0.5)];
    turn(&mut body, Vector3::new(0.0, 0.0, 1.7), centre, motion);
    problem.bodies.push(body);
    problem
}

#[test]
fn ghosts_of_a_turning_cylinder_show_what_the_reference_shows() {
    for setup in [
        DEFAULT,
        Setup {
            mirrors: true,
            ..DEFAULT
        },
        Setup {
            shield: true,
            ..PUBLISHED
        },
    ] {
        for wall in [WallKind::Slip, WallKind::STICKY] {
            compare(setup, &cylinder(wall));
        }
    }
}

#[test]
fn the_wall_of_a_turning_cylinder_bends_and_moves_as_a_rigid_circle() {
    for (setup, bend) in [(DEFAULT, 1.0 / RADIUS), (PUBLISHED, 0.0)] {
        let problem = setup.of(cylinder(WallKind::Slip));
        let centre = problem.domain.bounds.max * 0.5;
        let solver = Solver::new(problem, instructions()[0]);
        let ghosts = solver.ghosts();
        let mut seen = 0;
        for ghost in ghosts.iter().filter(|ghost| ghost.body == 0) {
            let radial = ghost.point.position - centre;
            if radial.norm() < 0.1 {
                continue;
            }
            seen += 1;
            let (n, t) = (
                radial.normalize(),
                Vector::<2>::new(-radial[1], radial[0]).normalize(),
            );
            assert!((ghost.normal - n).norm() < 1e-9);
            let exact: Matrix<2> = t * t.transpose() * bend;
            assert!(
                (ghost.curvature - exact).norm() < 0.01,
                "{}",
                ghost.curvature
            );
            let velocity = Vector::<2>::new(0.3, -0.2) + t * (1.7 * RADIUS);
            assert!((ghost.surface_velocity - velocity).norm() < 1e-9);
            let acceleration = Vector::<2>::new(0.8, 0.5) - n * (1.7 * 1.7 * RADIUS);
            assert!((ghost.surface_acceleration - acceleration).norm() < 1e-9);
        }
        assert!(seen > 80, "{seen} ghosts");
    }
}

/// Gas that circles with a turning body, `u = w x r`, is at rest in the body's frame; gas at rest, which the body turns
/// under, is not accelerated at all: the wall's centripetal acceleration, Coriolis and the bend cancel there,
/// `R w^2 n - 2 w u_t + u_t^2 / R = 0` for `u_t = -w R` on the wall.
#[test]
fn gas_at_rest_around_a_turning_cylinder_stays_at_one_pressure() {
    let mut problem = cylinder(WallKind::Slip);
    problem.disorder = 0.0;
    let centre = problem.domain.bounds.max * 0.5;
    let still = [Vector::<2>::zeros(); 2];
    turn(
        &mut problem.bodies[0],
        Vector3::new(0.0, 0.0, 1.7),
        centre,
        still,
    );
    let mut solver = Solver::new(DEFAULT.of(problem), instructions()[0]);
    solver.list();
    solver.evaluate();
    let off = |ghost: &reference::Wall<2>| (ghost.point.pressure - 1.0).abs();
    let furthest = solver.ghosts().iter().map(off).fold(0.0, f64::max);
    assert!(furthest < 5e-3, "the pressure is off by {furthest}");
}

/// Gas that circles as a rigid body, `u = w r`, is not strained. Its mirror image `u = w (2 R - r)` is: `r d(u / r)/dr / 2 = -w` at the wall.
#[test]
fn ghosts_beneath_gas_that_circles_a_cylinder_show_the_strain_of_their_own_velocities() {
    const RATE: f64 = 0.4;
    let mut problem = cylinder(WallKind::Slip);
    problem.disorder = 0.0;
    let centre = problem.domain.bounds.max * 0.5;
    let still = [Vector::<2>::zeros(); 2];
    turn(&mut problem.bodies[0], Vector3::zeros(), centre, still);
    problem.initial = Initial::Field(Field(Arc::new(move |position: &Vector<2>| {
        let arm = position - centre;
        State {
            density: 1.4,
            velocity: Vector::<2>::new(-arm[1], arm[0]) * RATE,
            pressure: 1.0,
        }
    })));
    let mut solver = Solver::new(DEFAULT.of(problem), instructions()[0]);
    solver.list();
    solver.evaluate();
    let mut seen = 0;
    for ghost in solver.ghosts() {
        if ghost.body != 0 || ghost.depth > 0.06 {
            continue;
        }
        seen += 1;
        let n = ghost.normal;
        let shear = Vector::<2>::new(-n[1], n[0]).dot(&(ghost.point.strain * n));
        assert!((shear / RATE + 1.0).abs() < 0.25, "{shear} for {}", -RATE);
    }
    assert!(seen > 20, "{seen} ghosts");
}

/// What gas that sticks feels of a round surface that slides around is what it feels of a body that turns.
#[test]
fn a_surface_that_slides_around_moves_as_that_of_a_body_that_turns() {
    const RATE: f64 = 1.7;
    let surface = |slides: bool| {
        let rate = if slides { RATE } else { 0.0 };
        let mut problem = cylinder(WallKind::STICKY);
        let centre = problem.domain.bounds.max * 0.5;
        let body = &mut problem.bodies[0];
        body.wall = WallKind::NoSlip(NoSlip {
            slide: Slide {
                turning: [0.0, 0.0, rate],
                pivot: [centre[0], centre[1], 0.0],
                ..Slide::default()
            },
            ..NoSlip::default()
        });
        body.motion = Motion::none();
        if !slides {
            turn(
                body,
                Vector3::new(0.0, 0.0, RATE),
                centre,
                [Vector::zeros(); 2],
            );
        }
        let simulation = start(problem);
        let ghosts = simulation.walls.own();
        let cylinder = ghosts.iter().filter(|ghost| ghost.body == 0);
        cylinder
            .map(|ghost| ghost.wall.velocity + ghost.wall.slide)
            .collect::<Vec<_>>()
    };
    let [slides, turns] = [true, false].map(surface);
    assert!(slides.len() > 100 && slides.len() == turns.len());
    for (slides, turns) in slides.iter().zip(&turns) {
        assert!((slides - turns).norm() < 1e-12, "{slides} {turns}");
        assert!((slides.norm() / (RATE * RADIUS) - 1.0).abs() < 1e-6);
    }
}
