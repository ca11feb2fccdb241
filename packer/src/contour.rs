//! Level contours of the signed distance in the plane: marching squares, then every vertex brought
//! exactly onto the level and sharp corners put back.

use std::collections::{BTreeMap, HashMap};

use aero_geometry::parallel::prelude::*;
use aero_geometry::{Shape, Vector};

use crate::grid::{Cell, Grid};
use crate::level::{project, project_along};
use crate::mirror::Mirrors;

/// Two normals further apart than this (cosine of 20 degrees) have a corner between them.
const CORNER_COSINE: f64 = 0.94;

/// One connected piece of a contour; the body is on its left.
#[derive(Clone, Debug)]
pub(crate) struct Contour<const D: usize> {
    /// Vertices; a closed contour repeats its first at the end.
    pub points: Vec<Vector<D>>,
    /// Gradient of the signed distance at the vertices.
    pub normals: Vec<Vector<D>>,
    /// True for vertices at which the contour has a kink.
    pub kinks: Vec<bool>,
    /// Arc length from the first vertex.
    pub arc: Vec<f64>,
    /// True where the contour returns to its start.
    pub closed: bool,
    /// True for ends on a mirror plane.
    pub on_plane: [bool; 2],
}

/// Signed distance at the corners of a band's cells.
pub(crate) struct Corners<'a, const D: usize> {
    shape: &'a dyn Shape<D>,
    mirrors: &'a Mirrors,
    grid: Grid<D>,
    /// Each with the distance at its centre.
    cells: Vec<([i64; 2], f64)>,
    distance: HashMap<[i64; 2], f64>,
    tolerance: f64,
}

/// An edge of the grid: its lower corner and the axis along which it runs.
type Edge = ([i64; 2], usize);

impl<'a, const D: usize> Corners<'a, D> {
    /// Evaluates the signed distance at all corners of `band`.
    pub fn new(
        shape: &'a dyn Shape<D>,
        mirrors: &'a Mirrors,
        grid: Grid<D>,
        band: &[Cell<D>],
        tolerance: f64,
    ) -> Self {
        let cells: Vec<([i64; 2], f64)> = band
            .iter()
            .map(|cell| ([cell.index[0], cell.index[1]], cell.distance))
            .collect();
        let mut corners: Vec<[i64; 2]> = cells
            .iter()
            .flat_map(|&([i, j], _)| [[i, j], [i + 1, j], [i, j + 1], [i + 1, j + 1]])
            .collect();
        corners.sort_unstable();
        corners.dedup();
        let distance = corners
            .par_iter()
            .map(|&corner| (corner, shape.signed_distance(&at(&grid, corner))))
            .collect();
        Self {
            shape,
            mirrors,
            grid,
            cells,
            distance,
            tolerance,
        }
    }

    /// All pieces of the contour `distance = level`, in a fixed order.
    pub fn trace(&self, level: f64) -> Vec<Contour<D>> {
        let next = self.links(level);
        let mut has_previous: BTreeMap<Edge, bool> = next.keys().map(|&e| (e, false)).collect();
        for end in next.values() {
            has_previous.insert(*end, true);
        }
        let mut used: BTreeMap<Edge, bool> = next.keys().map(|&e| (e, false)).collect();
        let open = has_previous.iter().filter(|&(_, &p)| !p).map(|(&e, _)| e);
        let starts: Vec<Edge> = open.chain(next.keys().copied()).collect();
        let mut contours = Vec::new();
        for start in starts {
            if used.get(&start).is_none_or(|&u| u) {
                continue;
            }
            let mut chain = vec![start];
            let mut edge = start;
            while let Some(&following) = next.get(&edge) {
                if used.insert(edge, true) == Some(true) {
                    break;
                }
                chain.push(following);
                edge = following;
            }
            contours.extend(self.contour(&chain, level));
        }
        contours
    }

    /// The crossing edge that follows each crossing edge.
    fn links(&self, level: f64) -> BTreeMap<Edge, Edge> {
        let mut next = BTreeMap::new();
        // The distance changes by no more than the way from a cell's centre to its corners.
        let near = |distance: f64| (distance - level).abs() <= self.grid.step;
        let cells = self.cells.iter().filter(|(_, distance)| near(*distance));
        for &([i, j], _) in cells {
            let corners = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]];
            let edges: [Edge; 4] = [([i, j], 0), ([i + 1, j], 1), ([i, j + 1], 0), ([i, j], 1)];
            let value = corners.map(|corner| self.distance[&corner]);
            let inside = value.map(|v| v < level);
            let leaves = |n: usize| inside[n] && !inside[(n + 1) % 4];
            let enters = |n: usize| !inside[n] && inside[(n + 1) % 4];
            let centre_outside = value.iter().sum::<f64>() >= 4.0 * level;
            for from in (0..4).filter(|&n| leaves(n)) {
                // At a saddle the value at the centre says which corners belong together.
                let to = (1..4)
                    .map(|step| {
                        if centre_outside {
                            (from + 4 - step) % 4
                        } else {
                            (from + step) % 4
                        }
                    })
                    .find(|&n| enters(n));
                if let Some(to) = to {
                    next.insert(edges[from], edges[to]);
                }
            }
        }
        next
    }

    /// Crossing edges turned into a contour; nothing where it shrinks to a point.
    fn contour(&self, chain: &[Edge], level: f64) -> Option<Contour<D>> {
        let closed = chain.len() > 3 && chain.first() == chain.last();
        let ends = [chain.first()?, chain.last()?];
        let mut on_plane = ends.map(|edge| !closed && self.plane_under(edge).is_some());
        let mut points: Vec<Vector<D>> = Vec::new();
        for (n, edge) in chain.iter().enumerate() {
            let end = (n == 0 && on_plane[0]) || (n + 1 == chain.len() && on_plane[1]);
            let guess = self.crossing(edge, level);
            let point = if end {
                project_along(self.shape, &guess, level, edge.1, self.tolerance)
            } else {
                project(self.shape, &guess, level, self.tolerance)
            };
            if let Some(point) = point {
                let new = points
                    .last()
                    .is_none_or(|last| (point - last).norm() > 1e-6 * self.grid.step);
                if new {
                    points.push(point);
                }
            } else if end {
                on_plane[usize::from(n > 0)] = false;
            }
        }
        if points.len() < 2 {
            return None;
        }
        if closed {
            let first = points[0];
            if (points[points.len() - 1] - first).norm() > 1e-6 * self.grid.step {
                points.push(first);
            } else {
                *points.last_mut()? = first;
            }
        }
        Some(self.measured(&points, level, closed, on_plane))
    }

    /// Adds the corners that marching squares cut off, and the arc length.
    fn measured(
        &self,
        raw: &[Vector<D>],
        level: f64,
        closed: bool,
        on_plane: [bool; 2],
    ) -> Contour<D> {
        let normal_at = |p: &Vector<D>| self.shape.closest(p).normal;
        let mut contour = Contour {
            points: vec![raw[0]],
            normals: vec![normal_at(&raw[0])],
            kinks: vec![false],
            arc: vec![0.0],
            closed,
            on_plane,
        };
        for pair in raw.windows(2) {
            let (p, q) = (pair[0], pair[1]);
            let n = contour.normals[contour.normals.len() - 1];
            let m = normal_at(&q);
            let corner = (n.dot(&m) < CORNER_COSINE)
                .then(|| tangents_meet(&p, &n, &q, &m))
                .flatten()
                .filter(|x| {
                    let error = self.shape.signed_distance(x) - level;
                    error.abs() < 1e-6 * self.grid.step && (x - p).norm() < 20.0 * self.grid.step
                });
            if let Some(x) = corner {
                contour.push(x, n, true, (x - p).norm());
                contour.push(q, m, false, (q - x).norm());
            } else {
                // The chord of a circular arc with these end normals, made as long as the arc.
                let half = 0.5 * n.dot(&m).clamp(-1.0, 1.0).acos();
                let bend = if half > 1e-6 && half < 1.0 {
                    half / half.sin()
                } else {
                    1.0
                };
                contour.push(q, m, false, bend * (q - p).norm());
            }
        }
        contour
    }

    /// The point on an edge where the linear interpolant meets the level.
    fn crossing(&self, edge: &Edge, level: f64) -> Vector<D> {
        let (low, axis) = *edge;
        let mut high = low;
        high[axis] += 1;
        let (a, b) = (self.distance[&low], self.distance[&high]);
        let part = if a == b { 0.5 } else { (level - a) / (b - a) };
        let (p, q) = (at(&self.grid, low), at(&self.grid, high));
        p + part.clamp(0.0, 1.0) * (q - p)
    }

    /// The mirror plane along which an edge runs.
    fn plane_under(&self, edge: &Edge) -> Option<usize> {
        let across = 1 - edge.1;
        (edge.0[across] == 0 && self.mirrors.plane(across).is_some()).then_some(across)
    }
}

impl<const D: usize> Contour<D> {
    /// Total arc length.
    pub fn length(&self) -> f64 {
        self.arc[self.arc.len() - 1]
    }

    /// The point at arc length `s`, on the polyline.
    pub fn point_at(&self, s: f64) -> Vector<D> {
        let last = self.arc.len() - 1;
        let next = self.arc.partition_point(|&a| a < s).clamp(1, last);
        let span = self.arc[next] - self.arc[next - 1];
        let part = if span > 0.0 {
            ((s - self.arc[next - 1]) / span).clamp(0.0, 1.0)
        } else {
            0.0
        };
        self.points[next - 1] + part * (self.points[next] - self.points[next - 1])
    }

    fn push(&mut self, point: Vector<D>, normal: Vector<D>, kink: bool, step: f64) {
        self.arc.push(self.length() + step);
        self.points.push(point);
        self.normals.push(normal);
        self.kinks.push(kink);
    }
}

fn at<const D: usize>(grid: &Grid<D>, corner: [i64; 2]) -> Vector<D> {
    let mut index = [0; D];
    index[..2].copy_from_slice(&corner);
    grid.corner(&index)
}

/// Where the tangent at `p` (normal `n`) meets the tangent at `q` (normal `m`).
fn tangents_meet<const D: usize>(
    p: &Vector<D>,
    n: &Vector<D>,
    q: &Vector<D>,
    m: &Vector<D>,
) -> Option<Vector<D>> {
    let determinant = n[0] * m[1] - n[1] * m[0];
    if determinant.abs() < 1e-6 {
        return None;
    }
    let (a, b) = (n.dot(p), m.dot(q));
    let mut meeting = *p;
    meeting[0] = (a * m[1] - b * n[1]) / determinant;
    meeting[1] = (n[0] * b - m[0] * a) / determinant;
    Some(meeting)
}
