//! Walls in space with sharp edges: what presses on them in the first cells behind.

use std::sync::Arc;

use aero_geometry::{Mesh, Placed, Placement, Shape, Vector};

use super::flows::stream;
use crate::fixed::FixedSimulation;
use crate::problem::{Problem, Side};

/// The solid between two planes whose section is a convex polygon, travelled counter-clockwise.
fn prism(section: &[[f64; 2]], ends: [f64; 2]) -> Arc<dyn Shape<3>> {
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

/// A stream over a corner along the third axis, moved by parts of a spacing and turned about the second axis.
struct Corner {
    mach: f64,
    degrees: f64,
    dx: f64,
    moved: [f64; 3],
    turned: f64,
}

impl Corner {
    fn problem(&self) -> Problem<3> {
        let fall = 3.0 * self.degrees.to_radians().tan();
        let section = [[0.0, 0.0], [-3.0, 0.0], [-3.0, -3.0], [3.0, -3.0], [3.0, -fall]];
        let place = Placement::<3>::default()
            .rotated_xyz([0.0, self.turned, 0.0])
            .moved(Vector::from(self.moved) * self.dx);
        let corner = Placed::new(prism(&section, [-3.0, 3.0]), place);
        let deep = if self.turned == 0.0 { 0.15 } else { 0.4 };
        let bounds = [[-0.3, -0.6, -deep], [0.7, 0.7, deep]];
        let mut problem = stream(self.mach, bounds, self.dx, vec![Arc::new(corner)]);
        problem.domain.sides[1][0] = Side::Body;
        if self.turned == 0.0 {
            problem.domain.sides[2] = [Side::Symmetry; 2];
        }
        problem
    }

    /// Distance behind the corner, in spacings, and pressure over the stream's of each wall in the middle of the box.
    fn wall(&self, flow: &FixedSimulation<3>) -> Vec<[f64; 2]> {
        let (sine, cosine) = self.degrees.to_radians().sin_cos();
        let surface = flow.surface();
        let each = surface.position.iter().zip(&surface.pressure);
        let middle = each.filter(|(foot, _)| foot[2].abs() < 0.16);
        middle
            .map(|(foot, pressure)| {
                let [x, y, z] = [0, 1, 2].map(|k| foot[k] / self.dx - self.moved[k]);
                let x = x * self.turned.cos() - z * self.turned.sin();
                [x * cosine - y * sine, pressure * 1.4]
            })
            .collect()
    }
}

#[test]
fn probe() {
    for (moved, turned) in [
        ([0.0; 3], 0.0),
        ([0.3, 0.7, 0.2], 0.0),
        ([0.3, 0.7, 0.2], 0.1745),
    ] {
        for dx in [0.05, 0.025] {
            let corner = Corner {
                mach: 2.0,
                degrees: 15.0,
                dx,
                moved,
                turned,
            };
            let mut flow = FixedSimulation::new(corner.problem()).unwrap();
            let pieces: usize = flow.net.blocks.iter().map(|block| block.bends.len()).sum();
            let settled = flow.settle(300).unwrap();
            let mut ways = vec![[0.0, 0.0, 9.0, -9.0]; 6];
            let exact = 0.393_07;
            for [at, pressure] in corner.wall(&flow) {
                if at < 0.1 {
                    continue;
                }
                let k = [1.0, 2.0, 4.0, 8.0, 12.0]
                    .iter()
                    .position(|to| at < *to)
                    .unwrap_or(5);
                let off = pressure / exact - 1.0;
                ways[k][0] += off;
                ways[k][1] += 1.0;
                ways[k][2] = off.min(ways[k][2]);
                ways[k][3] = off.max(ways[k][3]);
            }
            println!("{moved:?} {turned} {dx} {pieces} {settled:?}");
            for way in ways {
                println!(
                    "   {:+.4} {:+.4} {:+.4}",
                    way[0] / way[1],
                    way[2],
                    way[3]
                );
            }
        }
    }
}
