//! What bodies do to a stream slower than sound, far away.

use super::adapting::{refined, slender};
use super::lattice::problem;
use super::*;
use crate::fixed::FixedSimulation;
use crate::method::{Refine, Time};
use crate::tests::slip_body;

/// Sides that held the stream straight would take a ninth of the lift in the small box, and half as much in the large one.
#[test]
fn lift_does_not_depend_on_how_far_away_the_sides_are() {
    let lift = |cells: usize| {
        let spacing = 0.05;
        let mut flight = problem([cells; 2], spacing, [[Side::FreeStream; 2]; 2]);
        let middle = 0.5 * cells as f64 * spacing;
        flight.bodies = vec![slip_body(slender([middle; 2]))];
        let (sine, cosine) = 0.035_f64.sin_cos();
        flight.free_stream.velocity = Vector::<2>::new(cosine, sine) * 0.5;
        let mut flow =
            FixedSimulation::new(refined(flight, Time::Settle, Refine::Levels(2))).unwrap();
        flow.settle(1500).unwrap();
        let force = flow.loads()[0].force;
        force[1] * cosine - force[0] * sine
    };
    let [small, large] = [48, 96].map(lift);
    assert!((small / large - 1.0).abs() < 0.03, "{small} {large}");
}
