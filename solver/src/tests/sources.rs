//! What a problem adds to the equations, by all integrators.

use super::*;
use crate::fixed::FixedSimulation;
use crate::frame::Load;
use crate::method::{FixedPoints, Method, Time};
use crate::problem::{Added, BodyForce, Resolution, Source};

const END: f64 = 0.1;
const PUSH: [f64; 2] = [3.0, -2.0];
const HEAT: f64 = 5.0;
const INFLOW: f64 = 4.0;

/// Alike everywhere, and growing with time.
#[derive(Debug)]
struct Growing {
    /// Mass that comes in.
    inflow: f64,
}

impl Source<2> for Growing {
    fn at(&self, _: &Vector<2>, time: f64) -> Added<2> {
        Added {
            density: self.inflow * time,
            acceleration: Vector::from(PUSH) * time,
            heating: HEAT * time,
        }
    }
}

fn pushed(inflow: f64) -> Problem<2> {
    let mut problem = cube::<2>(10, Side::Periodic);
    problem.source = Some(Arc::new(Growing { inflow }));
    problem
}

/// Specific internal energy at the start, `p / ((gamma - 1) rho)`.
const ENERGY: f64 = 1.0 / (0.4 * 1.4);

/// Largest errors of velocity and energy at the end.
fn errors(scheme: Scheme, cfl: f64) -> [f64; 2] {
    let mut problem = pushed(0.0);
    problem.scheme = scheme;
    problem.scheme.step.cfl = cfl;
    let mut simulation = start(problem);
    advance_to(&mut simulation, END);
    let half = 0.5 * END * END;
    simulation
        .fluid
        .iter()
        .fold([0.0, 0.0], |[u, e], particle| {
            let velocity = particle.velocity - Vector::from(PUSH) * half;
            let energy = particle.energy - ENERGY - HEAT * half;
            [velocity.norm().max(u), energy.abs().max(e)]
        })
}

#[test]
fn both_schemes_of_particles_take_up_a_growing_source_to_second_order() {
    for scheme in [Scheme::CONSERVATIVE, Scheme::PAPER] {
        let [coarse, fine] = [0.4, 0.05].map(|cfl| errors(scheme, cfl));
        // The middle of a step is exact for what grows evenly; what the settled energy is off by falls with the square of the step.
        assert!(coarse[0] < 1e-13 && fine[0] < 1e-13, "{coarse:?} {fine:?}");
        assert!(fine[1] < 0.04 * coarse[1] + 1e-13, "{coarse:?} {fine:?}");
    }
}

/// Largest errors of density, velocity and energy about points that stay, at the end.
fn errors_of_points(cfl: f64) -> [f64; 3] {
    let mut problem = pushed(INFLOW);
    problem.method = Method::Fixed(FixedPoints {
        cfl,
        ..FixedPoints::default()
    });
    let mut simulation = FixedSimulation::new(problem).expect("the problem is sound");
    while simulation.time() < END {
        simulation.step(END).expect("the flow is tame");
    }
    let half = 0.5 * END * END;
    let frame = simulation.frame();
    (0..frame.density.len()).fold([0.0; 3], |[rho, u, e], i| {
        let density = frame.density[i] - 1.4 - INFLOW * half;
        let velocity = (0..2).map(|k| (frame.velocity[i][k] - PUSH[k] * half).abs());
        let energy = frame.energy[i] - ENERGY - HEAT * half;
        [
            density.abs().max(rho),
            velocity.fold(u, f64::max),
            energy.abs().max(e),
        ]
    })
}

#[test]
fn points_take_up_a_growing_source_and_its_mass_to_third_order() {
    let [coarse, fine] = [0.8, 0.1].map(errors_of_points);
    assert!(coarse[0] < 1e-13 && fine[0] < 1e-13, "{coarse:?} {fine:?}");
    // Products of what grows are taken up to the order of the steps.
    for k in 1..3 {
        assert!(fine[k] < 0.004 * coarse[k] + 1e-13, "{coarse:?} {fine:?}");
    }
}

#[test]
fn nobody_settles_with_a_source() {
    let mut problem = pushed(0.0);
    problem.method = Method::Fixed(FixedPoints {
        time: crate::method::Time::Settle,
        ..FixedPoints::default()
    });
    let error = FixedSimulation::new(problem).expect_err("it is refused");
    assert!(error.contains("scheme.time"), "{error}");
}

/// Weight over heat, `g / (p / rho)`, per length.
const WEIGHT: f64 = 0.42;

/// A column of gas that is as warm everywhere and at rest under its weight, `rho = rho_0 exp(-w x)`, between walls.
fn column(cells: u32) -> Problem<1> {
    let mut problem = cube::<1>(10, WALL);
    problem.resolution = Resolution::uniform(1.0 / f64::from(cells));
    problem.source = Some(Arc::new(BodyForce(Vector::<1>::new(-WEIGHT / 1.4))));
    problem.initial = Initial::Field(Field(Arc::new(|place: &Vector<1>| {
        let part = (-WEIGHT * place[0]).exp();
        State {
            density: 1.4 * part,
            velocity: Vector::zeros(),
            pressure: part,
        }
    })));
    problem
}

/// What the pressures on both walls are off by.
fn off(loads: &[Load]) -> f64 {
    let [bottom, top] = [-loads[0].force[0], loads[1].force[0]];
    (bottom - 1.0).abs().max((top - (-WEIGHT).exp()).abs())
}

#[test]
fn particles_stand_under_their_weight() {
    for extrapolation in [Extrapolation::Wom, Extrapolation::Wm] {
        let mut problem = column(50);
        problem.scheme.wall.extrapolation = extrapolation;
        let mut simulation = start(problem);
        advance_to(&mut simulation, 2.0);
        let speeds = simulation.fluid.iter().map(|p| p.velocity[0].abs());
        let fastest = speeds.fold(0.0, f64::max);
        let off = off(&simulation.loads());
        assert!(fastest < 5e-4 && off < 1e-3, "{fastest} {off}");
    }
}

/// Gas of one entropy under its weight. Its density is read off gas on one side alone in the rows at the walls, and would be 3.7e-3 off there on 50
/// cells, to first order, were it taken for even.
#[test]
fn particles_at_walls_are_as_dense_as_their_pressure_says() {
    for extrapolation in [Extrapolation::Wom, Extrapolation::Wm] {
        let errors = [25, 50].map(|cells| {
            let mut problem = column(cells);
            problem.scheme.wall.extrapolation = extrapolation;
            let warmth = |height: f64| 1.0 - WEIGHT / 3.5 * height;
            problem.initial = Initial::Field(Field(Arc::new(move |place: &Vector<1>| State {
                density: 1.4 * warmth(place[0]).powf(2.5),
                velocity: Vector::zeros(),
                pressure: warmth(place[0]).powf(3.5),
            })));
            let mut simulation = start(problem);
            advance_to(&mut simulation, 1.0);
            let each = simulation.fluid.iter();
            each.map(|particle| {
                let exact = 1.4 * warmth(particle.position[0]).powf(2.5);
                (particle.density / exact - 1.0).abs()
            })
            .fold(0.0, f64::max)
        });
        let [coarse, fine] = errors;
        assert!(
            fine < 6e-5 && fine < 0.4 * coarse,
            "{extrapolation:?}: {errors:?}"
        );
    }
}

/// Marched and settled.
#[test]
fn points_stand_under_their_weight() {
    for time in [Time::Accurate, Time::Settle] {
        let errors = [25, 50].map(|cells| {
            let mut problem = column(cells);
            problem.method = Method::Fixed(FixedPoints {
                time,
                ..FixedPoints::default()
            });
            let mut simulation = FixedSimulation::new(problem).expect("the problem is sound");
            match time {
                Time::Accurate => {
                    while simulation.time() < 2.0 {
                        simulation.step(2.0).expect("the flow is tame");
                    }
                }
                Time::Settle => {
                    for _ in 0..400 {
                        simulation.settle_step().expect("the flow is tame");
                    }
                }
            }
            let speeds = simulation.frame().velocity.into_iter();
            let fastest = speeds.map(|u| u[0].abs()).fold(0.0, f64::max);
            [fastest, off(&simulation.loads())]
        });
        let [coarse, fine] = errors;
        // Of second order.
        for k in 0..2 {
            assert!(fine[k] < 2e-5, "{time:?}: {errors:?}");
            assert!(fine[k] < 0.4 * coarse[k], "{time:?}: {errors:?}");
        }
    }
}
