//! The gas that is measured.

use std::sync::Arc;

use aero_geometry::{Bounds, Vector};
use aero_solver::gas::Gas;
use aero_solver::problem::{Domain, Field, Initial, Problem, Side, State};

/// A periodic box of disordered gas in gentle motion.
pub fn stirred<const D: usize>(cells: usize) -> Problem<D> {
    let wave = std::f64::consts::TAU;
    let bounds = Bounds::new(Vector::zeros(), Vector::repeat(1.0));
    let domain = Domain::new(bounds, [[Side::Periodic; 2]; D]);
    Problem {
        initial: Initial::Field(Field(Arc::new(move |position: &Vector<D>| State {
            density: 1.4 + 0.1 * (wave * position[0]).sin(),
            velocity: Vector::from_fn(|k, _| 0.3 * (wave * position[D - 1 - k] + k as f64).cos()),
            pressure: 1.0 + 0.1 * (wave * position[D - 1]).cos(),
        }))),
        disorder: 0.2,
        ..Problem::new(
            Gas::ideal(1.4),
            domain,
            State::at_rest(1.4, 1.0),
            1.0 / cells as f64,
        )
    }
}
