//! Two gases beside each other.

use aero_geometry::{Placed, Placement, bodies};

use super::seam::body_on_the_lattice;
use super::*;
use crate::gas::IdealGas;
use crate::problem::SecondGas;

/// Helium beside air, in numbers of the right size.
const HELIUM: Gas = Gas::Ideal(IdealGas {
    gamma: 5.0 / 3.0,
    constant: 7.0,
    transport: None,
});

/// Density of helium in air of 1.4, at one pressure and temperature.
const LIGHT: f64 = 0.2;

/// `problem` with helium where `fills` says.
fn with_helium<const D: usize>(
    mut problem: Problem<D>,
    fills: impl Fn(&Vector<D>) -> bool + Send + Sync + 'static,
) -> Problem<D> {
    problem.second = Some(SecondGas {
        gas: HELIUM,
        fills: Arc::new(fills),
        density: Some(LIGHT),
    });
    problem
}

/// The largest departure from an even pressure and velocity.
fn unrest<const D: usize>(simulation: &Simulation<D>, velocity: &Vector<D>) -> f64 {
    let gases = simulation.problem.gases();
    let of = |p: &crate::particles::Particle<D>| {
        let pressure = gases.of(p.is_second).pressure(p.density, p.energy);
        (pressure - 1.0).abs().max((p.velocity - velocity).norm())
    };
    simulation.fluid.iter().map(of).fold(0.0, f64::max)
}

/// Neither density nor heat leaks across: pressure and velocity stay even to round-off, whatever the stream.
#[test]
fn a_bubble_at_the_pressure_of_its_stream_drifts_with_it() {
    for velocity in [[0.0, 0.0], [0.7, 0.3]] {
        let velocity = Vector::from(velocity);
        let round = |p: &Vector<2>| (p - Vector::repeat(1.2)).norm() < 0.55;
        let mut problem = with_helium(cube::<2>(24, Side::Periodic), round);
        problem.free_stream.velocity = velocity;
        let mut simulation = start(problem);
        let count = simulation.fluid.iter().filter(|p| p.is_second).count();
        assert!((80..110).contains(&count), "{count}");
        let light = simulation.fluid.iter().filter(|p| p.is_second);
        assert!(light.into_iter().all(|p| (p.density - LIGHT).abs() < 1e-12));
        advance(&mut simulation, 40);
        let unrest = unrest(&simulation, &velocity);
        assert!(unrest < 1e-11, "{unrest:e}");
        assert_eq!(
            simulation.fluid.iter().filter(|p| p.is_second).count(),
            count
        );
    }
}

/// As rings about an axis too, and where pairs are computed in fewer digits.
#[test]
fn a_ball_and_a_rounded_bubble_stay_at_rest() {
    let near = |p: &Vector<2>| p.norm() < 0.85;
    let mut ball = cube::<2>(20, WALL);
    ball.domain.sides[1][0] = Side::Axis;
    let mut rounded = cube::<2>(20, WALL);
    rounded.scheme.precision = crate::scheme::Precision::Mixed;
    for (problem, allowed) in [(ball, 1e-11), (rounded, 1e-5)] {
        let mut simulation = start(with_helium(problem, near));
        advance(&mut simulation, 40);
        let unrest = unrest(&simulation, &Vector::zeros());
        assert!(unrest < allowed, "{unrest:e}");
    }
}

/// Ghosts show the gas that is there: a bubble that leans on walls is at rest, and presses on them as the rest does.
#[test]
fn a_bubble_rests_in_the_corner_of_a_box() {
    let near = |p: &Vector<2>| p.norm() < 0.75;
    let mut simulation = start(with_helium(cube::<2>(20, WALL), near));
    advance(&mut simulation, 40);
    let unrest = unrest(&simulation, &Vector::zeros());
    assert!(unrest < 1e-11, "{unrest:e}");
    let shown = simulation.walls.own().iter().map(|ghost| ghost.shown);
    let ends = shown.clone().filter(|shown| shown.second > 1.0 - 1e-12);
    assert!(ends.clone().count() > 10);
    for shown in ends {
        assert!((shown.density / LIGHT - 1.0).abs() < 1e-10, "{shown:?}");
    }
    assert!(shown.clone().filter(|shown| shown.second == 0.0).count() > 20);
    // In the corner panels show the mean of the gas before them, of whatever it is made.
    for pressure in simulation.panels().pressure {
        assert!((pressure - 1.0).abs() < 0.01, "{pressure}");
    }
    // Where they meet the densities of both are shown together.
    let between = shown.filter(|shown| (0.3..0.7).contains(&shown.second));
    assert!(
        between
            .clone()
            .all(|shown| shown.density > LIGHT && shown.density < 1.4)
    );
}

/// Panels of a body in a bubble show the pressure of the gas that they lie in.
#[test]
fn a_body_in_a_bubble_shows_its_pressure() {
    let mut problem = cube::<2>(24, WALL);
    let square = bodies::rectangle(0.6, 0.6, 0.0).expect("a square");
    let place = Placement::default().moved(Vector::repeat(1.2));
    let body = body_on_the_lattice(&problem, Arc::new(Placed::new(square, place)));
    problem.bodies.push(body);
    let round = |p: &Vector<2>| (p - Vector::repeat(1.2)).norm() < 1.1;
    let shown = start(with_helium(problem, round)).panels();
    let own = shown
        .pressure
        .iter()
        .zip(&shown.body)
        .filter(|(_, body)| **body == 0);
    assert!(own.clone().count() >= 24);
    for (pressure, _) in own {
        assert!((pressure - 1.0).abs() < 0.01, "{pressure}");
    }
}

/// Gas that is all of the second is that gas alone, number by number: nothing of the first is left in the laws.
#[test]
fn the_second_gas_alone_flows_as_if_it_were_the_first() {
    let stir = |problem: &mut Problem<2>| {
        problem.initial = Initial::Field(Field(Arc::new(|p: &Vector<2>| State {
            density: LIGHT,
            velocity: Vector::from([0.6 * (2.0 * p[1]).sin(), 0.4 * (3.0 * p[0]).cos()]),
            pressure: 1.0 + 0.3 * (2.5 * p[0]).sin(),
        })));
    };
    let mut first = cube::<2>(20, WALL);
    first.gas = HELIUM;
    stir(&mut first);
    let mut second = with_helium(cube::<2>(20, WALL), |_| true);
    stir(&mut second);
    let [mut first, mut second] = [start(first), start(second)];
    for simulation in [&mut first, &mut second] {
        advance_to(simulation, 0.2);
    }
    assert_eq!(first.fluid.len(), second.fluid.len());
    for (a, b) in first.fluid.iter().zip(&second.fluid) {
        assert_eq!(a.id, b.id);
        let apart = (a.position - b.position)
            .norm()
            .max((a.velocity - b.velocity).norm());
        let states = (a.density / b.density - 1.0)
            .abs()
            .max((a.energy / b.energy - 1.0).abs());
        assert!(apart.max(states) < 1e-9, "{apart:e} {states:e}");
    }
}

/// Mass, momentum and energy of both together stay to round-off while a blast goes through.
#[test]
fn two_gases_keep_their_mass_momentum_and_energy() {
    let mut problem = with_helium(cube::<2>(24, Side::Periodic), |p: &Vector<2>| p[0] > 1.3);
    problem.initial = Initial::Field(Field(Arc::new(|p: &Vector<2>| State {
        density: 1.4,
        velocity: Vector::from([0.5, 0.2]),
        pressure: if (p - Vector::repeat(1.0)).norm() < 0.4 {
            8.0
        } else {
            1.0
        },
    })));
    let mut simulation = start(problem);
    let before = simulation.totals();
    let light = |simulation: &Simulation<2>| -> f64 {
        let light = simulation.fluid.iter().filter(|p| p.is_second);
        light.map(|p| p.mass).sum()
    };
    let mass = light(&simulation);
    advance(&mut simulation, 60);
    let after = simulation.totals();
    assert!((after.mass / before.mass - 1.0).abs() < 1e-13);
    assert!((light(&simulation) / mass - 1.0).abs() < 1e-13);
    assert!((after.energy / before.energy - 1.0).abs() < 1e-12);
    for k in 0..2 {
        let drift = (after.momentum[k] - before.momentum[k]).abs() / before.mass;
        assert!(drift < 1e-13, "{drift:e}");
    }
}
