use super::seam::{Solver, instructions};
use super::*;
use crate::problem::Resolution;

/// A tube closed on the left by a piston that accelerates into gas of `c = 1`.
fn piston(extrapolation: Extrapolation, velocity: f64, acceleration: f64) -> Problem<1> {
    let mut problem = cube::<1>(200, WALL);
    problem.resolution = Resolution::uniform(0.01);
    problem.domain.bounds.max[0] = 2.0;
    problem.domain.sides[0][0] = Side::Wall {
        kind: WallKind::Slip,
        velocity,
        acceleration,
    };
    problem.scheme.wall.extrapolation = extrapolation;
    problem
}

/// Pressure on an accelerating piston: a simple wave carries `p = (1 + (g-1)/2 u/c)^(2g/(g-1))`
/// off a piston at speed `u = a t` until a shock forms at `t = 2 c / ((g+1) a)` [Courant &
/// Friedrichs 1948].
fn simple_wave_pressure(speed: f64) -> f64 {
    (1.0 + 0.2 * speed).powf(7.0)
}

#[test]
fn an_accelerating_piston_feels_the_pressure_of_a_simple_wave() {
    // With mirrors, what parts at the wall dissipates most: 1.6 % at this spacing, 0.7 at half of it.
    for (extrapolation, allowed) in [(Extrapolation::Wom, 0.01), (Extrapolation::Wm, 0.02)] {
        for acceleration in [1.0, -1.0] {
            let mut simulation = start(piston(extrapolation, 0.0, acceleration));
            advance_to(&mut simulation, 0.6);
            let force = simulation.loads()[0].force[0];
            // The load belongs to the middle of the last step.
            let exact = simple_wave_pressure(acceleration * 0.6);
            let error = (-force / exact - 1.0).abs();
            assert!(error < allowed, "{extrapolation:?}: {} for {exact}", -force);
        }
    }
}

/// Gas that leaves a mirror at 0.625 c, or that a piston leaves at that speed, expands to `rho (1 - (g-1)/2 u/c)^5` [Courant & Friedrichs
/// 1948]. Where nothing dissipates in the fan it undershoots behind the tail by 5.6 %.
#[test]
fn a_fan_that_springs_from_a_side_undershoots_by_less_than_five_per_cent() {
    let speed = 0.625;
    let mut leaving = piston(Extrapolation::Wom, 0.0, 0.0);
    leaving.domain.sides[0][0] = Side::Symmetry;
    leaving.initial = Initial::Field(Field(Arc::new(move |_: &Vector<1>| State {
        density: 1.4,
        velocity: Vector::<1>::new(speed),
        pressure: 1.0,
    })));
    let receding = piston(Extrapolation::Wom, -speed, 0.0);
    for (problem, wall) in [(leaving, 0.0), (receding, -0.8 * speed)] {
        let mut simulation = start(problem);
        advance_to(&mut simulation, 0.8);
        // The tail is 0.7 off the side.
        let behind = |particle: &&crate::particles::Particle<1>| {
            (0.1..0.65).contains(&(particle.position[0] - wall))
        };
        let densities = simulation.fluid.iter().filter(behind).map(|p| p.density);
        let least = densities.fold(f64::INFINITY, f64::min);
        let off = least / (1.4 * 0.875_f64.powi(5)) - 1.0;
        assert!((-0.05..-0.01).contains(&off), "{off} at {wall}");
    }
}

/// Gas that leaves a wall at a speed that grows with the distance, as it does beside a bent wall and in a fan. Mirrored as Shepard's sum reads it, nearer to the wall than they are deep,
/// ghosts would show the deeper ones three fifths of it.
#[test]
fn ghosts_show_what_goes_across_a_wall_as_deep_as_they_are() {
    const RATE: f64 = 0.3;
    for extrapolation in [Extrapolation::Wom, Extrapolation::Wm] {
        let mut problem = cube::<2>(20, Side::Periodic);
        problem.domain.sides[1] = [WALL, Side::Outlet];
        problem.scheme.wall.extrapolation = extrapolation;
        problem.initial = Initial::Field(Field(Arc::new(|place: &Vector<2>| State {
            density: 1.4,
            velocity: Vector::<2>::new(0.2, RATE * place[1]),
            pressure: 1.0,
        })));
        let mut solver = Solver::new(problem, instructions()[0]);
        solver.list();
        // The rate of strain is that of the evaluation before.
        solver.evaluate();
        solver.evaluate();
        // The deepest layer sees no gas.
        for ghost in solver.ghosts().iter().filter(|ghost| ghost.depth < 0.4) {
            let [along, across] = ghost.point.velocity.into();
            let expected = -RATE * ghost.depth;
            assert!((along - 0.2).abs() < 1e-12, "{extrapolation:?}: {along}");
            assert!(
                (across / expected - 1.0).abs() < 0.1,
                "{extrapolation:?}: {across} for {expected}"
            );
        }
    }
}

#[test]
fn a_moving_piston_does_the_work_that_the_gas_gains() {
    let mut simulation = start(piston(Extrapolation::Wom, 0.5, 0.0));
    let before = simulation.totals();
    advance_to(&mut simulation, 0.6);
    let (after, received) = (simulation.totals(), simulation.inflow());
    let gained = after.energy - before.energy;
    assert!(gained > 0.1);
    assert!(
        (gained / received.energy - 1.0).abs() < 0.01,
        "{gained} for {}",
        received.energy
    );
    let momentum = after.momentum[0] - before.momentum[0];
    assert!((momentum - received.momentum[0]).abs() < 1e-12);
}
