//! Halvings that bodies have beside those of the flow.

use std::sync::Arc;

use aero_geometry::{Vector, bodies};

use super::lattice::problem;
use crate::fixed::FixedSimulation;
use crate::method::{FixedPoints, Method, Refine, Time};
use crate::problem::{Problem, Side, State};
use crate::tests::slip_body;

/// So many halvings of the flow, and of all that bodies ask for.
fn apart(flow: u8, bodies: u8) -> Refine {
    Refine::Apart {
        flow,
        bodies,
        bends: bodies,
    }
}

/// A plate as thin as half a cell in a stream faster than sound.
fn flight(refine: Refine) -> Problem<2> {
    let sides = [[Side::Inlet, Side::Outlet], [Side::FreeStream; 2]];
    let mut flight = problem([20, 16], 0.1, sides);
    flight.free_stream = State {
        density: 1.0,
        velocity: Vector::<2>::new(2.0, 0.0),
        pressure: 1.0 / 1.4,
    };
    let corners = [[0.6, 0.78], [1.3, 0.78], [1.3, 0.83], [0.6, 0.83]];
    let plate = bodies::polygon(&corners.map(Vector::<2>::from)).unwrap();
    flight.bodies = vec![slip_body(Arc::new(plate))];
    flight.method = Method::Fixed(FixedPoints {
        time: Time::Settle,
        refine,
        ..FixedPoints::default()
    });
    flight
}

fn settled(refine: Refine) -> FixedSimulation<2> {
    let mut flow = FixedSimulation::new(flight(refine)).unwrap();
    assert!(flow.settle(2000).unwrap().is_settled, "{refine:?}");
    flow
}

/// All that is finer than the flow's own halving is what the body asked for before the first step.
#[test]
fn thin_parts_get_finer_points_than_the_shocks_of_their_flow() {
    let finer_plate = apart(1, 3);
    let before = FixedSimulation::new(flight(finer_plate)).unwrap();
    let finer = |flow: &FixedSimulation<2>| flow.points_per_level()[2..].to_vec();
    let asked = finer(&before);
    assert!(asked[1] > 50, "{asked:?}");
    let after = settled(finer_plate);
    assert_eq!(finer(&after), asked);
    assert!(after.points_per_level()[1] > before.points_per_level()[1]);
    // The other way round the body asks for less than the shocks do.
    let other = settled(apart(2, 0));
    assert!(other.points_per_level()[2] > 50);
}

#[test]
fn as_many_halvings_for_both_are_those_of_one_number() {
    let [one, two] = [Refine::Levels(2), apart(2, 2)].map(settled);
    assert_eq!(one.frame(), two.frame());
    assert_eq!(one.loads(), two.loads());
}

/// A body alone may ask, and a run that is resumed has its points.
#[test]
fn points_that_only_a_body_asks_for_stay_through_a_resume() {
    let alone = apart(0, 2);
    let run = |flow: &mut FixedSimulation<2>, count: usize| {
        for _ in 0..count {
            flow.settle_step().unwrap();
        }
    };
    let mut whole = FixedSimulation::new(flight(alone)).unwrap();
    run(&mut whole, 30);
    let mut begun = FixedSimulation::new(flight(alone)).unwrap();
    run(&mut begun, 12);
    let mut resumed = FixedSimulation::resume(flight(alone), begun.memory()).unwrap();
    run(&mut resumed, 18);
    assert_eq!(whole.frame(), resumed.frame());
    assert!(resumed.points_per_level()[2] > 0);
}

/// A body much smaller than the cells of the lattice is as finely resolved wherever it lies in them.
#[test]
fn small_bodies_ask_from_anywhere_in_a_large_cell() {
    let sides = [[Side::Inlet, Side::Outlet], [Side::FreeStream; 2]];
    let finest = |at: [f64; 2]| {
        let mut flight = problem([8, 8], 2.0, sides);
        let corners = [[0.0, 0.0], [0.35, 0.04], [1.0, 0.0], [0.35, -0.04]];
        let corners = corners.map(|[x, y]| Vector::from([at[0] + x, at[1] + y]));
        flight.bodies = vec![slip_body(Arc::new(bodies::polygon(&corners).unwrap()))];
        flight.method = Method::Fixed(FixedPoints {
            refine: apart(0, 7),
            ..FixedPoints::default()
        });
        let flow = FixedSimulation::new(flight).unwrap();
        flow.points_per_level().get(7).copied().unwrap_or(0)
    };
    let counts: Vec<usize> = (0..12)
        .map(|k| {
            finest([
                7.0 + 0.17 * f64::from(k),
                7.03 + 0.19 * f64::from(5 * k % 12),
            ])
        })
        .collect();
    let [least, most] = [counts.iter().min(), counts.iter().max()].map(|n| n.copied().unwrap());
    assert!(least > 200 && most < 2 * least, "{counts:?}");
}

/// What is bent may be finer than what is only thin.
#[test]
fn bends_get_finer_points_than_thin_parts() {
    let counts = |bends: u8| {
        let refine = Refine::Apart {
            flow: 0,
            bodies: 1,
            bends,
        };
        let flow = FixedSimulation::new(flight(refine)).unwrap();
        flow.points_per_level()
    };
    let [plain, finer] = [1, 3].map(counts);
    assert_eq!(plain.len(), 2);
    // At the plate's ends, and not along it.
    let whole = FixedSimulation::new(flight(apart(0, 3)))
        .unwrap()
        .points_per_level()[3];
    assert!(
        finer[3] > 20 && 2 * finer[3] < whole,
        "{finer:?} of {whole}"
    );
}
