//! Waves that leave a stream faster than sound by the sides that it goes along.

use std::sync::Arc;

use aero_geometry::{Shape, bodies};

use super::flows::stream;
use crate::fixed::FixedSimulation;
use crate::problem::{Problem, Side};

/// Height of the box before the corner.
const HEIGHT: f64 = 0.5;

/// A wall with a corner under a side that the wave from it leaves by; its slab in space has two mirrors.
fn corner<const D: usize>(mach: f64, wall: Arc<dyn Shape<D>>, top: Side) -> Problem<D> {
    let (mut min, mut max) = ([-0.2; D], [0.15; D]);
    (max[0], max[1]) = (2.2, HEIGHT);
    min[1] = -0.55;
    let mut problem = stream(mach, [min, max], 0.05, vec![wall]);
    for side in &mut problem.domain.sides[1..] {
        *side = [Side::Symmetry; 2];
    }
    problem.domain.sides[1] = [Side::Body, top];
    problem
}

/// Mean pressure, over the stream's, on the wall where what comes back of the wave lands.
fn landing<const D: usize>(problem: Problem<D>) -> f64 {
    let mut flow = FixedSimulation::new(problem).unwrap();
    flow.settle(600).unwrap();
    let surface = flow.surface();
    let places = surface.position.iter().zip(&surface.pressure);
    let landed: Vec<f64> = places
        .filter(|(foot, _)| (1.1..1.8).contains(&foot[0]))
        .map(|(_, pressure)| 1.4 * pressure)
        .collect();
    assert!(landed.len() > 10);
    landed.iter().sum::<f64>() / landed.len() as f64
}

/// Behind corners of ten degrees: a fan at Mach 1.5 and a shock at Mach 2 [NACA Report 1135 (1953), tables and charts].
#[test]
fn waves_of_a_corner_do_not_come_back_from_the_side() {
    let fall = Arc::new(bodies::expansion_corner(0.0, 10.0).unwrap());
    let wall = landing::<2>(corner(1.5, fall, Side::FreeStream));
    println!("{wall}");
    assert!((wall - 0.5995).abs() < 0.01 * 0.4, "{wall}");
    let rise = Arc::new(bodies::compression_corner(0.0, 10.0).unwrap());
    let wall = landing::<2>(corner(2.0, rise, Side::FreeStream));
    println!("{wall}");
    assert!((wall - 1.7066).abs() < 0.01 * 0.7, "{wall}");
}
