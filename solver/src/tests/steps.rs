//! One whole step, put together from evaluations by the formulas of the integrators.

use super::agreement::{Random, agree};
use super::reference::{Point, Rate};
use super::seam::{DEFAULT, PUBLISHED, Setup, Solver, instructions};
use super::*;

/// Disordered gas in motion between walls: somewhere some of it heads for a wall that shields itself.
fn hustle() -> Problem<2> {
    let mut problem = cube::<2>(14, WALL);
    problem.disorder = 0.3;
    problem
}

fn solver(setup: Setup) -> Solver<2> {
    let mut solver = Solver::new(setup.of(hustle()), instructions()[0]);
    let mut random = Random::new();
    solver.set_gas(|_, point| {
        point.velocity = random.vector();
        point.density = 1.5 + 0.3 * random.next();
        point.energy = 2.5 + random.next();
        point.mass = 0.015 * (1.0 + 0.1 * random.next());
        point.smoothness = 0.5 + 0.5 * random.next();
    });
    solver
}

type Gas = Vec<(u64, Point<2>, Rate<2>)>;

/// Gas and rates by particle, after an evaluation of the gas as it stands.
fn evaluated(setup: Setup, solver: &mut Solver<2>) -> Gas {
    solver.list();
    if !setup.published {
        solver.read_densities();
    }
    // The dissipation of the next evaluation goes by what this one finds smooth; its own by the state before.
    let before = solver.gas();
    solver.evaluate();
    let mut gas: Gas = solver
        .gas()
        .into_iter()
        .zip(before)
        .zip(solver.ids().into_iter().zip(solver.rates()))
        .map(|((after, before), (id, rates))| {
            assert!((after.position - before.position).norm() == 0.0);
            (id, after, rates)
        })
        .collect();
    gas.sort_by_key(|(id, ..)| *id);
    gas
}

/// Sets the gas; `gas` is in the order of the particles' numbers.
fn set(solver: &mut Solver<2>, gas: &[Point<2>]) {
    let ids = solver.ids();
    let mut sorted = ids.clone();
    sorted.sort_unstable();
    solver.set_gas(|number, point| {
        let place = sorted.binary_search(&ids[number]);
        *point = gas[place.expect("its own number")];
    });
}

/// Compares the gas after one step of `setup` with `expected`.
fn compare(setup: Setup, expected: impl Fn(&mut Solver<2>, f64) -> Vec<Point<2>>) {
    let mut stepped = solver(setup);
    let step = stepped.step();
    let order = stepped.ids();
    let mut gas: Vec<_> = order.into_iter().zip(stepped.gas()).collect();
    gas.sort_by_key(|(id, _)| *id);
    let expected = expected(&mut solver(setup), step);
    let check = |what: &str, get: &dyn Fn(&Point<2>) -> [f64; 2]| {
        let gas = gas.iter().map(|(_, point)| get(point));
        agree(what, gas, expected.iter().map(get));
    };
    check("position", &|p| p.position.into());
    check("velocity", &|p| p.velocity.into());
    check("density", &|p| [p.density, 0.0]);
    check("energy", &|p| [p.energy, 0.0]);
    check("smoothing length", &|p| [p.h, 0.0]);
}

/// Evaluate, predict, evaluate, correct [Villodi & Ramachandran 2024, section 3.6]: all stages start from the
/// state at the step's beginning, and move by the transport velocity at which the rates were evaluated.
#[test]
fn the_published_step_moves_particles_by_their_transport_velocity() {
    let stage = |start: &Gas, rates: &Gas, time: f64| -> Vec<Point<2>> {
        let both = start.iter().zip(rates);
        both.map(|((_, start, _), (_, now, rate))| {
            let growth = -now.h / (2.0 * now.density) * rate.density * time;
            Point {
                position: start.position + (now.velocity + rate.shift) * time,
                velocity: start.velocity + rate.acceleration * time,
                density: start.density + rate.density * time,
                energy: start.energy + rate.energy * time,
                h: start.h + growth.min(0.03 * start.h),
                ..*start
            }
        })
        .collect()
    };
    for shield in [false, true] {
        let setup = Setup {
            shield,
            ..PUBLISHED
        };
        compare(setup, |solver, step| {
            let start = evaluated(setup, solver);
            let shifted = start.iter().filter(|(.., rate)| rate.shift.norm() > 0.01);
            assert_eq!(shifted.count() > 3, shield);
            set(solver, &stage(&start, &start, 0.5 * step));
            let middle = evaluated(setup, solver);
            stage(&start, &middle, step)
        });
    }
}

/// Drift half a step, with the kick that pressure alone would give; read the density, evaluate; kick from the start, drift at
/// the mean velocity, and turn into heat what the forces' work at that velocity differs.
#[test]
fn the_leapfrog_kicks_at_the_middle_and_drifts_at_the_mean_velocity() {
    for shifting in [false, true] {
        let setup = Setup {
            shifting,
            ..DEFAULT
        };
        compare(setup, |solver, step| {
            let start = evaluated(setup, solver);
            let half = 0.5 * step;
            let predicted: Vec<_> = start
                .iter()
                .map(|(_, start, rate)| Point {
                    position: start.position + start.velocity * half,
                    velocity: start.velocity + rate.acceleration_by_pressure * half,
                    energy: start.energy + rate.heating_by_pressure * half,
                    ..*start
                })
                .collect();
            set(solver, &predicted);
            let middle = evaluated(setup, solver);
            let all = start.iter().zip(&middle);
            all.map(|((_, start, _), (_, middle, rate))| {
                let velocity = start.velocity + rate.acceleration * step;
                let mean = (start.velocity + velocity) * 0.5;
                let work = rate.acceleration.dot(&(mean - middle.velocity));
                Point {
                    position: start.position + (mean + rate.shift) * step,
                    velocity,
                    density: middle.density + rate.density * half,
                    energy: start.energy + (rate.energy - work) * step,
                    ..*middle
                }
            })
            .collect()
        });
    }
}
