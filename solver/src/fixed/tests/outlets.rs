//! Outlets that relax to a pressure, where ducts widen and points come and go.

use std::sync::Arc;

use aero_geometry::{Bounds, Vector, bodies};

use super::flows::stream;
use super::lattice::problem;
use crate::fixed::FixedSimulation;
use crate::method::{FixedPoints, Method, Refine, Time};
use crate::problem::{Initial, Problem, Side, State};
use crate::tests::slip_body;

const HELD: f64 = 0.8;

/// Half a duct whose wall falls away by 15 degrees from its middle on: gas from a reservoir goes through it to a pressure above its own, and
/// its wall ends at the outlet askew.
fn diffuser(spacing: f64) -> Problem<2> {
    let outlet = Side::HeldOutlet {
        pressure: HELD,
        relaxation: 0.5,
    };
    let reservoir = Side::Reservoir { relaxation: None };
    let ends = [[reservoir, outlet], [Side::Body, Side::Symmetry]];
    let mut diffuser = problem([1; 2], spacing, ends);
    diffuser.domain.bounds = Bounds::new([-0.6, -0.3].into(), [1.0, 0.5].into());
    diffuser.free_stream = State {
        density: 1.0,
        velocity: Vector::<2>::new(0.6, 0.0),
        pressure: 1.0 / 1.4,
    };
    let floor = bodies::expansion_corner(0.0, 15.0).unwrap();
    diffuser.bodies = vec![slip_body(Arc::new(floor))];
    diffuser
}

/// Told from what flows along the side, the wave that comes in left the pressure 4 % too high for good.
#[test]
fn a_duct_that_widens_ends_at_the_pressure_held_from_wall_to_wall() {
    let spacing = 0.1;
    let mut flow = FixedSimulation::new(diffuser(spacing)).unwrap();
    while flow.time() < 80.0 {
        flow.step(80.0).unwrap();
    }
    let frame = flow.frame();
    let last = frame.position.iter().zip(&frame.pressure);
    let last: Vec<f64> = last
        .filter(|(x, _)| x[0] > 1.0 - spacing)
        .map(|(_, pressure)| pressure / HELD - 1.0)
        .collect();
    let mean = last.iter().sum::<f64>() / last.len() as f64;
    // Half a cell before the side the pressure is still to rise.
    assert!((-0.01..0.0).contains(&mean), "{mean} {last:?}");
    assert!(last.iter().all(|off| (off - mean).abs() < 0.01), "{last:?}");
}

/// What comes in goes on coming in through the faces of new points, and after a resume.
#[test]
fn what_comes_in_outlives_points_and_runs() {
    let refined = || {
        let mut duct = diffuser(0.1);
        // A shock runs out.
        let gas = |pressure: f64| State {
            density: 1.4 * pressure,
            velocity: Vector::<2>::new(0.3, 0.0),
            pressure,
        };
        duct.initial = Initial::Riemann {
            left: gas(2.0),
            right: gas(0.8),
            position: 0.0,
            smooth: false,
        };
        duct.method = Method::Fixed(FixedPoints {
            refine: Refine::Levels(1),
            ..FixedPoints::default()
        });
        duct
    };
    let mut flow = FixedSimulation::new(refined()).unwrap();
    let mut faces = flow.waves().len();
    let mut changes = 0;
    // What a wave changes by in a step that leaves its faces as they are.
    let mut usual = 0.0;
    while flow.time() < 12.0 {
        let before = flow.placed_waves();
        flow.step(12.0).unwrap();
        let after = flow.placed_waves();
        assert_eq!(after.len(), flow.waves().len());
        if after.len() == faces {
            let pairs = before.iter().zip(&after);
            let steps = pairs.map(|(old, new)| (old.1.back - new.1.back).abs());
            usual = steps.fold(0.0, f64::max);
            continue;
        }
        (faces, changes) = (after.len(), changes + 1);
        for (middle, wave) in &after {
            let away = |other: &&(Vector<2>, _)| (other.0 - middle).norm();
            let (_, old) = before
                .iter()
                .min_by(|a, b| away(a).total_cmp(&away(b)))
                .unwrap();
            let step = (old.back - wave.back).abs();
            assert!(step < 1.1 * usual + 0.004, "{step} {usual}");
        }
    }
    assert!(changes > 2, "{changes}");
    let mut resumed = FixedSimulation::resume(refined(), flow.memory()).unwrap();
    for flow in [&mut flow, &mut resumed] {
        for _ in 0..20 {
            flow.step(1e9).unwrap();
        }
    }
    assert_eq!(flow.frame(), resumed.frame());
    assert_eq!(flow.waves(), resumed.waves());
}

/// A duct that begins at Mach 0.2 between a reservoir and the pressure of Mach 0.1 has settled when its gas is as slow as that, and not as soon as it
/// hardly changes from one iteration to the next.
#[test]
fn a_duct_has_not_settled_before_its_gas_is_as_fast_as_its_ends_ask_for() {
    let outlet = Side::HeldOutlet {
        // (1 + 0.2 * 0.1^2)^-3.5 of the total pressure, (1 + 0.2 * 0.2^2)^3.5 / 1.4.
        pressure: (1.008_f64 / 1.002).powf(3.5) / 1.4,
        relaxation: 0.25,
    };
    let sides = [Side::Reservoir { relaxation: None }, outlet];
    let mut duct = problem([60], 0.05, [sides]);
    duct.free_stream.velocity = [0.2].into();
    duct.method = Method::Fixed(FixedPoints {
        time: Time::Settle,
        ..FixedPoints::default()
    });
    let mut flow = FixedSimulation::new(duct).unwrap();
    let settled = flow.settle(5000).unwrap();
    assert!(settled.is_settled, "{settled:?}");
    // Of the speed of sound at rest, sqrt(1.008).
    let exact = 0.1 * (1.008_f64 / 1.002).sqrt();
    for state in &flow.columns.states {
        assert!((state.velocity[0] / exact - 1.0).abs() < 5e-3, "{state:?}");
    }
}

/// Nothing but what is rounded presses a wedge in gas at rest, nor moves that gas; neither is waited for.
#[test]
fn gas_at_rest_has_settled() {
    let corners = [[-0.5, 0.013], [0.4, 0.2], [0.4, -0.2]];
    let held = Side::HeldOutlet {
        pressure: 1.0 / 1.4,
        relaxation: 0.25,
    };
    let open = [Side::FreeStream, Side::FreeStream];
    for first in [open, [Side::Reservoir { relaxation: None }, held]] {
        let wedge = bodies::polygon(&corners.map(Vector::<2>::from)).unwrap();
        let mut problem = stream(0.0, [[-1.0; 2], [1.0; 2]], 0.05, vec![Arc::new(wedge)]);
        problem.domain.sides[0] = first;
        problem.method = Method::Fixed(FixedPoints {
            time: Time::Settle,
            ..FixedPoints::default()
        });
        let mut flow = FixedSimulation::new(problem).unwrap();
        let settled = flow.settle(500).unwrap();
        assert!(settled.is_settled, "{settled:?}");
    }
}
