//! Bodies in space with edges that part a stream, and with hollows: what presses on their walls from the edge on, and that nothing is made there.

use std::sync::Arc;

use aero_geometry::{Mesh, Placed, Placement, Shape, Vector};

use super::flows::{nothing_is_made, stream};
use super::lattice::WALL;
use super::ridges::prism;
use crate::fixed::FixedSimulation;
use crate::problem::{Problem, Side};

const DX: f64 = 0.04;

/// Walls smaller than this, in squares of a spacing, are slivers.
const SLIVER: f64 = 0.1;

/// A body whose section is the same along the third axis between two planes of symmetry, five cells apart.
fn problem(mach: f64, section: &[[f64; 2]], moved: [f64; 2], bounds: [[f64; 2]; 2]) -> Problem<3> {
    let [x, y] = moved.map(|part| part * DX);
    let place = Placement::<3>::default().moved(Vector::<3>::new(x, y, 0.0));
    let body = Arc::new(Placed::new(prism(section, [-1.0, 1.0]), place));
    let deep = 2.5 * DX;
    let [[left, low], [right, high]] = bounds;
    let bounds = [[left, low, -deep], [right, high, deep]];
    let mut problem = stream(mach, bounds, DX, vec![body]);
    problem.domain.sides[2] = [Side::Symmetry; 2];
    problem
}

/// Mean and largest departure of the pressure on walls from what theory says of each place that it says something of, over what the stream has.
fn off(
    flow: &FixedSimulation<3>,
    theory: impl Fn(&Vector<3>, &Vector<3>) -> Option<f64>,
) -> [f64; 2] {
    let (mut sums, mut most) = ([0.0; 2], 0.0_f64);
    for (wall, pressure) in flow.walls() {
        let normal = -Vector::from(wall.image.normal);
        let size = wall.image.share;
        let Some(theory) = theory(&wall.foot, &normal).filter(|_| size > SLIVER * DX * DX) else {
            continue;
        };
        let off = 1.4 * pressure / theory - 1.0;
        sums = [sums[0] + off * size, sums[1] + size];
        most = most.max(off.abs());
    }
    assert!(sums[1] > 0.0);
    [(sums[0] / sums[1]).abs(), most]
}

/// The section of a wedge whose sides rise by so many degrees.
fn wedge(upper: f64, lower: f64) -> [[f64; 2]; 3] {
    let [upper, lower] = [upper, lower].map(|degrees| 2.0 * degrees.to_radians().tan());
    [[0.0, 0.0], [2.0, -lower], [2.0, upper]]
}

/// NACA Report 1135 (1953), eqs 128, 150 and 171c, as in the plane.
#[test]
fn pressure_on_a_wedge_in_space_is_right_from_its_edge_on() {
    for (mach, degrees, pressed, moved) in [
        (2.5, [10.0, 10.0], [1.863_87; 2], [0.3, 0.2]),
        (8.0, [20.0, 20.0], [14.822_66; 2], [0.4, 0.1]),
        (3.0, [15.0, -4.0], [2.821_56, 0.725_634], [0.2, 0.2]),
    ] {
        let [upper, lower] = degrees;
        let bounds = [[-0.2, -0.6], [0.7, 0.6]];
        let mut flow =
            FixedSimulation::new(problem(mach, &wedge(upper, lower), moved, bounds)).unwrap();
        assert!(flow.settle(400).unwrap().is_settled);
        let [mean, most] = off(&flow, |_, normal| {
            let is_side = normal.z.abs() < 0.1;
            is_side.then(|| pressed[usize::from(normal.y < 0.0)])
        });
        assert!(
            mean < 2e-3 && most < 0.02,
            "Mach {mach}, {degrees:?} degrees: {mean} {most}"
        );
    }
}

/// A wing under which the shock of a wedge of ten degrees lies in the plane of its swept edges [Nonweiler 1959, doi:10.1017/S0368393100071662]: gas of one
/// state from edge to edge, of Mach 3 and 2.0545 times the pressure.
#[test]
fn pressure_under_a_swept_edge_is_right_from_the_edge_on() {
    const HALF_SPAN: f64 = 0.5;
    const LONG: f64 = 1.4;
    const PRESSED: f64 = 2.054_487;
    let [fall, drop] = [27.382_74_f64, 10.0].map(|degrees| degrees.to_radians().tan());
    let edge = |side: f64| Vector::<3>::new(LONG, -LONG * fall, side * HALF_SPAN * LONG);
    let (tip, top, groove) = (
        Vector::<3>::zeros(),
        Vector::<3>::new(LONG, 0.0, 0.0),
        Vector::<3>::new(LONG, -LONG * drop, 0.0),
    );
    let [right, left] = [1.0, -1.0].map(edge);
    let facets = vec![
        [tip, right, top],
        [tip, groove, right],
        [tip, top, left],
        [tip, left, groove],
        [top, right, groove],
        [top, groove, left],
    ];
    let place = Placement::<3>::default().moved(Vector::<3>::new(0.3, 0.2, 0.1) * DX);
    let wing: Arc<dyn Shape<3>> = Arc::new(Placed::new(Mesh::from_facets(facets).unwrap(), place));
    let bounds = [[-0.12, -0.6, -0.6], [0.8, 0.2, 0.6]];
    let problem = stream(3.0, bounds, DX, vec![wing]);
    let mut flow = FixedSimulation::new(problem).unwrap();
    assert!(flow.settle(400).unwrap().is_settled);
    let ways = [1.0, -1.0].map(|side| edge(side).normalize());
    let [mean, most] = off(&flow, |foot, normal| {
        let arm = foot - place.point(&tip);
        let way = ways[usize::from(arm.z < 0.0)];
        let beside = (arm - way * way.dot(&arm)).norm() / DX;
        let is_there = normal.y < -0.5 && arm.x > 8.0 * DX && beside < 4.0;
        is_there.then_some(PRESSED)
    });
    assert!(mean < 5e-3 && most < 0.08, "{mean} {most}");
}

/// A side of 8 degrees at Mach 4, then one of 20: gas of Mach 3.4271 meets it, and 5.4665 times the stream's pressure stands behind. Before the hollow nothing is felt.
#[test]
fn pressure_on_both_sides_of_a_hollow_in_space_is_right_next_to_it() {
    let [first, second] = [8.0_f64, 20.0].map(|degrees| degrees.to_radians().tan());
    let section = [[2.0, 0.0], [2.0, first + second], [1.0, first], [0.0, 0.0]];
    let bounds = [[-0.2, -0.2], [1.3, 0.8]];
    for moved in [[0.0, 0.0], [0.3, 0.2], [0.6, 0.7]] {
        let mut flow = FixedSimulation::new(problem(4.0, &section, moved, bounds)).unwrap();
        assert!(flow.settle(400).unwrap().is_settled);
        let hollow = 1.0 + moved[0] * DX;
        let kinks = flow.net.blocks.iter().flat_map(|block| &block.kinks);
        let is_held = kinks.filter(|kink| kink.along.is_some()).count() > 0;
        assert!(is_held || moved == [0.0; 2]);
        let beside = |ahead: bool, pressed: f64| {
            off(&flow, |foot, normal| {
                let way = (foot.x - hollow) / DX;
                let is_there = if ahead {
                    (-4.0..0.0).contains(&way)
                } else {
                    (0.0..4.0).contains(&way)
                };
                (normal.y > 0.5 && is_there).then_some(pressed)
            })
        };
        let [ahead, behind] = [beside(true, 2.116_753), beside(false, 5.466_462)];
        assert!(
            ahead[1] < 0.01 && behind[0] < 2e-3 && behind[1] < 0.01,
            "{moved:?}: {ahead:?} {behind:?}"
        );
    }
}

/// A wedge of 20 degrees at Mach 3 that goes through the plane it stands on, and one whose edge lies in a mirror: wherever in their cells it is, as what
/// the wall before it goes over to.
#[test]
fn pressure_behind_a_seam_with_a_side_is_right_from_the_seam_on() {
    let through = wedge(20.0, 20.0).map(|[x, y]| [x, if y < 0.0 { -0.3 } else { y }]);
    let through = [[0.0, -0.3], through[1], through[2], [0.0, 0.0]];
    let edge = wedge(20.0, 20.0);
    for (section, side) in [
        (&through[..], WALL),
        (&through, Side::Symmetry),
        (&edge, Side::Symmetry),
    ] {
        for moved in [0.0, 0.23, 0.5] {
            let bounds = [[-0.3, 0.0], [0.7, 0.8]];
            let mut problem = problem(3.0, section, [moved, 0.0], bounds);
            problem.domain.sides[1][0] = side;
            let mut flow = FixedSimulation::new(problem).unwrap();
            assert!(flow.settle(400).unwrap().is_settled);
            let [mean, most] = off(&flow, |foot, normal| {
                (normal.y > 0.5 && foot.x > moved * DX).then_some(3.771_26)
            });
            assert!(
                mean < 2e-3 && most < 0.02,
                "{section:?} on {side:?}, {moved}: {mean} {most}"
            );
        }
    }
}

/// Half of a diamond of 10 degrees in a mirror, as in the plane: behind its trailing edge gas turns back along it. Where its edge lies a cell holds it, with the
/// wall ahead.
#[test]
fn gas_along_a_mirror_is_right_behind_a_trailing_edge_in_space() {
    const BEHIND: f64 = 0.982_702;
    let half = 0.5;
    let height = half * f64::to_radians(10.0).tan();
    let section = [[-half, 0.0], [0.0, -height], [half, 0.0], [0.0, height]];
    for moved in [0.0, 0.3] {
        let mut problem = problem(2.5, &section, [moved, 0.0], [[-0.7, 0.0], [1.3, 0.8]]);
        problem.domain.sides[1][0] = Side::Symmetry;
        let mut flow = FixedSimulation::new(problem).unwrap();
        assert!(flow.settle(400).unwrap().is_settled);
        let end = half + moved * DX;
        let kinks = flow.net.blocks.iter().flat_map(|block| &block.kinks);
        assert_eq!(
            kinks.filter(|kink| kink.along.is_some()).count() > 0,
            moved > 0.0
        );
        let each = flow.points.iter().zip(&flow.columns.held);
        let row =
            each.filter(|(at, _)| (end + 3.0 * DX..end + 10.0 * DX).contains(&at[0]) && at[1] < DX);
        let off: Vec<f64> = row.map(|(_, held)| held.mass / BEHIND - 1.0).collect();
        assert!(!off.is_empty());
        assert!(off.iter().all(|off| off.abs() < 0.02), "{moved}: {off:?}");
    }
}

#[test]
fn a_march_about_an_edge_in_space_makes_nothing() {
    let bounds = [[-0.2, -0.5], [0.5, 0.5]];
    let mut flow =
        FixedSimulation::new(problem(3.0, &wedge(15.0, -4.0), [0.2, 0.2], bounds)).unwrap();
    let before = flow.totals();
    while flow.time() < 0.6 {
        flow.step(0.6).unwrap();
    }
    nothing_is_made(&flow, &before);
}
