//! Walls with sharp bends: what presses on them in the first cells behind, and that the flow over them comes to rest.

use std::sync::Arc;

use aero_geometry::{Placed, Placement, Shape, Vector, bodies};

use super::flows::{nothing_is_made, stream};
use crate::fixed::FixedSimulation;
use crate::gas::Gas;
use crate::problem::{Problem, Side};

/// A stream over a corner, in places of the lattice.
struct Corner {
    mach: f64,
    degrees: f64,
    gamma: f64,
    dx: f64,
    moved: [f64; 2],
}

impl Corner {
    fn new(mach: f64, degrees: f64) -> Self {
        Self {
            mach,
            degrees,
            gamma: 1.4,
            dx: 0.05,
            moved: [0.0; 2],
        }
    }

    fn problem(&self) -> Problem<2> {
        let corner: Arc<dyn Shape<2>> =
            Arc::new(bodies::expansion_corner(0.0, self.degrees).unwrap());
        let place = Placement::default().moved(Vector::from(self.moved) * self.dx);
        let corner = Arc::new(Placed::new(corner, place));
        let bounds = [[-0.3, -0.6], [0.8, 0.8]];
        let mut problem = stream(self.mach, bounds, self.dx, vec![corner]);
        problem.domain.sides[1][0] = Side::Body;
        problem.gas = Gas::ideal(self.gamma);
        problem.free_stream.pressure = 1.0 / self.gamma;
        problem
    }

    /// Distance behind the corner, in spacings, and pressure over the stream's of each wall.
    fn wall(&self, flow: &FixedSimulation<2>) -> Vec<[f64; 2]> {
        let (sine, cosine) = self.degrees.to_radians().sin_cos();
        let surface = flow.surface();
        let each = surface.position.iter().zip(&surface.pressure);
        each.map(|(foot, pressure)| {
            let [x, y] = [0, 1].map(|k| foot[k] / self.dx - self.moved[k]);
            [x * cosine - y * sine, pressure * self.gamma]
        })
        .collect()
    }

    /// Largest departure of the wall pressure from `fan`, of the part `behind` the corner.
    fn off(&self, flow: &FixedSimulation<2>, fan: f64, behind: [f64; 2]) -> f64 {
        let wall = self.wall(flow);
        let there = wall
            .iter()
            .filter(|[at, _]| (behind[0]..behind[1]).contains(at));
        there.fold(0.0, |most: f64, [_, p]| most.max((p / fan - 1.0).abs()))
    }
}

/// Prandtl and Meyer [NACA Report 1135 (1953)], at any spacing and wherever in its cell the corner lies.
#[test]
fn wall_pressure_is_right_from_the_first_cell_behind_a_sharp_bend() {
    let moved = |mach, degrees, moved| Corner {
        moved,
        ..Corner::new(mach, degrees)
    };
    let of = |gamma| Corner {
        gamma,
        ..Corner::new(2.0, 15.0)
    };
    for (corner, fan) in [
        (Corner::new(2.0, 15.0), 0.393_07),
        (moved(2.0, 15.0, [0.3, 0.7]), 0.393_07),
        (Corner::new(2.0, 20.0), 0.275_18),
        (Corner::new(4.0, 15.0), 0.173_74),
        (moved(4.0, 10.0, [0.5, 0.5]), 0.330_08),
        (Corner::new(3.0, 30.0), 0.048_18),
        (moved(3.0, 30.0, [0.4, 0.7]), 0.048_18),
        (of(1.2), 0.457_97),
        (of(1.67), 0.315_01),
    ] {
        for dx in [0.05, 0.025] {
            let corner = Corner { dx, ..corner };
            let mut flow = FixedSimulation::new(corner.problem()).unwrap();
            assert!(flow.settle(300).unwrap().is_settled);
            let off = corner.off(&flow, fan, [0.1, 4.0]);
            let Corner { mach, degrees, .. } = corner;
            assert!(off < 0.03, "Mach {mach}, {degrees} degrees, {dx}: {off}");
        }
    }
}

/// A fast stream's fan lies close to the wall, and cells see it late: at Mach 10 and 5 degrees within six of them at thirty spacings.
#[test]
fn wall_pressure_is_right_as_far_as_cells_are_too_coarse_for_the_fan() {
    for (mach, degrees, fan) in [(6.0, 10.0, 0.184_274), (10.0, 5.0, 0.257_960)] {
        for moved in [[0.0; 2], [0.26, 0.42]] {
            let corner = Corner {
                moved,
                ..Corner::new(mach, degrees)
            };
            let mut flow = FixedSimulation::new(corner.problem()).unwrap();
            assert!(flow.settle(300).unwrap().is_settled);
            let off = corner.off(&flow, fan, [4.0, 15.0]);
            assert!(off < 0.03, "Mach {mach}, {degrees} degrees: {off}");
        }
    }
}

#[test]
fn a_march_comes_to_the_same_fan() {
    let corner = Corner::new(2.0, 20.0);
    let mut flow = FixedSimulation::new(corner.problem()).unwrap();
    let before = flow.totals();
    while flow.time() < 2.0 {
        flow.step(2.0).unwrap();
    }
    let off = corner.off(&flow, 0.275_18, [0.1, 6.0]);
    assert!(off < 0.03, "{off}");
    nothing_is_made(&flow, &before);
}

/// A body that is its own mirror image across the stream, and the whole scene turned by a quarter, know of no difference.
#[test]
fn fans_are_alike_in_a_mirror_and_when_turned() {
    let points = [[-0.4, 0.0], [0.0, 0.1], [0.4, 0.0], [0.0, -0.1]];
    let marched = |turned: bool| {
        let place = |[x, y]: [f64; 2]| if turned { [-y, x] } else { [x, y] };
        let outline = bodies::polygon(&points.map(|point| Vector::from(place(point)))).unwrap();
        let size = if turned { [0.5, 0.8] } else { [0.8, 0.5] };
        let bounds = [size.map(|half: f64| -half), size];
        let mut problem = stream(2.5, bounds, 0.025, vec![Arc::new(outline)]);
        if turned {
            problem.domain.sides.swap(0, 1);
            problem.free_stream.velocity = Vector::<2>::new(0.0, 2.5);
        }
        let mut flow = FixedSimulation::new(problem).unwrap();
        while flow.time() < 1.2 {
            flow.step(1.2).unwrap();
        }
        let surface = flow.surface();
        let each = surface.position.iter().zip(&surface.pressure);
        let back = |x: &[f64; 3]| if turned { [x[1], -x[0]] } else { [x[0], x[1]] };
        each.map(|(place, pressure)| (back(place), *pressure))
            .collect::<Vec<_>>()
    };
    let (flow, turned) = (marched(false), marched(true));
    let at = |walls: &[([f64; 2], f64)], place: [f64; 2]| {
        let away = |x: &[f64; 2]| (x[0] - place[0]).hypot(x[1] - place[1]);
        let nearest = walls
            .iter()
            .min_by(|a, b| away(&a.0).total_cmp(&away(&b.0)));
        let (found, pressure) = nearest.unwrap();
        assert!(away(found) < 1e-6);
        *pressure
    };
    // The walls of the tips themselves are slivers, and so is what rounding leaves at the ridge, on an edge of cells, of the face beyond.
    let walls = flow
        .iter()
        .filter(|([x, _], _)| (1e-6..0.39).contains(&x.abs()));
    for ([x, y], pressure) in walls {
        let off = at(&flow, [*x, -y]) / pressure - 1.0;
        assert!(off.abs() < 1e-6, "mirror, ({x}, {y}): {off}");
        let off = at(&turned, [*x, *y]) / pressure - 1.0;
        assert!(off.abs() < 1e-6, "turned, ({x}, {y}): {off}");
    }
    // Behind an oblique shock and a fan of twice the angle, over the first cells behind the ridge (NACA Report 1135).
    let behind = flow.iter().filter(|([x, _], _)| (0.02..0.1).contains(x));
    for (place, pressure) in behind {
        let off = pressure * 1.4 / RIDGE - 1.0;
        assert!(off.abs() < 0.04, "{place:?}: {off}");
    }
}

/// Pressure over the stream's at Mach 2.5 behind a shock that turns it by `atan(1 / 4)` and a fan that turns it back by twice that.
const RIDGE: f64 = 0.363_51;

/// A ramp that ends in a flat: a flow that turns to its wall and away from it comes to rest as soon as that over the ramp alone.
#[test]
fn flows_over_ramps_that_end_come_to_rest() {
    let rise = 0.6 * f64::to_radians(15.0).tan();
    for end in [[3.0, rise], [3.0, -0.25]] {
        let points = [
            [-3.0, 0.0],
            [0.0, 0.0],
            [0.6, rise],
            end,
            [3.0, -3.0],
            [-3.0, -3.0],
        ];
        let outline = bodies::polygon(&points.map(Vector::from)).unwrap();
        let bounds = [[-0.5, end[1].min(0.0)], [2.0, 1.2]];
        let mut problem = stream(2.5, bounds, 0.05, vec![Arc::new(outline)]);
        problem.domain.sides[1][0] = Side::Body;
        let mut flow = FixedSimulation::new(problem).unwrap();
        let settled = flow.settle(300).unwrap();
        assert!(
            settled.is_settled && settled.iterations < 110,
            "{settled:?}"
        );
    }
}

/// A stream over a ramp whose foot is so many spacings off the lattice; the walls before it, each with its distance in spacings and its
/// pressure over the stream's.
fn before_a_ramp(
    [mach, degrees, gamma]: [f64; 3],
    moved: [f64; 2],
    settles: bool,
) -> Vec<[f64; 2]> {
    let dx = 0.05;
    let ramp: Arc<dyn Shape<2>> = Arc::new(bodies::compression_corner(0.0, degrees).unwrap());
    let place = Placement::default().moved(Vector::from(moved) * dx);
    let bounds = [[-0.4, 0.0], [0.8, 0.8]];
    let mut problem = stream(mach, bounds, dx, vec![Arc::new(Placed::new(ramp, place))]);
    problem.domain.sides[1][0] = Side::Body;
    problem.gas = Gas::ideal(gamma);
    problem.free_stream.pressure = 1.0 / gamma;
    let mut flow = FixedSimulation::new(problem).unwrap();
    if settles {
        assert!(flow.settle(400).unwrap().is_settled);
    } else {
        while flow.time() < 0.6 {
            flow.step(0.6).unwrap();
        }
    }
    let surface = flow.surface();
    let each = surface.position.iter().zip(&surface.pressure);
    let walls = each.map(|(foot, pressure)| [moved[0] - foot[0] / dx, pressure * gamma]);
    walls
        .filter(|[away, _]| (0.0..6.0).contains(away))
        .collect()
}

/// Nothing comes upstream where the shock stands at the foot, wherever in its cell that lies.
#[test]
fn walls_before_a_sharp_concave_bend_feel_nothing_of_it() {
    for (flow, moved) in [
        ([2.5, 20.0, 1.4], [0.3, 0.2]),
        ([5.0, 20.0, 1.4], [0.5, 0.0]),
        ([10.0, 20.0, 1.4], [0.8, 0.7]),
        ([8.0, 30.0, 1.4], [0.3, 0.0]),
        ([8.0, 30.0, 1.4], [0.0, 0.0]),
        ([3.0, 12.0, 1.67], [0.6, 0.4]),
    ] {
        let walls = before_a_ramp(flow, moved, true);
        assert!(walls.len() > 4, "{walls:?}");
        for [away, pressure] in walls {
            assert!(
                (pressure - 1.0).abs() < 2e-3,
                "{flow:?}, {moved:?}: {pressure} at {away}"
            );
        }
    }
    for [away, pressure] in before_a_ramp([5.0, 20.0, 1.4], [0.5, 0.3], false) {
        assert!((pressure - 1.0).abs() < 2e-3, "{pressure} at {away}");
    }
}

/// A shock that the ramp is too steep for stands ahead of it.
#[test]
fn walls_before_a_ramp_that_pushes_its_shock_ahead_feel_it() {
    let walls = before_a_ramp([2.0, 28.0, 1.4], [0.3, 0.2], false);
    let nearest = walls.iter().min_by(|a, b| a[0].total_cmp(&b[0])).unwrap();
    assert!(nearest[1] > 2.0, "{nearest:?}");
}

/// The bottom of a half wedge lies along the stream, and nothing below it knows of the fan at the bend of its top: through the body that made three times
/// the pressure there.
#[test]
fn no_fan_acts_through_a_body() {
    let corners = [[-0.5, 0.0], [0.5, 0.0], [0.5, 0.1], [0.1, 0.1]];
    let wedge = bodies::polygon(&corners.map(Vector::<2>::from)).unwrap();
    let bounds = [[-0.7, -0.5], [0.7, 0.6]];
    let mut flow = FixedSimulation::new(stream(4.0, bounds, 0.025, vec![Arc::new(wedge)])).unwrap();
    assert!(flow.net.blocks.iter().any(|block| !block.bends.is_empty()));
    flow.settle(400).unwrap();
    let surface = flow.surface();
    let mut seen = 0;
    for (foot, pressure) in surface.position.iter().zip(&surface.pressure) {
        if foot[1] < 1e-6 && foot[0].abs() < 0.45 {
            seen += 1;
            let over = pressure * 1.4;
            assert!((over - 1.0).abs() < 5e-3, "{foot:?} {over}");
        }
    }
    assert!(seen > 30);
}
