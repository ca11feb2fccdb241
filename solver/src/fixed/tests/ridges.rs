//! Bodies in space with sharp edges: which are found, what presses on the walls behind them, and that nothing is made there.

use std::sync::Arc;

use aero_geometry::outline::Piece;
use aero_geometry::{Mesh, Placed, Placement, Revolution, Shape, Vector, bodies};

use super::flows::nothing_is_made;
use super::flows::stream;
use crate::fixed::FixedSimulation;
use crate::fixed::bend::Bend;
use crate::fixed::state::dot;
use crate::problem::{Problem, Side};

/// Distance of the apex of a cone of 15 degrees from a shoulder of radius 0.3.
const LONG: f64 = 1.119_615_2;

/// Walls smaller than this, in squares of a spacing, are slivers.
const SLIVER: f64 = 0.1;

/// The solid between two planes whose section is a convex polygon, travelled counter-clockwise.
pub fn prism(section: &[[f64; 2]], ends: [f64; 2]) -> Arc<dyn Shape<3>> {
    let count = section.len();
    let at = |number: usize, end: usize| {
        let [x, y] = section[number % count];
        Vector::<3>::new(x, y, ends[end])
    };
    let mut facets = Vec::new();
    for n in 0..count {
        facets.push([at(n, 0), at(n + 1, 0), at(n + 1, 1)]);
        facets.push([at(n, 0), at(n + 1, 1), at(n, 1)]);
    }
    for n in 1..count - 1 {
        facets.push([at(0, 1), at(n, 1), at(n + 1, 1)]);
        facets.push([at(0, 0), at(n + 1, 0), at(n, 0)]);
    }
    Arc::new(Mesh::from_facets(facets).unwrap())
}

/// A stream of Mach 2 over a corner of 15 degrees along the third axis, moved by parts of a spacing and turned about the second axis.
struct Corner {
    dx: f64,
    moved: [f64; 3],
    turned: f64,
    ends: [f64; 2],
}

impl Corner {
    fn new(dx: f64, moved: [f64; 3], turned: f64) -> Self {
        Self {
            dx,
            moved,
            turned,
            ends: [-3.0, 3.0],
        }
    }

    fn problem(&self) -> Problem<3> {
        let fall = 3.0 * f64::to_radians(15.0).tan();
        let section = [
            [0.0, 0.0],
            [-3.0, 0.0],
            [-3.0, -3.0],
            [3.0, -3.0],
            [3.0, -fall],
        ];
        let place = Placement::<3>::default()
            .rotated_about(&Vector::y(), self.turned)
            .unwrap()
            .moved(Vector::from(self.moved) * self.dx);
        let corner = Placed::new(prism(&section, self.ends), place);
        let (deep, is_straight) = (
            if self.turned == 0.0 { 0.15 } else { 0.4 },
            self.turned == 0.0,
        );
        let bounds = [[-0.3, -0.4, -deep], [0.5, 0.6, deep]];
        let mut problem = stream(2.0, bounds, self.dx, vec![Arc::new(corner)]);
        problem.domain.sides[1][0] = Side::Body;
        if is_straight {
            problem.domain.sides[2] = [Side::Symmetry; 2];
        }
        problem
    }

    /// How far a wall is behind the corner, in spacings.
    fn behind(&self, foot: &[f64; 3], slope: f64) -> f64 {
        let (sine, cosine) = slope.sin_cos();
        let [x, y, z] = [0, 1, 2].map(|k| foot[k] / self.dx - self.moved[k]);
        (x * self.turned.cos() - z * self.turned.sin()) * cosine - y * sine
    }

    /// Largest departure of the wall pressure from the stream's over the last four spacings before the corner and in the middle of the box.
    fn ahead(&self, flow: &FixedSimulation<3>) -> f64 {
        let surface = flow.surface();
        let each = surface.position.iter().zip(&surface.pressure);
        let near = each.filter(|(foot, _)| {
            (-4.0..-0.1).contains(&self.behind(foot, 0.0)) && foot[2].abs() < 0.16
        });
        near.map(|(_, pressure)| (pressure * 1.4 - 1.0).abs())
            .fold(0.0, f64::max)
    }

    /// Mean and largest departure of the wall pressure from `fan`, over the first four spacings behind the corner and in the middle of the
    /// box, but for slivers.
    fn off(&self, flow: &FixedSimulation<3>, fan: f64) -> [f64; 2] {
        let surface = flow.surface();
        let each = surface.position.iter().zip(&surface.pressure);
        let (mut sums, mut most) = ([0.0; 2], 0.0_f64);
        for ((foot, pressure), area) in each.zip(&surface.area) {
            let behind = self.behind(foot, f64::to_radians(15.0));
            let is_there = (0.1..4.0).contains(&behind) && foot[2].abs() < 0.16;
            if is_there && *area > SLIVER * self.dx * self.dx {
                let off = pressure * 1.4 / fan - 1.0;
                sums = [sums[0] + off * area, sums[1] + area];
                most = most.max(off.abs());
            }
        }
        [(sums[0] / sums[1]).abs(), most]
    }
}

/// Prandtl and Meyer [NACA Report 1135 (1953)] of the part of the stream across the edge: Mach 2, and 2 cos(10 deg).
#[test]
fn wall_pressure_is_right_from_the_first_cell_behind_a_sharp_edge() {
    for (moved, turned, fan, dx) in [
        ([0.0; 3], 0.0_f64, 0.393_07, 0.05),
        ([0.3, 0.7, 0.2], 0.0, 0.393_07, 0.05),
        ([0.1, 0.2, 0.4], -10.0, 0.397_13, 0.05),
        ([0.3, 0.7, 0.2], 10.0, 0.397_13, 0.025),
    ] {
        let corner = Corner::new(dx, moved, turned.to_radians());
        let mut flow = FixedSimulation::new(corner.problem()).unwrap();
        assert!(flow.settle(300).unwrap().is_settled);
        let [mean, most] = corner.off(&flow, fan);
        let ahead = corner.ahead(&flow);
        let [behind, before] = if turned == 0.0 {
            [0.01, 0.003]
        } else {
            [0.035, 0.015]
        };
        assert!(
            mean < 0.003 && most < behind && ahead < before,
            "{moved:?}, {turned} degrees, {dx}: {mean} {most} {ahead}"
        );
    }
}

#[test]
fn nothing_is_made_at_an_edge_in_space() {
    let corner = Corner::new(0.05, [0.3, 0.7, 0.2], 0.1);
    let mut flow = FixedSimulation::new(corner.problem()).unwrap();
    let before = flow.totals();
    while flow.time() < 0.3 {
        flow.step(0.3).unwrap();
    }
    nothing_is_made(&flow, &before);
}

/// The bends of a body in a box.
fn bends(body: Arc<dyn Shape<3>>, dx: f64) -> Vec<Bend<3>> {
    let problem = stream(2.0, [[-0.6; 3], [0.6; 3]], dx, vec![body]);
    let flow = FixedSimulation::new(problem).unwrap();
    let mut bends: Vec<Bend<3>> = Vec::new();
    for around in flow.net.blocks.iter().flat_map(|block| &block.bends) {
        for bend in &around.bends {
            if !bends.contains(bend) {
                bends.push(bend.clone());
            }
        }
    }
    bends
}

#[test]
fn round_bodies_boxes_and_hollows_have_no_edge_that_gas_follows() {
    let round = prism(
        &std::array::from_fn::<_, 24, _>(|n| {
            let (sine, cosine) = (n as f64 * std::f64::consts::TAU / 24.0).sin_cos();
            [0.3 * cosine, 0.3 * sine]
        }),
        [-2.0, 2.0],
    );
    let two = prism(&[[-0.5, -0.5], [0.5, -0.5], [0.0, -0.3]], [-2.0, 2.0]);
    let one: Arc<dyn Shape<3>> = Arc::new(bodies::cuboid([3.0, 0.4, 3.0]).unwrap());
    for body in [
        Arc::new(bodies::sphere(0.3).unwrap()) as Arc<dyn Shape<3>>,
        Arc::new(bodies::round_rod(0.2, 2.0).unwrap()),
        one,
        round,
    ] {
        let found = bends(body, 0.1);
        assert!(found.is_empty(), "{:?}", found[0]);
    }
    // A ridge of 22 degrees each way, and no more.
    assert!(!bends(two, 0.05).is_empty());
    let valley = [
        [-0.5, 0.2],
        [-0.5, -0.5],
        [0.5, -0.5],
        [0.5, 0.2],
        [0.0, 0.0],
    ];
    let halves = [[0, 1, 4], [2, 3, 4]]
        .map(|[a, b, c]| prism(&[valley[a], valley[b], valley[c]], [-2.0, 2.0]));
    // What parts the stream is none either.
    let parts = |bend: &Bend<3>| dot(&bend.before, &bend.up).abs() > 0.1;
    for half in halves {
        assert!(bends(half, 0.1).iter().all(parts));
    }
}

/// A cone of 15 degrees whose shoulder, of radius 0.3, leads to a cylinder.
fn shoulder(moved: [f64; 3]) -> Arc<dyn Shape<3>> {
    let meridian = [[0.0, 0.0], [LONG, 0.3], [9.0, 0.3], [9.0, 0.0]].map(Vector::<2>::from);
    let pieces = meridian
        .windows(2)
        .map(|ends| Piece::segment(ends[0], ends[1]));
    let body = Revolution::new(pieces.collect()).unwrap();
    let place = Placement::<3>::default().moved(moved.into());
    Arc::new(Placed::new(body, place))
}

/// Its pieces touch all around; cells lie wholly ahead of each, beside it, and are led to it by its own walls.
#[test]
fn gas_comes_to_each_piece_of_a_shoulder_from_its_own_side() {
    let (dx, moved) = (0.05, [-LONG, 0.013, -0.021]);
    let problem = stream(2.0, [[-0.6; 3], [0.6; 3]], dx, vec![shoulder(moved)]);
    let flow = FixedSimulation::new(problem).unwrap();
    let all = flow.net.blocks.iter().flat_map(|block| &block.bends);
    let mut met = 0;
    for bend in all.flat_map(|around| &around.bends) {
        let [at, edge, before, along, up] =
            [bend.at, bend.edge, bend.before, bend.along, bend.up].map(Vector::<3>::from);
        let arm = at - Vector::from(moved) - Vector::<3>::new(LONG, 0.0, 0.0);
        assert!((arm.norm() - 0.3).abs() < 1e-3 && arm[0].abs() < 1e-12);
        assert!(edge.dot(&arm).abs() < 1e-9 && edge.dot(&before).abs() < 1e-9);
        assert!((before.dot(&along) - f64::to_radians(15.0).cos()).abs() < 1e-6);
        assert!(up.dot(&along) < 0.0);
        let mut middle = Vector::<3>::zeros();
        let mut sum = 0.0;
        for (i, part) in &bend.donors {
            let place = flow.points[*i as usize] - at;
            assert!(place.dot(&before) < -bend.unit, "{bend:?}");
            middle += place * *part;
            sum += part;
        }
        assert!((sum - 1.0).abs() < 1e-12);
        assert!(middle.dot(&edge).abs() < bend.unit, "{bend:?}");
        met += usize::from(before[0] > 0.0);
    }
    assert!(met > 38, "{met}");
}

/// Mean and farthest departure of the pressure from that of `rings`, per cent, over so many spacings behind the shoulder.
fn behind(flow: &FixedSimulation<3>, rings: &[[f64; 2]], dx: f64, spacings: f64) -> [f64; 2] {
    let surface = flow.surface();
    let each = surface.position.iter().zip(&surface.pressure);
    let mut offs: Vec<f64> = Vec::new();
    for ([x, ..], pressure) in each {
        if (0.1 * dx..spacings * dx).contains(&(x - LONG)) {
            let next = rings
                .partition_point(|[at, _]| at < x)
                .clamp(1, rings.len() - 1);
            let [a, b] = [rings[next - 1], rings[next]];
            let known = a[1] + (b[1] - a[1]) * ((x - a[0]) / (b[0] - a[0]));
            offs.push(100.0 * (pressure / known - 1.0));
        }
    }
    let mean = offs.iter().sum::<f64>() / offs.len() as f64;
    [mean, offs.iter().fold(0.0, |most, off| off.abs().max(most))]
}

/// The same flow as of rings at a quarter of the spacing, which know fans in the plane.
#[test]
fn wall_pressure_behind_a_shoulder_in_space_is_that_of_fine_rings() {
    let dx = 0.05;
    let corners = [
        [0.0, 0.0],
        [LONG, -0.3],
        [9.0, -0.3],
        [9.0, 0.3],
        [LONG, 0.3],
    ];
    let section = bodies::polygon(&corners.map(Vector::from)).unwrap();
    let mut problem = stream(
        2.0,
        [[-0.1, 0.0], [1.4, 0.8]],
        0.25 * dx,
        vec![Arc::new(section)],
    );
    problem.domain.sides[1][0] = Side::Axis;
    let mut flow = FixedSimulation::new(problem).unwrap();
    flow.settle(400).unwrap();
    let surface = flow.surface();
    let each = surface.position.iter().zip(&surface.pressure);
    let mut rings: Vec<[f64; 2]> = each.map(|(foot, pressure)| [foot[0], *pressure]).collect();
    rings.sort_by(|a, b| a[0].total_cmp(&b[0]));

    let bounds = [[-0.1, 0.0, 0.0], [1.4, 0.8, 0.8]];
    let mut problem = stream(2.0, bounds, dx, vec![shoulder([0.0; 3])]);
    problem.domain.sides[1][0] = Side::Symmetry;
    problem.domain.sides[2][0] = Side::Symmetry;
    let mut flow = FixedSimulation::new(problem).unwrap();
    flow.settle(300).unwrap();
    let [mean, most] = behind(&flow, &rings, dx, 4.0);
    assert!(mean.abs() < 2.5 && most < 6.0, "{mean} {most}");
}

/// Beyond the end of an edge there is no fan: what lies there is not seen from it.
#[test]
fn nothing_beyond_the_end_of_an_edge_is_seen_from_it() {
    let corner = Corner {
        ends: [-3.0, 0.013],
        ..Corner::new(0.05, [0.0; 3], 0.0)
    };
    let mut problem = corner.problem();
    problem.domain.bounds.max[2] = 0.4;
    problem.domain.sides[1][0] = Side::FreeStream;
    let flow = FixedSimulation::new(problem).unwrap();
    let net = &flow.net;
    let mut seen = 0;
    for block in &net.blocks {
        for around in &block.bends {
            for number in &around.faces {
                let face = &block.faces[*number as usize];
                let middle = net.seen(&flow.points, &Vector::zeros(), face).unwrap();
                assert!(middle[2] < 0.013 + 1e-6, "{middle:?}");
                seen += 1;
            }
        }
    }
    assert!(seen > 500, "{seen}");
}
