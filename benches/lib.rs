//! The gas that is measured.

use std::sync::Arc;

use aero_geometry::{Bounds, Vector};
use aero_solver::gas::Gas;
use aero_solver::method::Method;
use aero_solver::problem::{Domain, Field, Initial, Problem, Side, State};
use aero_solver::scheme::Scheme;

/// A periodic box of disordered gas in gentle motion.
pub fn stirred<const D: usize>(cells: usize) -> Problem<D> {
    let wave = std::f64::consts::TAU;
    Problem {
        spacing: 1.0 / cells as f64,
        gas: Gas::ideal(1.4),
        second: None,
        method: Method::default(),
        scheme: Scheme::default(),
        domain: Domain {
            bounds: Bounds::new(Vector::zeros(), Vector::repeat(1.0)),
            sides: [[Side::Periodic; 2]; D],
            openings: Vec::new(),
        },
        free_stream: State {
            density: 1.4,
            velocity: Vector::zeros(),
            pressure: 1.0,
        },
        initial: Initial::Field(Field(Arc::new(move |position: &Vector<D>| State {
            density: 1.4 + 0.1 * (wave * position[0]).sin(),
            velocity: Vector::from_fn(|k, _| 0.3 * (wave * position[D - 1 - k] + k as f64).cos()),
            pressure: 1.0 + 0.1 * (wave * position[D - 1]).cos(),
        }))),
        disorder: 0.2,
        bodies: Vec::new(),
        source: None,
    }
}
