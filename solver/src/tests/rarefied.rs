//! How wide kernels grow in thin gas, how far walls may fill them, and rings that have grown.

use super::agreement::{agree, randomise, world};
use super::reference::gas::widest;
use super::seam::{self, DEFAULT, Solver, instructions};
use super::*;

/// Gas on every fifth point of the lattice, with kernels that want to be wider than anything.
fn thin<const D: usize>(sides: [[Side; 2]; D], cells: usize, h: f64) {
    let mut problem = cube::<D>(cells, WALL);
    problem.domain.sides = sides;
    problem.initial = Initial::Field(Field(Arc::new(move |position: &Vector<D>| {
        let is_fifth = position.iter().all(|x| (x / 0.1).floor() as i64 % 5 == 0);
        State {
            density: if is_fifth { 1.4 } else { 0.0 },
            velocity: Vector::zeros(),
            pressure: 1.0,
        }
    })));
    let problem = DEFAULT.of(problem);
    let mut solver = Solver::new(problem.clone(), instructions()[0]);
    solver.set_gas(|_, point| point.h = h);
    solver.list();
    let start = world(&solver, &problem);
    let densities = start.densities();
    solver.read_densities();
    let ghosts = start.all_ghosts();
    let periodic = seam::maps(&problem)
        .iter()
        .zip(&problem.domain.bounds.size())
        .filter(|(maps, _)| maps.iter().any(|map| map.0 > 0.0))
        .map(|(_, size)| (0.5 * size - 0.5).max(0.0))
        .fold(f64::INFINITY, f64::min);
    let expected = start.gas.iter().zip(&densities).map(|(i, density)| {
        let room = seam::room(&problem, &i.position).min(periodic);
        let width = 1.5 * (i.mass / density).powf(1.0 / D as f64);
        [width.min(1.03 * i.h).min(widest(i, &ghosts, 0.1, room))]
    });
    let expected: Vec<_> = expected.collect();
    let gas = solver.gas();
    agree(
        "smoothing length",
        gas.iter().map(|p| [p.h]),
        expected.iter().copied(),
    );
    let range = |(least, most): (f64, f64), h: &[f64; 1]| (least.min(h[0]), most.max(h[0]));
    let (least, most) = expected.iter().fold((f64::INFINITY, 0.0), range);
    assert!(least < 0.3 * h && most > 1.2 * least, "all are near {most}");
}

#[test]
fn kernels_in_thin_gas_grow_as_far_as_walls_sides_and_searches_allow() {
    thin::<1>([[WALL, Side::Symmetry]], 60, 1.0);
    thin::<2>([[WALL, Side::Symmetry], [Side::Symmetry; 2]], 40, 1.0);
    thin::<2>([[WALL, Side::Symmetry], [Side::Periodic; 2]], 20, 0.8);
    thin::<2>(
        [[Side::Outlet, Side::Symmetry], [Side::Symmetry; 2]],
        40,
        1.0,
    );
    thin::<3>(
        [
            [WALL, Side::Symmetry],
            [Side::Symmetry; 2],
            [Side::Symmetry; 2],
        ],
        20,
        0.8,
    );
}

#[test]
fn a_particle_squeezed_among_ghosts_is_not_divided_by_nothing() {
    let problem = DEFAULT.of(cube::<2>(12, WALL));
    for instructions in instructions() {
        let mut solver = Solver::new(problem.clone(), instructions);
        solver.set_gas(|number, point| {
            if number == 40 {
                point.position = Vector::<2>::new(0.52, -0.13);
            }
        });
        solver.list();
        let expected = world(&solver, &problem).densities();
        solver.read_densities();
        let densities = solver.gas();
        agree(
            "density",
            densities.iter().map(|p| [p.density]),
            expected.iter().map(|&d| [d]),
        );
    }
}

/// A pipe of disordered gas around the axis.
fn pipe() -> Problem<2> {
    let mut problem = cube::<2>(12, WALL);
    problem.disorder = 0.2;
    problem.domain.sides[1][0] = Side::Axis;
    DEFAULT.of(problem)
}

#[test]
fn the_kernel_of_a_ring_goes_by_the_mass_that_it_began_with_once_it_has_grown() {
    let problem = pipe();
    let mut solver = Solver::new(problem.clone(), instructions()[0]);
    let begun = 1.4 * 0.1 * 0.1;
    solver.set_gas(|number, point| point.mass = begun * [0.2, 1.0, 1.3][number % 3]);
    solver.list();
    let start = world(&solver, &problem);
    let densities = start.densities();
    solver.read_densities();
    let expected = start.gas.iter().zip(&densities).map(|(i, density)| {
        let width = 1.5 * (i.mass.max(begun) / density).sqrt();
        [width.min(1.03 * i.h)]
    });
    let gas = solver.gas();
    agree(
        "density",
        gas.iter().map(|p| [p.density]),
        densities.iter().map(|&d| [d]),
    );
    agree("smoothing length", gas.iter().map(|p| [p.h]), expected);
}

#[test]
fn rings_that_grow_thin_and_cool_their_gas() {
    let problem = pipe();
    let mut solver = Solver::new(problem.clone(), instructions()[0]);
    randomise(&mut solver);
    solver.list();
    let start = world(&solver, &problem);
    solver.evaluate();
    let gas = start.gas.clone();
    let asked = reference::step::Asked {
        laws: DEFAULT.laws(),
        mirrors: false,
        shield: false,
        shifting: false,
    };
    let expected = start.evaluate(asked, |_| f64::INFINITY);
    let growth = |i: &reference::Point<2>| i.velocity[1] / i.position[1].max(0.05);
    let both = || gas.iter().zip(&expected.rates);
    let rates = solver.rates();
    let thinned = both().map(|(i, rate)| [rate.density - i.density * growth(i)]);
    agree(
        "rate of density",
        rates.iter().map(|r| [r.density]),
        thinned,
    );
    let cooled = both().map(|(i, rate)| [rate.energy - 0.4 * i.energy * growth(i)]);
    agree("rate of energy", rates.iter().map(|r| [r.energy]), cooled);
    let heating = both().map(|(i, rate)| [rate.heating_by_pressure - 0.4 * i.energy * growth(i)]);
    agree(
        "heating",
        rates.iter().map(|r| [r.heating_by_pressure]),
        heating,
    );
    let smooth = both().map(|(i, rate)| [reference::gas::smoothness(i, rate, growth(i))]);
    agree(
        "smoothness",
        solver.gas().iter().map(|p| [p.smoothness]),
        smooth,
    );
}
