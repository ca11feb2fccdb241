//! Liquids and their schemes: every law against the plain reference, and what must hold whatever the numbers.

use super::agreement::{Random, agree, array, matrix, world};
use super::reference::gas::{density, renormalise};
use super::reference::{Matrix, Point, liquids};
use super::seam::{Solver, instructions};
use super::*;
use crate::gas::{Liquid, Transport, Viscosity};
use crate::scheme::{Damping, PressureGradient};

const SOUND: f64 = 10.0;
const DENSITY: f64 = 1.4;

const SCHEMES: [Scheme; 5] = [
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
fn boxed<const D: usize>(scheme: Scheme, side: Side, viscosity: f64) -> Problem<D> {
    let mut problem = cube::<D>(10, side);
    problem.scheme = scheme;
    problem.gas = liquid(viscosity);
    problem.free_stream.pressure = 0.0;
    problem.disorder = 0.2;
    problem
}

/// What of `all` is in reach of `i`.
fn near<const D: usize>(i: &Point<D>, all: &[Point<D>]) -> Vec<Point<D>> {
    let is_near = |j: &&Point<D>| (i.position - j.position).norm() < 3.0 * f64::midpoint(i.h, j.h);
    all.iter().filter(is_near).copied().collect()
}

/// All that the reference knows of the gas after an evaluation: volumes, pressures, gradients, renormalisations.
fn known<const D: usize>(
    law: liquids::Liquid,
    solver: &Solver<D>,
    problem: &Problem<D>,
) -> super::reference::step::World<D> {
    let mut world = world(solver, problem);
    let ghosts = world.all_ghosts();
    let all = world.all_gas();
    for i in &mut world.gas {
        i.volume = i.mass / density(i, &near(i, &all), &near(i, &ghosts));
        i.pressure = law.pressure(i.density);
    }
    let all = world.all_gas();
    for (i, rates) in world.gas.iter_mut().zip(solver.rates()) {
        let found = renormalise(i, &near(i, &all), &near(i, &ghosts));
        let inverse = found.matrix.try_inverse().expect("a regular matrix");
        (i.renormalisation, i.density_gradient) = if law.pairwise {
            (Matrix::identity(), inverse * found.density_gradient)
        } else {
            (found.matrix, found.density_gradient)
        };
        i.shift = rates.shift;
    }
    let everything = [world.all_gas(), ghosts].concat();
    for i in &mut world.gas {
        i.strain = liquids::velocity_gradient(i, &near(i, &everything));
    }
    world
}

fn compare<const D: usize>(scheme: Scheme, side: Side, viscosity: f64) {
    let problem = boxed::<D>(scheme, side, viscosity);
    let law = liquids::Liquid {
        pairwise: scheme.operators.pressure == PressureGradient::Averaged,
        damped: scheme.operators.damping != Damping::None,
        sound: SOUND,
        density: DENSITY,
        viscosity,
    };
    let mut summed = None;
    for instructions in instructions() {
        let mut solver = Solver::new(problem.clone(), instructions);
        let mut random = Random::new();
        solver.set_gas(|_, point: &mut Point<D>| {
            point.velocity = random.vector();
            point.density = DENSITY * (1.0 + 0.05 * random.next());
        });
        solver.list();
        solver.evaluate();
        let (world, expected) = summed.get_or_insert_with(|| {
            let world = known(law, &solver, &problem);
            let (gas, ghosts) = (world.all_gas(), world.all_ghosts());
            let each = world.gas.iter();
            let each = each.map(|i| liquids::rate(law, i, &near(i, &gas), &near(i, &ghosts)));
            let expected: Vec<_> = each.collect();
            (world, expected)
        });
        let rates = solver.rates();
        let name = scheme.name;
        let matrices = solver.renormalisations();
        agree(
            &format!("{name}: renormalisation"),
            matrices.iter().map(|r| matrix(&r.matrix)),
            world.gas.iter().map(|i| matrix(&i.renormalisation)),
        );
        agree(
            &format!("{name}: velocity gradient"),
            rates.iter().map(|r| matrix(&r.velocity_gradient)),
            expected.iter().map(|r| matrix(&r.velocity_gradient)),
        );
        agree(
            &format!("{name}: acceleration"),
            rates.iter().map(|r| array(&r.acceleration)),
            expected.iter().map(|r| array(&r.acceleration)),
        );
        agree(
            &format!("{name}: acceleration by walls"),
            rates.iter().map(|r| array(&r.wall_acceleration)),
            expected.iter().map(|r| array(&r.wall_acceleration)),
        );
        agree(
            &format!("{name}: rate of density"),
            rates.iter().map(|r| [r.density]),
            expected.iter().map(|r| [r.density]),
        );
        if scheme.transport_velocity.at_rest {
            agree(
                "drift of particles at rest",
                rates.iter().map(|r| array(&r.shift)),
                solver.gas().iter().map(|i| array(&-i.velocity)),
            );
        }
    }
}

/// Beside walls, and rubbed in a box without.
fn agrees(scheme: Scheme) {
    compare::<1>(scheme, WALL, 0.0);
    compare::<2>(scheme, WALL, 0.0);
    compare::<2>(scheme, Side::Periodic, 0.3);
}

#[test]
fn density_evolved_is_that_of_the_reference() {
    agrees(Scheme::L_IPST_C);
}

#[test]
fn pressure_evolved_is_that_of_the_reference() {
    agrees(Scheme::PE_IPST_C);
    compare::<3>(Scheme::PE_IPST_C, Side::Periodic, 0.3);
}

#[test]
fn a_transport_velocity_is_that_of_the_reference() {
    agrees(Scheme::TV_C);
}

#[test]
fn what_passes_particles_at_rest_is_that_of_the_reference() {
    agrees(Scheme::E_C);
}

#[test]
fn means_of_pairs_are_those_of_the_reference() {
    agrees(Scheme::EDAC);
    compare::<3>(Scheme::EDAC, Side::Periodic, 0.3);
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
    [error, least / simulation.problem.spacing.powi(2)]
}

#[test]
fn iterative_shifting_evens_particles_out_and_leaves_the_flow_in_place() {
    let mut problem = boxed::<2>(Scheme::L_IPST_C, Side::Periodic, 0.0);
    problem.spacing = 1.0 / 32.0;
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

/// A sound wave in a box that holds it once, a period later: what it has grown by.
#[test]
fn sound_comes_back_after_a_period_in_each_scheme() {
    for scheme in SCHEMES
        .into_iter()
        .chain([Scheme::CONSERVATIVE.of_liquid()])
    {
        let mut problem = boxed::<1>(scheme, Side::Periodic, 0.0);
        problem.spacing = 0.01;
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

/// A wall that leaves a linear liquid draws it out by a simple wave, `u = c ln(rho / rho_0)`: the pressure falls below zero.
#[test]
fn a_liquid_is_drawn_on_by_a_wall_that_leaves_it() {
    for scheme in [Scheme::L_IPST_C, Scheme::TV_C] {
        let mut problem = boxed::<1>(scheme, WALL, 0.0);
        problem.disorder = 0.0;
        problem.spacing = 0.01;
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
