//! Tips of cones about an axis: what presses on their walls from the first cells on, and which noses are none.

use std::sync::Arc;

use aero_geometry::outline::Piece;
use aero_geometry::{Outline, Placed, Placement, Revolution, Shape, Vector, bodies};

use super::flows::{nothing_is_made, stream};
use crate::fixed::FixedSimulation;
use crate::problem::{Problem, Side};

const DX: f64 = 0.04;

/// A stream along an axis, about the section of a body that is moved by parts of a spacing.
fn problem(mach: f64, section: Outline, moved: f64) -> Problem<2> {
    let place = Placement::default().moved(Vector::<2>::new(moved * DX, 0.0));
    let body: Arc<dyn Shape<2>> = Arc::new(Placed::new(section, place));
    let mut problem = stream(mach, [[-0.3, 0.0], [1.0, 1.2]], DX, vec![body]);
    problem.domain.sides[1][0] = Side::Axis;
    problem
}

fn cone(degrees: f64) -> Outline {
    bodies::cone(degrees, 3.0).unwrap().section().unwrap()
}

fn section(points: &[[f64; 2]]) -> Outline {
    let pieces = points.windows(2).map(|pair| {
        let [from, to] = [pair[0], pair[1]].map(Vector::from);
        Piece::segment(from, to)
    });
    Revolution::new(pieces.collect())
        .unwrap()
        .section()
        .unwrap()
}

fn has_apex(flow: &FixedSimulation<2>) -> bool {
    let mut roots = flow.net.blocks.iter().flat_map(|block| &block.roots);
    roots.any(|root| root.apex.is_some())
}

/// Taylor & Maccoll 1933; wherever in its cell the tip lies, and where the shock lies in the first cell over the wall all along.
#[test]
fn pressure_on_a_cone_is_right_from_the_third_cell_on() {
    for (mach, degrees, pressed, moved) in [
        (3.0, 20.0, 2.790_9, 0.5),
        (3.0, 20.0, 2.790_9, 0.0),
        (2.0, 10.0, 1.292_5, 0.23),
        (6.0, 9.588_225, 2.678_9, 0.8),
    ] {
        let mut flow = FixedSimulation::new(problem(mach, cone(degrees), moved)).unwrap();
        assert!(has_apex(&flow) && flow.settle(600).unwrap().is_settled);
        let surface = flow.surface();
        let each = surface.position.iter().zip(&surface.pressure);
        let wall = each.filter(|(foot, _)| foot[0] > (moved + 2.0) * DX && foot[0] < 0.9);
        let off: Vec<f64> = wall.map(|(_, p)| 1.4 * p / pressed - 1.0).collect();
        let mean = off.iter().sum::<f64>() / off.len() as f64;
        assert!(
            off.iter().all(|off| off.abs() < 0.012) && mean.abs() < 3e-3,
            "Mach {mach}, {degrees} degrees, {moved}: {mean} {off:?}"
        );
    }
}

/// Without its law the first cells are off by a tenth and more.
#[test]
fn cells_alone_do_not_know_the_tip_of_a_cone() {
    let mut flow = FixedSimulation::new(problem(3.0, cone(20.0), 0.5)).unwrap();
    for block in &mut flow.net.blocks {
        block.roots.clear();
    }
    flow.settle(600).unwrap();
    let surface = flow.surface();
    let each = surface.position.iter().zip(&surface.pressure);
    let wall = each.filter(|(foot, _)| (2.5 * DX..5.5 * DX).contains(&foot[0]));
    let off = wall.map(|(_, p)| (1.4 * p / 2.790_9 - 1.0).abs());
    assert!(off.fold(0.0, f64::max) > 0.05);
}

/// A ball, a flat face, a cone that the gas leaves at its tip, a nose that bends in its second cell, and a cone of too wide an angle.
#[test]
fn other_noses_are_no_tips_of_cones() {
    let ball = bodies::sphere(0.5).unwrap().section().unwrap();
    let flat = section(&[[0.0, 0.0], [0.0, 0.2], [2.0, 0.4], [2.0, 0.0]]);
    let tail = section(&[[-2.0, 0.0], [-2.0, 0.5], [0.5, 0.0]]);
    let bent = section(&[
        [0.0, 0.0],
        [0.012, 0.02],
        [0.2, 0.05],
        [2.0, 0.3],
        [2.0, 0.0],
    ]);
    for (name, body) in [
        ("ball", ball),
        ("flat", flat),
        ("tail", tail),
        ("bent", bent),
    ] {
        let flow = FixedSimulation::new(problem(3.0, body, 0.2)).unwrap();
        assert!(!has_apex(&flow), "{name}");
    }
    let wide = |has_roots: bool| {
        let mut flow = FixedSimulation::new(problem(3.0, cone(60.0), 0.3)).unwrap();
        if !has_roots {
            for block in &mut flow.net.blocks {
                block.roots.clear();
            }
        }
        flow.step(0.1).unwrap();
        flow.columns.held
    };
    assert_eq!(wide(true), wide(false));
}

/// A cone's wall is straight to its end; that of a nose of constant bend, until it has turned by a tenth of its angle to the axis.
#[test]
fn a_nose_is_a_cone_as_far_as_its_wall_is_straight() {
    const RADIUS: f64 = 6.25;
    const ANGLE: f64 = 0.3;
    let place = |turned: f64| {
        let angle = ANGLE - turned;
        let along = RADIUS * (ANGLE.sin() - angle.sin());
        [along, RADIUS * (angle.cos() - ANGLE.cos())]
    };
    let mut nose: Vec<[f64; 2]> = (0..=60).map(|n| place(0.005 * f64::from(n))).collect();
    let end = nose[60];
    nose.extend([[3.0, end[1]], [3.0, 0.0]]);
    let straight = |body: Outline| -> f64 {
        let flow = FixedSimulation::new(problem(3.0, body, 0.3)).unwrap();
        let mut roots = flow.net.blocks.iter().flat_map(|block| &block.roots);
        roots.find_map(|root| root.apex).expect("an apex")
    };
    assert!(straight(cone(20.0)).is_infinite());
    // It turns by as much over so many spacings.
    let expected = 0.1 * ANGLE * RADIUS / DX;
    let found = straight(section(&nose));
    assert!((found - expected).abs() < 1.5, "{found} {expected}");
}

/// Behind a shoulder five cells from the tip a fan weakens the shock, which is not where the tip says for long: far from there all is as if nothing were known
/// of it.
#[test]
fn a_shock_that_a_fan_has_overtaken_is_left_alone() {
    const FINE: f64 = 0.02;
    let height = 0.1 * f64::to_radians(25.0).tan();
    let rod = section(&[[0.0, 0.0], [0.1, height], [3.0, height], [3.0, 0.0]]);
    // Height of the shock at the outlet, in spacings.
    let height = |has_roots: bool| -> f64 {
        let bounds = [[-0.1, 0.0], [1.5, 0.9]];
        let mut problem = stream(3.0, bounds, FINE, vec![Arc::new(rod.clone())]);
        problem.domain.sides[1][0] = Side::Axis;
        let mut flow = FixedSimulation::new(problem).unwrap();
        assert!(has_apex(&flow));
        if !has_roots {
            for block in &mut flow.net.blocks {
                block.roots.clear();
            }
        }
        assert!(flow.settle(600).unwrap().is_settled);
        let each = flow.points.iter().zip(&flow.columns.states);
        let changed = each.filter(|(place, state)| {
            place[0] > 1.5 - FINE && (1.4 * state.pressure - 1.0).abs() > 0.02
        });
        changed.fold(0.0, |top: f64, (place, _)| top.max(place[1] / FINE))
    };
    let [with, without] = [true, false].map(height);
    assert!(
        with > 20.0 && (with - without).abs() < 1.5,
        "{with} {without}"
    );
}

/// The shock of a flare crosses that of the cone before it: from there on neither stands as at its root.
#[test]
fn a_march_about_a_cone_makes_nothing() {
    let flared = section(&[[0.0, 0.0], [0.4, 0.1], [2.0, 0.9], [2.0, 0.0]]);
    let mut flow = FixedSimulation::new(problem(3.0, flared, 0.3)).unwrap();
    assert!(has_apex(&flow));
    let before = flow.totals();
    while flow.time() < 0.8 {
        flow.step(0.8).unwrap();
    }
    nothing_is_made(&flow, &before);
}
