//! More points than there is memory for are refused before any are made, and a run that would add them stops as it stands.

use super::adapting::blast;
use crate::fixed::FixedSimulation;
use crate::method::{Method, Refine};

fn roomy(refine: Refine, room: u64) -> Result<FixedSimulation<2>, String> {
    let mut blast = blast(refine);
    if let Method::Fixed(points) = &mut blast.method {
        points.room = Some(room);
    }
    FixedSimulation::new(blast)
}

fn points(flow: &FixedSimulation<2>) -> u64 {
    flow.points_per_level().into_iter().sum::<usize>() as u64
}

#[test]
fn bodies_that_ask_for_more_points_than_there_is_room_for_are_refused() {
    let around_bodies = Refine::Apart {
        flow: 0,
        bodies: 4,
        bends: 4,
    };
    let all = points(&roomy(around_bodies, u64::MAX).unwrap());
    // Cells in bodies count as well.
    assert!(roomy(around_bodies, 2 * all).is_ok());
    let Err(refused) = roomy(around_bodies, all / 2) else {
        panic!("no refusal");
    };
    for word in ["the bodies ask", "scheme.refine = { points ="] {
        assert!(refused.contains(word), "{refused}");
    }
    // A number of points is what there is room for.
    assert!(roomy(Refine::Points(all / 2), all / 2).is_ok());
}

#[test]
fn a_flow_that_asks_for_more_points_than_there_is_room_for_stops_as_it_stands() {
    let start = points(&roomy(Refine::Levels(2), u64::MAX).unwrap());
    let mut flow = roomy(Refine::Levels(2), start + start / 10).unwrap();
    let failure = (0..60).find_map(|_| flow.step(1e9).err());
    let failure = failure.expect("more points");
    assert!(failure.reason.contains("the flow asks"), "{failure:?}");
    assert!(failure.step > 0 && points(&flow) <= start + start / 10);
    assert!(flow.totals().mass.is_finite());
}
