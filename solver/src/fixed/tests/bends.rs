//! Walls with a sharp bend: what presses on them around it, and what is shown of that.

use std::sync::Arc;

use aero_geometry::{Placed, Placement, Shape, Vector, bodies};

use super::flows::stream;
use crate::fixed::FixedSimulation;
use crate::problem::Side;

/// Behind an expansion corner the wall pressure is that of the fan [NACA Report 1135 (1953)] from four spacings on, wherever in its cell the
/// corner lies: the error is one of the cells next to it, at any spacing.
#[test]
fn wall_pressure_is_right_a_few_cells_behind_a_sharp_bend() {
    for (mach, degrees, fan, moved, dx, within) in [
        (2.0, 15.0, 0.393_07, [0.0, 0.0], 0.05, 0.02),
        (2.0, 15.0, 0.393_07, [0.0, 0.0], 0.025, 0.02),
        (2.0, 15.0, 0.393_07, [0.3, 0.2], 0.05, 0.03),
        (2.0, 20.0, 0.275_18, [0.0, 0.0], 0.05, 0.03),
        (4.0, 10.0, 0.330_08, [0.5, 0.5], 0.05, 0.05),
    ] {
        let down = f64::to_radians(degrees);
        let corner: Arc<dyn Shape<2>> = Arc::new(bodies::expansion_corner(0.0, degrees).unwrap());
        let place = Placement::default().moved(Vector::from(moved) * dx);
        let corner = Arc::new(Placed::new(corner, place));
        let mut problem = stream(mach, [[-0.3, -0.4], [1.0, 1.0]], dx, vec![corner]);
        problem.domain.sides[1][0] = Side::Body;
        let mut flow = FixedSimulation::new(problem).unwrap();
        assert!(flow.settle(1000).unwrap().is_settled);
        let surface = flow.surface();
        for (foot, p) in surface.position.iter().zip(&surface.pressure) {
            let from = [foot[0] / dx - moved[0], foot[1] / dx - moved[1]];
            let cells = from[0] * down.cos() - from[1] * down.sin();
            let (ratio, allowed) = match cells {
                4.0.. => (fan, within),
                1.0.. => (fan, 0.25),
                _ => continue,
            };
            let off = p * 1.4 / ratio - 1.0;
            let flow = format!("Mach {mach}, {degrees} degrees, {moved:?}");
            assert!(
                off.abs() < allowed,
                "{flow}: {cells} cells of {dx} behind: {off}"
            );
        }
    }
}

/// What a surface shows of a wall does not reach round a bend: right behind one it does not rise towards what is before it.
#[test]
fn what_surfaces_show_ends_at_an_edge() {
    let corner = Arc::new(bodies::expansion_corner(0.0, 10.0).unwrap());
    let mut problem = stream(4.0, [[-0.5, -0.6], [1.5, 1.0]], 0.05, vec![corner]);
    problem.domain.sides[1][0] = Side::Body;
    let mut flow = FixedSimulation::new(problem).unwrap();
    flow.settle(1000).unwrap();
    let panels = flow.panels();
    let first = (0..panels.area.len()).find(|&n| {
        let ends = [0, 1].map(|end| panels.points[2 * n + end][0]);
        let [low, high] = [ends[0].min(ends[1]), ends[0].max(ends[1])];
        low > -1e-9 && low < 1e-9 && high > 0.01
    });
    // Prandtl and Meyer: 0.330 08 of the stream's pressure.
    let off = panels.pressure[first.unwrap()] * 1.4 / 0.330_08 - 1.0;
    assert!(off.abs() < 0.18, "{off}");
}
