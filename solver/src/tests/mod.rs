//! Golden physics: what must hold whatever the speed.

mod agreement;
mod axis;
mod bends;
mod calm;
mod combinations;
mod conduction;
mod conservation;
mod free;
mod invariance;
mod joints;
mod lanes;
mod leapfrog;
mod life;
mod liquid_lanes;
mod liquids;
mod mixed;
mod panels;
mod rarefied;
mod reference;
mod rest;
mod rings;
mod rooms;
pub(crate) mod seam;
mod shifting;
mod sources;
mod steps;
mod surfaces;
mod thin;
mod thin_lanes;
mod two_gases;
mod viscous;
mod walls;

use std::sync::Arc;

use aero_geometry::{Bounds, Shape, Vector};

use super::Simulation;
use crate::gas::Gas;
use crate::problem::{Body, Domain, Field, Initial, Motion, Problem, Side, State, WallKind};
use crate::scheme::{Extrapolation, Scheme};

pub(crate) const WALL: Side = Side::Wall {
    kind: WallKind::Slip,
    velocity: 0.0,
    acceleration: 0.0,
};

/// A box of `cells` cells per axis with spacing 0.1, all sides alike, at rest with `c = 1`.
pub(crate) fn cube<const D: usize>(cells: usize, side: Side) -> Problem<D> {
    let spacing = 0.1;
    let bounds = Bounds::new(Vector::zeros(), Vector::repeat(cells as f64 * spacing));
    let domain = Domain::new(bounds, [[side; 2]; D]);
    Problem::new(Gas::ideal(1.4), domain, State::at_rest(1.4, 1.0), spacing)
}

/// A slip body at rest, without ghosts.
pub(crate) fn slip_body<const D: usize>(shape: Arc<dyn Shape<D>>) -> Body<D> {
    Body {
        name: "body".into(),
        shape,
        wall: WallKind::Slip,
        motion: Motion::none(),
        ghosts: aero_packer::Ghosts::default(),
        packed_fluid: None,
        report: aero_packer::PackReport::default(),
        reference_area: 1.0,
        reference_length: 1.0,
        moment_centre: Vector::zeros(),
    }
}

/// A periodic box of disordered gas in motion: velocity, density and pressure vary by order one.
fn stirred<const D: usize>(cells: usize) -> Problem<D> {
    let mut problem = cube::<D>(cells, Side::Periodic);
    problem.disorder = 0.2;
    let wave = std::f64::consts::TAU / problem.domain.bounds.max[0];
    problem.initial = Initial::Field(Field(Arc::new(move |position: &Vector<D>| State {
        density: 1.4 + 0.4 * (wave * position[0]).sin(),
        velocity: Vector::from_fn(|k, _| 0.7 * (wave * position[D - 1 - k] + k as f64).cos()),
        pressure: 1.0 + 0.3 * (wave * position[D - 1]).cos(),
    })));
    problem
}

fn start<const D: usize>(problem: Problem<D>) -> Simulation<D> {
    Simulation::new(problem).expect("the problem is sound")
}

fn advance<const D: usize>(simulation: &mut Simulation<D>, steps: usize) {
    for _ in 0..steps {
        simulation.step(f64::INFINITY).expect("the flow is tame");
    }
}

fn advance_to<const D: usize>(simulation: &mut Simulation<D>, time: f64) {
    while simulation.time() < time {
        simulation.step(time).expect("the flow is tame");
    }
}
