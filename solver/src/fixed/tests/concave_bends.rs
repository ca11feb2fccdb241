//! Walls with sharp concave bends: a shock stands there that cells next to it are too coarse for.

use std::sync::Arc;

use aero_geometry::{Placed, Placement, Shape, Vector, bodies};

use super::flows::{nothing_is_made, stream};
use super::lattice::WALL;
use crate::fixed::FixedSimulation;
use crate::gas::Gas;
use crate::problem::{Problem, Side};

/// A stream over a wall that turns to it, and what stands behind the shock there [NACA Report 1135 (1953), eqs 128, 129 and 150].
#[derive(Clone, Copy)]
struct Ramp {
    mach: f64,
    degrees: f64,
    gamma: f64,
    /// Density and pressure behind the shock over those in front.
    behind: [f64; 2],
    /// In spacings.
    moved: [f64; 2],
}

const DX: f64 = 0.04;

impl Ramp {
    const fn new(mach: f64, degrees: f64, behind: [f64; 2], moved: [f64; 2]) -> Self {
        Self {
            mach,
            degrees,
            gamma: 1.4,
            behind,
            moved,
        }
    }

    /// The ramp in one piece with the wall before it.
    fn problem(&self) -> Problem<2> {
        self.problem_on(Side::Body)
    }

    /// The ramp alone on a `side`, or in one piece with the wall before it.
    fn problem_on(&self, side: Side) -> Problem<2> {
        let body: Arc<dyn Shape<2>> = if matches!(side, Side::Body) {
            Arc::new(bodies::compression_corner(0.0, self.degrees).unwrap())
        } else {
            let height = 3.0 * self.degrees.to_radians().tan();
            let points = [[0.0, -0.5], [3.0, -0.5], [3.0, height], [0.0, 0.0]];
            Arc::new(bodies::polygon(&points.map(Vector::from)).unwrap())
        };
        let place = Placement::default().moved(Vector::from(self.moved) * DX);
        let bounds = [[-0.3, 0.0], [0.9, 1.0]];
        let mut problem = stream(
            self.mach,
            bounds,
            DX,
            vec![Arc::new(Placed::new(body, place))],
        );
        problem.domain.sides[1][0] = side;
        problem.gas = Gas::ideal(self.gamma);
        problem.free_stream.pressure = 1.0 / self.gamma;
        problem
    }

    /// Farthest off of the pressure on the wall behind the bend, from the first cell on.
    fn off(&self, flow: &FixedSimulation<2>) -> f64 {
        let surface = flow.surface();
        let each = surface.position.iter().zip(&surface.pressure);
        let behind = each.filter(|(foot, _)| foot[0] > self.moved[0] * DX + 1e-9);
        let off = behind.map(|(_, p)| (p * self.gamma / self.behind[1] - 1.0).abs());
        off.fold(0.0, f64::max)
    }

    /// Farthest off of the density in the row of cells along the wall, from where the shock has left it on.
    fn off_in_row(&self, flow: &FixedSimulation<2>) -> f64 {
        let (sine, cosine) = self.degrees.to_radians().sin_cos();
        let each = flow.points.iter().zip(&flow.columns.held);
        let seen = each.map(|(place, held)| {
            let [x, y] = [0, 1].map(|k| place[k] / DX - self.moved[k]);
            [
                x * cosine + y * sine,
                y * cosine - x * sine,
                held.mass / self.behind[0] - 1.0,
            ]
        });
        let row = seen.filter(|[along, height, _]| *along > 15.0 && *height < 1.0);
        row.fold(0.0, |most: f64, [.., off]| most.max(off.abs()))
    }
}

/// At any Mach number, wherever in its cell the bend lies.
#[test]
fn gas_at_the_wall_is_right_from_the_first_cell_behind_a_sharp_concave_bend() {
    let light = Ramp {
        gamma: 5.0 / 3.0,
        ..Ramp::new(3.0, 12.0, [1.754_56, 2.680_22], [0.31, 0.37])
    };
    for ramp in [
        Ramp::new(2.5, 20.0, [2.200_16, 3.210_91], [0.0, 0.0]),
        Ramp::new(2.5, 20.0, [2.200_16, 3.210_91], [0.4, 0.73]),
        Ramp::new(5.0, 20.0, [3.315_42, 7.037_41], [0.0, 0.37]),
        Ramp::new(8.0, 30.0, [5.019_96, 29.712_73], [0.21, 0.37]),
        light,
    ] {
        let mut flow = FixedSimulation::new(ramp.problem()).unwrap();
        assert!(flow.settle(400).unwrap().is_settled);
        let Ramp { mach, degrees, .. } = ramp;
        let off = ramp.off(&flow);
        assert!(off < 0.01, "Mach {mach}, {degrees} degrees: pressure {off}");
        let off = ramp.off_in_row(&flow);
        assert!(off < 0.01, "Mach {mach}, {degrees} degrees: density {off}");
    }
}

#[test]
fn a_ramp_that_stands_on_a_side_is_as_one_that_the_wall_goes_over_to() {
    let height = 3.0 * f64::to_radians(20.0).tan();
    let wedge = [[0.0, 0.0], [3.0, -height], [3.0, height]].map(Vector::from);
    let wedge: Arc<dyn Shape<2>> = Arc::new(bodies::polygon(&wedge).unwrap());
    for moved in [0.0, 0.23, 0.5] {
        let ramp = Ramp::new(3.0, 20.0, [2.459_90, 3.771_26], [moved, 0.0]);
        for (side, is_tip) in [
            (WALL, false),
            (Side::Symmetry, false),
            (Side::Symmetry, true),
        ] {
            let mut problem = ramp.problem_on(side);
            if is_tip {
                let place = Placement::default().moved(Vector::from(ramp.moved) * DX);
                problem.bodies[0].shape = Arc::new(Placed::new(Arc::clone(&wedge), place));
            }
            let mut flow = FixedSimulation::new(problem).unwrap();
            assert!(flow.settle(400).unwrap().is_settled);
            let off = ramp.off(&flow);
            assert!(off < 0.003, "{off} at {moved}, {side:?}, {is_tip}");
        }
    }
}

/// A tip in a mirror, at a corner of cells: by rounding the one before it is left a speck of wall, which points anywhere [NACA Report 1135 (1953), eqs 128
/// and 150].
#[test]
fn gas_is_right_from_a_tip_on_that_lies_in_a_mirror_where_cells_meet() {
    const BEHIND: f64 = 2.572_318;
    let points = [[0.0, 0.0], [0.5, -0.12], [1.0, 0.0], [0.5, 0.12]];
    let body = Arc::new(bodies::polygon(&points.map(Vector::from)).unwrap());
    let mut problem = stream(3.0, [[-0.3, 0.0], [0.6, 0.6]], 0.025, vec![body]);
    problem.domain.sides[1][0] = Side::Symmetry;
    let mut flow = FixedSimulation::new(problem).unwrap();
    assert!(flow.settle(400).unwrap().is_settled);
    let surface = flow.surface();
    let each = surface.position.iter().zip(&surface.pressure);
    let before = each.filter(|(foot, _)| (1e-6..0.45).contains(&foot[0]));
    let off: Vec<f64> = before.map(|(_, p)| p * 1.4 / BEHIND - 1.0).collect();
    assert!(off.len() > 10);
    assert!(off.iter().all(|off| off.abs() < 0.003), "{off:?}");
}

/// Half of a diamond of 10 degrees: behind its trailing edge gas turns back along the plane of symmetry [NACA Report 1135 (1953), eqs 44, 128, 129,
/// 150 and 171c].
#[test]
fn gas_along_a_mirror_is_right_from_the_first_cells_behind_a_trailing_edge() {
    const BEHIND: f64 = 0.982_702;
    let half = 0.3;
    let height = half * f64::to_radians(10.0).tan();
    let points = [
        [-half, 0.0],
        [-half, -0.2],
        [half, -0.2],
        [half, 0.0],
        [0.0, height],
    ];
    let body = Arc::new(bodies::polygon(&points.map(Vector::from)).unwrap());
    let mut problem = stream(2.5, [[-0.5, 0.0], [0.9, 0.8]], 0.02, vec![body]);
    problem.domain.sides[1][0] = Side::Symmetry;
    let mut flow = FixedSimulation::new(problem).unwrap();
    assert!(flow.settle(400).unwrap().is_settled);
    let each = flow.points.iter().zip(&flow.columns.held);
    let row = each.filter(|(at, _)| (half + 0.2..half + 0.5).contains(&at[0]) && at[1] < 0.04);
    let off: Vec<f64> = row.map(|(_, held)| held.mass / BEHIND - 1.0).collect();
    assert!(!off.is_empty());
    assert!(off.iter().all(|off| off.abs() < 0.01), "{off:?}");
}

/// About an axis the shock at the bend is that of the plane, and weakens from there on.
#[test]
fn a_flare_begins_as_a_ramp() {
    let height = 0.3 + 3.0 * f64::to_radians(20.0).tan();
    let points = [
        [-2.0, 0.3],
        [-2.0, -0.5],
        [3.0, -0.5],
        [3.0, height],
        [0.0, 0.3],
    ];
    let body = Arc::new(bodies::polygon(&points.map(Vector::from)).unwrap());
    let mut problem = stream(3.0, [[-0.3, 0.0], [0.6, 1.0]], DX, vec![body]);
    problem.domain.sides[1][0] = Side::Axis;
    let mut flow = FixedSimulation::new(problem).unwrap();
    assert!(flow.settle(400).unwrap().is_settled);
    let surface = flow.surface();
    let each = surface.position.iter().zip(&surface.pressure);
    let first = each.filter(|(foot, _)| (0.0..2.0 * DX).contains(&foot[0]));
    let ratios: Vec<f64> = first.map(|(_, p)| 1.4 * p / 3.771_26).collect();
    assert!(!ratios.is_empty());
    assert!(
        ratios.iter().all(|ratio| (0.96..1.01).contains(ratio)),
        "{ratios:?}"
    );
}

#[test]
fn a_march_comes_to_the_same_shock() {
    let whole = Ramp::new(2.5, 20.0, [2.200_16, 3.210_91], [0.4, 0.73]);
    let half = Ramp {
        moved: [0.4, 0.0],
        ..whole
    };
    for (ramp, side) in [(whole, Side::Body), (half, Side::Symmetry)] {
        let mut flow = FixedSimulation::new(ramp.problem_on(side)).unwrap();
        let before = flow.totals();
        while flow.time() < 2.5 {
            flow.step(2.5).unwrap();
        }
        let off = ramp.off(&flow);
        assert!(off < 0.003, "{off}");
        nothing_is_made(&flow, &before);
    }
}

/// No shock stands at a bend that gas comes to slower than sound, or that is too steep for one.
#[test]
fn flows_whose_shock_is_not_at_the_bend_know_nothing_of_it() {
    for (mach, degrees) in [(0.8, 10.0), (2.0, 28.0)] {
        let ramp = Ramp::new(mach, degrees, [1.0; 2], [0.3, 0.2]);
        let gains = |has_bends: bool| {
            let mut flow = FixedSimulation::new(ramp.problem()).unwrap();
            assert!(flow.net.blocks.iter().any(|block| !block.roots.is_empty()));
            if !has_bends {
                flow.net
                    .blocks
                    .iter_mut()
                    .for_each(|block| block.roots.clear());
            }
            for _ in 0..5 {
                flow.step(1.0).unwrap();
            }
            flow.columns.held
        };
        assert_eq!(gains(true), gains(false), "Mach {mach}, {degrees} degrees");
    }
}

/// Two wedges, of 10 degrees below and 16 above, whose shocks cross some fifty spacings from their bends [pressures by NACA Report 1135 (1953), eqs 128 and 150]:
/// behind the crossing each goes another way than its bend says, and the gas ahead of it knows nothing of that.
#[test]
fn shocks_that_cross_leave_the_gas_ahead_of_them_as_it_is() {
    const FINE: f64 = 0.5 * DX;
    let walls = [
        [
            [-1.0, -0.5],
            [3.0, -0.5],
            [3.0, 0.528_981],
            [0.0, 0.0],
            [-1.0, 0.0],
        ],
        [
            [-1.0, 1.5],
            [3.0, 1.5],
            [3.0, 0.139_764],
            [0.0, 1.0],
            [-1.0, 1.0],
        ],
    ];
    let bodies = walls.map(|points| -> Arc<dyn Shape<2>> {
        Arc::new(bodies::polygon(&points.map(Vector::from)).unwrap())
    });
    let mut problem = stream(3.0, [[-0.28, 0.0], [1.2, 1.0]], FINE, bodies.to_vec());
    problem.domain.sides[1] = [Side::Body, Side::Body];
    let mut flow = FixedSimulation::new(problem).unwrap();
    assert!(flow.settle(400).unwrap().is_settled);
    // Between the crossing, at (0.851, 0.441), and the walls, three spacings ahead of shocks that go on at 27.86 and 19.78 degrees.
    let ahead = |place: &Vector<2>| {
        let (x, y) = (place[0] - 0.851, place[1] - 0.441);
        let [below, above] = [(-27.86_f64, -1.0), (19.78, 1.0)].map(|(degrees, side)| {
            let (sine, cosine) = degrees.to_radians().sin_cos();
            side * (y * cosine - x * sine) > 3.0 * FINE
        });
        (x > 4.0 * FINE && (below || above)).then_some(usize::from(above))
    };
    let mut counts = [0; 2];
    for (place, state) in flow.points.iter().zip(&flow.columns.states) {
        if let Some(side) = ahead(place) {
            let ratio = 1.4 * state.pressure / [2.054_47, 2.996_44][side];
            assert!((ratio - 1.0).abs() < 0.01, "{place} {ratio}");
            counts[side] += 1;
        }
    }
    assert!(counts.iter().all(|&count| count > 20), "{counts:?}");
}

/// Coordinates are rounded: a wall that leads from a tip to a bend, a hundred-millionth off its line, is that of the tip all the same.
#[test]
fn gas_behind_a_bend_is_right_where_the_wall_before_it_is_rounded() {
    let corners = [
        [2.0, 0.0],
        [2.0, 0.504_511],
        [1.0, 0.140_540_84],
        [0.0, 0.0],
    ];
    let wedge: Arc<dyn Shape<2>> = Arc::new(bodies::polygon(&corners.map(Vector::from)).unwrap());
    for moved in [0.2, 0.5, 0.7] {
        let place = Placement::default().moved(Vector::from([moved, 0.3]) * DX);
        let body = Arc::new(Placed::new(Arc::clone(&wedge), place));
        let mut flow =
            FixedSimulation::new(stream(4.0, [[-0.2, -0.2], [1.3, 0.8]], DX, vec![body])).unwrap();
        assert!(flow.settle(400).unwrap().is_settled);
        for (wall, pressure) in flow.walls() {
            let way = (wall.foot[0] - 1.0) / DX - moved;
            if (0.0..4.0).contains(&way) && wall.image.normal[1] < 0.0 {
                let off = 1.4 * pressure / 5.466_462 - 1.0;
                assert!(off.abs() < 5e-3, "moved by {moved}: {off} at {way}");
            }
        }
    }
}

/// What a second shock at a face lets through more is counted from what the first does: one that stands there twice is one.
#[test]
fn shocks_at_one_face_do_not_add_up() {
    let ramp = Ramp::new(2.5, 20.0, [2.200_16, 3.210_91], [0.4, 0.73]);
    let mut flow = FixedSimulation::new(ramp.problem()).unwrap();
    for block in &mut flow.net.blocks {
        let again = block.roots.clone();
        block.roots.extend(again);
    }
    assert!(flow.settle(400).unwrap().is_settled);
    let off = ramp.off(&flow);
    assert!(off < 0.01, "{off}");
}
