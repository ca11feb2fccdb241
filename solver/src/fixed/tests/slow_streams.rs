//! Streams slower than sound that settle about bodies with fine points at their ends.

use std::f64::consts::PI;
use std::sync::Arc;

use aero_geometry::{Vector, bodies};

use super::lattice::problem;
use crate::fixed::FixedSimulation;
use crate::method::{FixedPoints, Method, Refine, Time};
use crate::problem::Side;
use crate::tests::slip_body;

/// Half a spheroid about an axis, four times as long as thick, whose ends have cells of a thousandth of its length: steps of one stage let the gas
/// there swing for ever by as much as the dynamic pressure, and it has no drag.
#[test]
fn gas_comes_to_rest_before_fine_points() {
    let spacing = 0.4;
    let sides = [[Side::FreeStream; 2], [Side::Axis, Side::FreeStream]];
    let mut flight = problem([50, 25], spacing, sides);
    flight.free_stream.velocity = Vector::<2>::new(0.5, 0.0);
    let corners: Vec<Vector<2>> = (0..96)
        .map(|k| {
            let (sine, cosine) = (PI * f64::from(k) / 48.0).sin_cos();
            Vector::<2>::new(10.1 - cosine, 0.25 * sine)
        })
        .collect();
    flight.bodies = vec![slip_body(Arc::new(bodies::polygon(&corners).unwrap()))];
    flight.method = Method::Fixed(FixedPoints {
        time: Time::Settle,
        refine: Refine::Apart {
            flow: 0,
            bodies: 8,
            bends: 8,
        },
        ..FixedPoints::default()
    });
    let mut flow = FixedSimulation::new(flight).unwrap();
    let settled = flow.settle(600).unwrap();
    assert!(settled.is_settled && settled.residual < 0.01, "{settled:?}");
    let drag = flow.loads()[0].force[0] / (0.5 * 0.25 * PI * 0.25 * 0.25);
    assert!(drag.abs() < 0.02, "{drag}");
}
