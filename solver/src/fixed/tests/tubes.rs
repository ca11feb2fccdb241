//! Waves along a line.

use aero_geometry::Vector;

use super::lattice::{WALL, lattice, problem};
use crate::fixed::FixedSimulation;
use crate::problem::{Initial, State};

fn state(density: f64, velocity: f64, pressure: f64) -> State<1> {
    State {
        density,
        velocity: Vector::<1>::new(velocity),
        pressure,
    }
}

fn sod(count: usize) -> FixedSimulation<1> {
    let mut problem = problem([count], 1.0 / count as f64, [[WALL, WALL]]);
    problem.initial = Initial::Riemann {
        left: state(1.0, 0.0, 1.0),
        right: state(0.125, 0.0, 0.1),
        position: 0.5,
        smooth: false,
    };
    FixedSimulation::on(lattice(&problem), problem).unwrap()
}

#[test]
fn the_reflecting_tube_of_sod_is_right_to_four_thousandths() {
    let mut flow = sod(200);
    while flow.time() < 0.375 {
        flow.step(0.375).unwrap();
    }
    let frame = flow.frame();
    for (x, rho) in frame.position.iter().zip(&frame.density) {
        println!("{} {}", x[0], rho);
    }
    println!("{} steps", flow.steps());
    let totals = flow.totals();
    println!("{totals:?}");
}
