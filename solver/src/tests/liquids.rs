//! Liquids and their schemes: what must hold whatever the numbers.

use super::seam::Solver;
use super::*;
use crate::gas::{Liquid, Transport, Viscosity};
use crate::problem::Resolution;

pub const SOUND: f64 = 10.0;
pub const DENSITY: f64 = 1.4;

pub const SCHEMES: [Scheme; 5] = [
    Scheme::L_IPST_C,
    Scheme::PE_IPST_C,
    Scheme::TV_C,
    Scheme::E_C,
    Scheme::EDAC,
];

fn liquid(viscosity: f64) -> Gas {
    Gas::Liquid(Liquid {
        sound_speed: SOUND,
        density: DENSITY,
        pressure: 0.0,
        exponent: 1.0,
        transport: (viscosity > 0.0).then_some(Transport {
            viscosity: Viscosity::Constant(viscosity),
            prandtl: 1.0,
        }),
    })
}

/// A disordered box of it.
pub fn boxed<const D: usize>(scheme: Scheme, side: Side, viscosity: f64) -> Problem<D> {
    let mut problem = cube::<D>(10, side);
    problem.scheme = scheme;
    problem.gas = liquid(viscosity);
    problem.free_stream.pressure = 0.0;
    problem.disorder = 0.2;
    problem
}

#[test]
fn particles_at_rest_do_not_move_at_all() {
    let mut problem = boxed::<2>(Scheme::E_C, Side::Periodic, 0.01);
    problem.initial = Initial::Field(Field(Arc::new(swirl)));
    let mut simulation = start(problem);
    let places = |simulation: &Simulation<2>| {
        let mut all: Vec<_> = simulation
            .fluid
            .iter()
            .map(|p| (p.id, p.position))
            .collect();
        all.sort_by_key(|(id, _)| *id);
        all
    };
    let before = places(&simulation);
    advance(&mut simulation, 20);
    assert_eq!(before, places(&simulation));
}

/// Vortices in a box of one, slow against sound.
fn swirl(position: &Vector<2>) -> State<2> {
    let [x, y] = [0, 1].map(|k| std::f64::consts::TAU * position[k]);
    State {
        density: DENSITY,
        velocity: Vector::<2>::new(x.sin() * y.cos(), -x.cos() * y.sin()),
        pressure: 0.0,
    }
}

/// Mean error of the velocity, and the least room of a particle over its share.
fn disorder_of(simulation: &Simulation<2>) -> [f64; 2] {
    let gas = &simulation.fluid;
    let errors = gas
        .iter()
        .map(|p| (p.velocity - swirl(&p.position).velocity).norm());
    let error = errors.sum::<f64>() / gas.len() as f64;
    let near = &simulation.around.records.near[..gas.len()];
    let least = near.iter().map(|near| near.volume).fold(1.0, f64::min);
    [
        error,
        least / simulation.problem.resolution.lattice().powi(2),
    ]
}

#[test]
fn iterative_shifting_evens_particles_out_and_leaves_the_flow_in_place() {
    let mut problem = boxed::<2>(Scheme::L_IPST_C, Side::Periodic, 0.0);
    problem.resolution = Resolution::uniform(1.0 / 32.0);
    problem.domain.bounds.max = Vector::repeat(1.0);
    let mut simulation = start(problem);
    for particle in &mut simulation.fluid {
        particle.velocity = swirl(&particle.position).velocity;
    }
    let [_, crowded] = disorder_of(&simulation);
    for _ in 0..4 {
        let Simulation {
            problem,
            fluid,
            buffers,
            walls,
            around,
            ..
        } = &mut simulation;
        crate::iterative_shifting::even_out(problem, 0.0, fluid, buffers, walls, around);
    }
    let [error, least] = disorder_of(&simulation);
    assert!(crowded < 0.93, "the start is even: {crowded}");
    assert!(least > 0.97, "some have {least} of their share");
    // Particles went up to a tenth of a spacing, over which the velocity changes by up to two per cent.
    assert!(error < 2e-3, "the flow is off by {error}");
}

/// One particle of a liquid at rest goes into a wall at half the speed of sound: how often it was sent back, and its height over the wall.
fn sent_back(scheme: Scheme) -> (u64, f64) {
    let mut problem = boxed::<2>(scheme, WALL, 0.0);
    problem.disorder = 0.0;
    let mut simulation = start(problem);
    let middle = Vector::<2>::new(0.5, 0.0);
    let away = |at: &Vector<2>| (at - middle).norm();
    let nearest = simulation
        .fluid
        .iter()
        .min_by(|a, b| away(&a.position).total_cmp(&away(&b.position)));
    let id = nearest.expect("liquid").id;
    for particle in &mut simulation.fluid {
        if particle.id == id {
            particle.position[1] = 0.002;
            particle.velocity[1] = -0.5 * SOUND;
        }
    }
    advance(&mut simulation, 1);
    let one = simulation.fluid.iter().find(|particle| particle.id == id);
    let height = one.expect("the particle").position[1];
    (simulation.books.extremes.returned, height)
}

#[test]
fn walls_send_back_what_a_step_has_carried_into_them() {
    for scheme in SCHEMES
        .into_iter()
        .filter(|scheme| !scheme.transport_velocity.at_rest)
    {
        let (returned, height) = sent_back(scheme);
        assert!(
            returned == 1 && height > 0.0,
            "{}: {returned}, {height}",
            scheme.name
        );
    }
    let (returned, height) = sent_back(Scheme::PAPER.of_liquid());
    assert!(
        returned == 0 && height < 0.0,
        "as printed: {returned}, {height}"
    );
}

/// A sound wave in a box that holds it once, a period later: what it has grown by.
#[test]
fn sound_comes_back_after_a_period_in_each_scheme() {
    for scheme in SCHEMES
        .into_iter()
        .chain([Scheme::CONSERVATIVE.of_liquid()])
    {
        let mut problem = boxed::<1>(scheme, Side::Periodic, 0.0);
        problem.resolution = Resolution::uniform(0.01);
        problem.domain.bounds.max = Vector::repeat(1.0);
        problem.disorder = 0.0;
        let wave = |x: f64| 1e-3 * (std::f64::consts::TAU * x).sin();
        problem.initial = Initial::Field(Field(Arc::new(move |position: &Vector<1>| State {
            density: DENSITY * (1.0 + wave(position[0])),
            velocity: Vector::<1>::new(SOUND * wave(position[0])),
            pressure: SOUND * SOUND * DENSITY * wave(position[0]),
        })));
        let mut simulation = start(problem);
        advance_to(&mut simulation, 1.0 / SOUND);
        let errors = simulation
            .fluid
            .iter()
            .map(|p| (p.velocity[0] / SOUND - wave(p.position[0])).abs());
        let worst = errors.fold(0.0, f64::max) / 1e-3;
        assert!(worst < 0.03, "{}: off by {worst}", scheme.name);
    }
}

/// A disordered liquid at rest in a closed box; its pressure is two, and rises by so much along the first axis.
fn loaded(scheme: Scheme, rise: f64) -> Solver<2> {
    let mut problem = boxed::<2>(scheme, WALL, 0.0);
    problem.initial = Initial::Field(Field(Arc::new(move |position: &Vector<2>| {
        let pressure = 2.0 + rise * position[0];
        State {
            density: DENSITY + pressure / (SOUND * SOUND),
            velocity: Vector::zeros(),
            pressure,
        }
    })));
    let mut solver = Solver::new(problem, pulp::Arch::new());
    solver.list();
    solver.evaluate();
    solver
}

/// Differences of pressures leave out what is the same on both sides of a pair; a wall bears it all the same.
#[test]
fn walls_bear_the_pressure_of_the_liquid_in_each_scheme() {
    for scheme in SCHEMES {
        let loads = loaded(scheme, 0.0).loads();
        for (side, (load, exact)) in loads.iter().zip([-2.0, 2.0, -2.0, 2.0]).enumerate() {
            let force = load.force[side / 2];
            let error = (force / exact - 1.0).abs();
            assert!(error < 0.1, "{} on {side}: {force}", scheme.name);
        }
    }
}

/// What pairs share alike is lost nowhere; by differences it is what the walls bear that the books have.
#[test]
fn what_walls_give_the_liquid_is_minus_what_they_bear() {
    for scheme in SCHEMES {
        let solver = loaded(scheme, 3.0);
        let (received, loads) = (solver.received(1.0), solver.loads());
        for axis in 0..2 {
            let borne: f64 = loads.iter().map(|load| load.force[axis]).sum();
            let given = received.momentum[axis];
            assert!(
                (borne + given).abs() < 1e-12,
                "{}: {given} for {borne}",
                scheme.name
            );
        }
    }
}

/// A wall that leaves a linear liquid draws it out by a simple wave, `u = c ln(rho / rho_0)`: the pressure falls below zero.
#[test]
fn a_liquid_is_drawn_on_by_a_wall_that_leaves_it() {
    for scheme in [Scheme::L_IPST_C, Scheme::TV_C] {
        let mut problem = boxed::<1>(scheme, WALL, 0.0);
        problem.disorder = 0.0;
        problem.resolution = Resolution::uniform(0.01);
        problem.domain.bounds.max = Vector::repeat(1.0);
        problem.domain.sides[0][0] = Side::Wall {
            kind: WallKind::Slip,
            velocity: 0.0,
            acceleration: -20.0,
        };
        let mut simulation = start(problem);
        for time in [0.005, 0.01, 0.02, 0.04] {
            advance_to(&mut simulation, time);
            let force = simulation.loads()[0].force[0];
            let exact = SOUND * SOUND * DENSITY * ((-20.0 * time / SOUND).exp() - 1.0);
            let error = (-force - exact).abs() / exact.abs();
            assert!(
                error < 0.05,
                "{} at {time}: {} for {exact}",
                scheme.name,
                -force
            );
        }
    }
}
