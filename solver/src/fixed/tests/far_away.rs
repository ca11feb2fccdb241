//! What bodies do to a stream slower than sound, far away.

use aero_geometry::bodies;

use super::adapting::{refined, slender};
use super::lattice::problem;
use super::*;
use crate::fixed::FixedSimulation;
use crate::fixed::beyond::Beyond;
use crate::method::{Refine, Time};
use crate::sides::Place;
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
            FixedSimulation::new(refined(flight, Time::Settle, Refine::Levels(1))).unwrap();
        flow.settle(1500).unwrap();
        let force = flow.loads()[0].force;
        force[1] * cosine - force[0] * sine
    };
    let [small, large] = [48, 96].map(lift);
    assert!((small / large - 1.0).abs() < 0.03, "{small} {large}");
}

/// A circle in the middle of a box of eight radii, in a stream along it at this Mach number.
fn around_circle(mach: f64, refine: Refine) -> FixedSimulation<2> {
    let mut flight = problem([48; 2], 1.0 / 3.0, [[Side::FreeStream; 2]; 2]);
    let shape = bodies::circle(2.0).unwrap();
    let place = aero_geometry::Placement::default().moved(Vector::from([8.0, 8.0]));
    flight.bodies = vec![slip_body(Arc::new(aero_geometry::Placed::new(
        shape, place,
    )))];
    flight.free_stream.velocity = Vector::<2>::new(mach, 0.0);
    let mut flow = FixedSimulation::new(refined(flight, Time::Settle, refine)).unwrap();
    flow.settle(1500).unwrap();
    flow
}

/// Sides three radii ahead are reached by what a circle does to the stream: held as it is beyond them it came in with a third more of the dynamic
/// pressure than it has.
#[test]
fn gas_before_a_body_has_the_total_pressure_of_the_stream() {
    let mach = 0.3;
    let frame = around_circle(mach, Refine::Levels(0)).frame();
    let rest = |mach: f64| (1.0 + 0.2 * mach * mach).powf(3.5);
    let whole = rest(mach) / 1.4;
    let before = (0..frame.kind.len()).filter(|&i| frame.position[i][0] < 5.5);
    for i in before {
        let off = frame.pressure[i] * rest(frame.mach[i]) - whole;
        assert!(
            off.abs() < 0.015 * 0.5 * mach * mach,
            "{off} {:?}",
            frame.position[i]
        );
    }
}

/// What bodies cost slows all of a duct's gas if its side holds the total state alone.
#[test]
fn a_duct_keeps_the_speed_of_its_stream() {
    let beyond = |above: Side| {
        let sides = [[Side::FreeStream; 2], [Side::Symmetry, above]];
        let mut flight = problem([4; 2], 0.25, sides);
        flight.free_stream.velocity = Vector::<2>::new(0.3, 0.0);
        let flight = refined(flight, Time::Settle, Refine::Levels(0));
        let place = Place::whole(&flight.domain, 0, 0);
        Beyond::of(&flight, Side::FreeStream, place).unwrap()
    };
    assert!(matches!(beyond(Side::Symmetry), Beyond::Stream(_)));
    assert!(matches!(beyond(Side::FreeStream), Beyond::Total(_)));
}
