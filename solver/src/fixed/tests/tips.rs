//! Tips that part a stream: on each side a shock or a fan stands that cells next to it are too coarse for.

use std::sync::Arc;

use aero_geometry::{Placed, Placement, Vector, bodies};

use super::flows::{nothing_is_made, stream};
use crate::fixed::FixedSimulation;
use crate::problem::{Problem, Side};

/// A wedge in a stream, and what presses on its sides.
#[derive(Clone, Copy)]
struct Wedge {
    mach: f64,
    /// Degrees by which the upper side and the lower one turn into the stream.
    degrees: [f64; 2],
    /// Pressure on these over the stream's.
    pressed: [f64; 2],
    /// In spacings.
    moved: [f64; 2],
}

const DX: f64 = 0.04;

impl Wedge {
    /// Its tip is next to the origin.
    fn problem(&self) -> Problem<2> {
        let [upper, lower] = self.degrees.map(|degrees| 2.0 * degrees.to_radians().tan());
        let points = [[0.0, 0.0], [2.0, -lower], [2.0, upper]];
        let body = bodies::polygon(&points.map(Vector::from)).unwrap();
        let place = Placement::default().moved(Vector::from(self.moved) * DX);
        let body = Arc::new(Placed::new(Arc::new(body), place));
        stream(self.mach, [[-0.2, -1.0], [1.0, 1.0]], DX, vec![body])
    }

    /// Farthest off of the pressure on the upper and on the lower side, from the tip on. Walls shorter than a hundredth of a spacing may stand across
    /// the tip.
    fn off(&self, flow: &FixedSimulation<2>) -> [f64; 2] {
        let mut off = [0.0_f64; 2];
        for (wall, pressure) in flow.walls() {
            if wall.image.share > 0.01 * DX {
                let side = usize::from(wall.image.normal[1] > 0.0);
                let ratio = 1.4 * pressure / self.pressed[side];
                off[side] = off[side].max((ratio - 1.0).abs());
            }
        }
        off
    }
}

/// NACA Report 1135 (1953), eqs 44, 128, 150 and 171c.
#[test]
fn pressure_on_a_wedge_is_right_from_its_tip_on() {
    for (mach, degrees, pressed, moved, allowed) in [
        (2.5, [10.0, 10.0], [1.863_87; 2], [0.5, 0.5], 0.01),
        (2.5, [10.0, 10.0], [1.863_87; 2], [0.3, 0.2], 0.01),
        (2.5, [10.0, 10.0], [1.863_87; 2], [0.0, 0.0], 0.01),
        (3.0, [15.0, 5.0], [2.821_56, 1.453_98], [0.4, 0.6], 0.01),
        (8.0, [20.0, 20.0], [14.822_66; 2], [0.4, 0.1], 0.01),
        // A side along the stream, and sides that turn away from it.
        (5.0, [12.0, 0.0], [3.676_58, 1.0], [0.1, 0.7], 0.01),
        (3.0, [15.0, -4.0], [2.821_56, 0.725_634], [0.2, 0.2], 0.01),
        (8.0, [12.0, -8.0], [6.659_75, 0.165_512], [0.6, 0.3], 0.05),
    ] {
        let wedge = Wedge {
            mach,
            degrees,
            pressed,
            moved,
        };
        let mut flow = FixedSimulation::new(wedge.problem()).unwrap();
        let is_settled = flow.settle(400).unwrap().is_settled;
        assert!(is_settled, "Mach {mach}, {degrees:?} degrees");
        let off = wedge.off(&flow);
        assert!(
            off.iter().all(|off| *off < allowed),
            "Mach {mach}, {degrees:?} degrees: {off:?}"
        );
    }
}

/// In rings, a lip that is thin beside its radius begins as in the plane.
#[test]
fn pressure_on_a_lip_around_an_axis_is_that_of_the_plane_at_its_tip() {
    let rise = f64::to_radians(10.0).tan();
    let points = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0 * rise]];
    let lip = bodies::polygon(&points.map(Vector::from)).unwrap();
    let place = Placement::default().moved(Vector::from([0.3 * DX, 0.6 + 0.4 * DX]));
    let lip = Arc::new(Placed::new(Arc::new(lip), place));
    let mut problem = stream(2.5, [[-0.2, 0.0], [0.8, 1.6]], DX, vec![lip]);
    problem.domain.sides[1][0] = Side::Axis;
    let mut flow = FixedSimulation::new(problem).unwrap();
    assert!(flow.settle(400).unwrap().is_settled);
    for (wall, pressure) in flow.walls() {
        let is_first = wall.foot[0] < 2.5 * DX && wall.image.share > 0.01 * DX;
        let expected = if wall.image.normal[1] > 0.0 {
            1.0
        } else {
            1.863_87
        };
        let off = 1.4 * pressure / expected - 1.0;
        assert!(!is_first || off.abs() < 0.02, "{off} at {}", wall.foot);
    }
}

#[test]
fn a_march_about_a_tip_makes_nothing() {
    let wedge = Wedge {
        mach: 3.0,
        degrees: [15.0, -4.0],
        pressed: [2.821_56, 0.725_634],
        moved: [0.2, 0.2],
    };
    let mut flow = FixedSimulation::new(wedge.problem()).unwrap();
    let before = flow.totals();
    while flow.time() < 1.5 {
        flow.step(1.5).unwrap();
    }
    let off = wedge.off(&flow);
    assert!(off.iter().all(|off| *off < 0.01), "{off:?}");
    nothing_is_made(&flow, &before);
}

/// Ends of plates, and of a wedge that a face half a spacing high cuts off, are none, nor is the end of a diamond that the stream leaves.
#[test]
fn only_sharp_ends_of_bodies_are_tips() {
    let found = |points: &[[f64; 2]]| {
        let points: Vec<_> = points.iter().map(|point| Vector::from(*point)).collect();
        let body = Arc::new(bodies::polygon(&points).unwrap());
        let flow =
            FixedSimulation::new(stream(2.0, [[-0.4, -0.6], [1.2, 0.6]], DX, vec![body])).unwrap();
        let roots = flow.net.blocks.iter().flat_map(|block| &block.roots);
        let mut at: Vec<f64> = roots.map(|root| root.bends[0].at[0]).collect();
        at.sort_by(f64::total_cmp);
        at.dedup_by(|a, b| (*a - *b).abs() < 1e-6);
        at
    };
    let half = 0.25 * DX;
    let plate = [[0.0, -half], [0.8, -half], [0.8, half], [0.0, half]];
    assert!(found(&plate).is_empty());
    let cut = [[0.0, -half], [2.0, -0.5], [2.0, 0.5], [0.0, half]];
    assert!(found(&cut).is_empty());
    let at = found(&[[0.0, 0.01], [0.4, -0.05], [0.8, 0.01], [0.4, 0.07]]);
    assert!(at.len() == 1 && at[0].abs() < 1e-6, "{at:?}");
}

/// A stream that is slower than sound, one that a shock ahead of the tip slows down, and one that leaves the tip.
#[test]
fn flows_that_no_tip_parts_know_nothing_of_it() {
    for (mach, degrees, backwards) in [
        (0.8, [10.0; 2], false),
        (2.0, [28.0; 2], false),
        (2.5, [10.0; 2], true),
    ] {
        let wedge = Wedge {
            mach,
            degrees,
            pressed: [1.0; 2],
            moved: [0.3, 0.2],
        };
        let flown = |has_tip: bool| {
            let mut problem = wedge.problem();
            if backwards {
                problem.domain.sides[0].reverse();
                problem.free_stream.velocity = -problem.free_stream.velocity;
            }
            let mut flow = FixedSimulation::new(problem).unwrap();
            let blocks = &mut flow.net.blocks;
            assert!(backwards != blocks.iter().any(|block| !block.roots.is_empty()));
            if !has_tip {
                for block in blocks {
                    block.roots.clear();
                    block.bends.clear();
                }
            }
            for _ in 0..5 {
                flow.step(1.0).unwrap();
            }
            flow.columns.held
        };
        assert_eq!(
            flown(true),
            flown(false),
            "Mach {mach}, {degrees:?} degrees"
        );
    }
}
