//! The surface between nodes that the gas reaches and others: a vertex in each cell that it passes
//! through, a quadrangle around each edge that it crosses. [Ju, Losasso, Schaefer & Warren 2002, "Dual
//! contouring of Hermite data", ACM Trans. Graph. 21, 339]

use nalgebra::Matrix3;
use rayon::prelude::*;

use super::field::Field;
use super::grid::Nodes;
use crate::Vector;
use crate::stl::Facet;

/// Steps of the search for the place where an edge is crossed, and how near, in cells, is near enough.
const STEPS: usize = 12;
const NEAR_ENOUGH: f64 = 1e-5;

/// Directions in which the planes at a vertex tell less than this part of the most are left as they are.
const WEAK: f64 = 0.05;

/// Vertices keep so far off the walls of their cells, in cells.
const OFF_WALLS: f64 = 0.02;

/// Where in its cell a vertex is put.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Vertices {
    /// Where the planes at the cell's crossings meet: edges stay sharp.
    Sharp,
    /// In the mean of the crossings.
    Round,
}

/// An edge of the grid that the surface crosses.
struct Crossing {
    /// Its lower node.
    node: usize,
    axis: usize,
    /// True where the lower node is the outer one.
    rises: bool,
    place: Vector<3>,
    normal: Vector<3>,
}

/// The triangles of the surface.
pub(super) fn contour(field: &Field, nodes: &Nodes, vertices: Vertices) -> Vec<Facet> {
    let crossings: Vec<Crossing> = (0..nodes.len())
        .into_par_iter()
        .flat_map_iter(|node| (0..3).filter_map(move |axis| crossing(field, nodes, node, axis)))
        .collect();
    // Each crossing belongs to the four cells around its edge; a cell is known by its lowest node.
    let mut shares: Vec<(usize, u32)> = (0..crossings.len())
        .flat_map(|n| cells(nodes, &crossings[n]).map(|cell| (cell, n as u32)))
        .collect();
    shares.par_sort_unstable();
    let groups: Vec<&[(usize, u32)]> = shares.chunk_by(|a, b| a.0 == b.0).collect();
    let corners: Vec<Vector<3>> = groups
        .par_iter()
        .map(|group| {
            let own = group.iter().map(|&(_, n)| &crossings[n as usize]);
            vertex(nodes, group[0].0, &own.collect::<Vec<_>>(), vertices)
        })
        .collect();
    let corner = |cell: usize| {
        let found = groups.binary_search_by_key(&cell, |group| group[0].0);
        corners[found.unwrap_or(0)]
    };
    crossings
        .par_iter()
        .flat_map_iter(|crossing| {
            let mut quad = cells(nodes, crossing).map(corner);
            if crossing.rises {
                quad.reverse();
            }
            let [a, b, c, d] = quad;
            // The shorter diagonal.
            if (a - c).norm_squared() <= (b - d).norm_squared() {
                [[a, b, c], [a, c, d]]
            } else {
                [[b, c, d], [b, d, a]]
            }
        })
        .collect()
}

/// The four cells around an edge, counter-clockwise seen from its upper end.
fn cells(nodes: &Nodes, crossing: &Crossing) -> [usize; 4] {
    let u = nodes.stride((crossing.axis + 1) % 3);
    let v = nodes.stride((crossing.axis + 2) % 3);
    let n = crossing.node;
    [n - u - v, n - v, n, n - u]
}

/// Where the surface crosses the edge from a node along an axis.
fn crossing(field: &Field, nodes: &Nodes, node: usize, axis: usize) -> Option<Crossing> {
    let cell = nodes.node(node);
    if cell[axis] + 1 >= nodes.count[axis] {
        return None;
    }
    let rises = nodes.is_outside(node);
    if rises == nodes.is_outside(node + nodes.stride(axis)) {
        return None;
    }
    let start = nodes.place(cell);
    let at = |part: f64| {
        let mut p = start;
        p[axis] += part * nodes.step;
        let (distance, normal) = field.at(&p);
        (p, distance / nodes.step, normal)
    };
    // False position, halved where it creeps. [Dowell & Jarratt 1971, "Illinois"]
    let (mut low, mut high) = ((0.0, at(0.0).1), (1.0, at(1.0).1));
    let mut part = 0.5;
    let mut found = at(part);
    for _ in 0..STEPS {
        if low.1 * high.1 < 0.0 {
            part = (low.0 * high.1 - high.0 * low.1) / (high.1 - low.1);
        }
        found = at(part);
        if found.1.abs() < NEAR_ENOUGH {
            break;
        }
        if found.1 * high.1 > 0.0 {
            high = (part, found.1);
            low.1 *= 0.5;
        } else {
            low = (part, found.1);
            high.1 *= 0.5;
        }
    }
    Some(Crossing {
        node,
        axis,
        rises,
        place: found.0,
        normal: found.2,
    })
}

/// The vertex of a cell.
fn vertex(nodes: &Nodes, cell: usize, own: &[&Crossing], vertices: Vertices) -> Vector<3> {
    let mean = own.iter().map(|c| c.place).sum::<Vector<3>>() / own.len() as f64;
    if vertices == Vertices::Round {
        return mean;
    }
    let mut matrix = Matrix3::zeros();
    let mut right = Vector::<3>::zeros();
    for crossing in own {
        let n = crossing.normal;
        matrix += n * n.transpose();
        right += n * n.dot(&(crossing.place - mean));
    }
    let eigen = matrix.symmetric_eigen();
    let most = eigen.eigenvalues.max();
    let mut offset = Vector::<3>::zeros();
    for k in 0..3 {
        let value = eigen.eigenvalues[k];
        if value > WEAK * most {
            let direction = eigen.eigenvectors.column(k);
            offset += direction * (direction.dot(&right) / value);
        }
    }
    let low = nodes
        .place(nodes.node(cell))
        .add_scalar(OFF_WALLS * nodes.step);
    let high = low.add_scalar((1.0 - 2.0 * OFF_WALLS) * nodes.step);
    (mean + offset).sup(&low).inf(&high)
}
