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
    assert!((wall - 0.5995).abs() < 0.01 * 0.4, "{wall}");
    let rise = Arc::new(bodies::compression_corner(0.0, 10.0).unwrap());
    let wall = landing::<2>(corner(2.0, rise, Side::FreeStream));
    assert!((wall - 1.7066).abs() < 0.01 * 0.7, "{wall}");
}

/// Pressure drag of a spindle in rings under a side this high, at Mach 1.5: of a tenth of its length in radius, a chord long.
fn spindle(height: f64) -> f64 {
    let spindle = Arc::new(bodies::biconvex(1.0, 0.2).unwrap());
    let mut problem = stream(1.5, [[-0.3, 0.0], [1.5, height]], 0.025, vec![spindle]);
    problem.domain.sides[1][0] = Side::Axis;
    let mut flow = FixedSimulation::new(problem).unwrap();
    flow.settle(800).unwrap();
    flow.loads()[0].force[0]
}

/// Nothing that the sides at six radii throw back meets it. At three, sides that thought waves plane took an eighth of its drag, at four they gave
/// a hundredth.
#[test]
fn waves_about_an_axis_thin_out_beyond_the_side() {
    let free = spindle(0.6);
    for height in [0.3, 0.4] {
        let off = spindle(height) / free - 1.0;
        assert!(off.abs() < 0.015, "{height}: {off}");
    }
}

/// A stream with nothing in its way goes through all sides undisturbed, at any angle, in the plane, in rings and in space.
#[test]
fn the_stream_passes_undisturbed() {
    fn passes<const D: usize>(problem: Problem<D>) {
        let stream = problem.free_stream;
        let mut flow = FixedSimulation::new(problem).unwrap();
        for _ in 0..20 {
            flow.step(f64::INFINITY).unwrap();
        }
        let frame = flow.frame();
        let off = frame
            .pressure
            .iter()
            .map(|p| (p / stream.pressure - 1.0).abs());
        assert!(off.fold(0.0, f64::max) < 1e-13);
    }
    let mut aslant = stream::<2>(1.5, [[0.0; 2], [1.0; 2]], 0.1, Vec::new());
    aslant.free_stream.velocity[1] = 0.3;
    aslant.domain.sides[1] = [Side::FreeStream; 2];
    passes(aslant);
    let mut rings = stream::<2>(1.5, [[0.0; 2], [1.0; 2]], 0.1, Vec::new());
    rings.domain.sides[1][0] = Side::Axis;
    passes(rings);
    let mut space = stream::<3>(1.5, [[0.0; 3], [1.0; 3]], 0.2, Vec::new());
    space.free_stream.velocity[2] = -0.4;
    passes(space);
}
