//! Small holes, cracks and T-junctions are filled; large ones are left for the caller to refuse.

use std::collections::{BTreeMap, HashMap};

use super::edges::{HalfEdge, by_edge};
use super::weld::{Indexed, bounds};
use crate::Vector;

/// A hole counts as small if the square root of what fills it is below this part of the body's
/// diagonal. One that a single triangle closes may be larger.
const SMALL: f64 = 0.02;

/// All that is filled together may be this part of the surface: more is no repair but a guess.
const MOST: f64 = 0.05;

/// A hole with more corners than this is not small, whatever its size.
const MOST_CORNERS: usize = 200;

/// Fills small holes of a surface whose triangles agree with their neighbours; false where it filled
/// none.
pub(super) fn fill(mesh: &mut Indexed, half_edges: &[HalfEdge], repairs: &mut Vec<String>) -> bool {
    let loops = loops(half_edges);
    if loops.is_empty() {
        return false;
    }
    let extent = bounds(mesh.facets.iter().flatten().map(|&v| corner(mesh, v)));
    let small = (SMALL * extent.size().norm()).powi(2);
    let patches: Vec<(f64, Vec<[u32; 3]>)> = loops
        .iter()
        .filter(|border| border.len() <= MOST_CORNERS)
        .map(|border| least_area(mesh, border))
        .filter(|(area, patch)| patch.len() == 1 || *area <= small)
        .collect();
    let filled: f64 = patches.iter().map(|patch| patch.0).sum();
    let whole: f64 = mesh.facets.iter().map(|&f| mesh.area(f)).sum();
    if patches.is_empty() || filled > MOST * whole {
        return false;
    }
    let largest = patches
        .iter()
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map_or(Vector::zeros(), |(_, patch)| corner(mesh, patch[0][0]));
    repairs.push(format!(
        "filled {} holes or cracks, {:.2e} of the surface; the largest near ({:.6}, {:.6}, {:.6})",
        patches.len(),
        filled / whole,
        largest.x,
        largest.y,
        largest.z
    ));
    mesh.facets.extend(patches.into_iter().flat_map(|p| p.1));
    true
}

fn corner(mesh: &Indexed, vertex: u32) -> Vector<3> {
    mesh.vertices[vertex as usize]
}

/// The borders of all holes, each in the direction in which what fills it runs. One that meets
/// itself in a vertex is taken apart there.
fn loops(half_edges: &[HalfEdge]) -> Vec<Vec<u32>> {
    let mut next: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    for group in by_edge(half_edges) {
        let [low, high] = group[0].vertices();
        let ascending = group.iter().filter(|half| half.ascending).count();
        let descending = group.len() - ascending;
        // What fills the hole runs against the triangle beside it.
        let (from, to) = if ascending > descending {
            (high, low)
        } else {
            (low, high)
        };
        for _ in 0..ascending.abs_diff(descending) {
            next.entry(from).or_default().push(to);
        }
    }
    let mut loops = Vec::new();
    while let Some(&start) = next.keys().next() {
        let mut path = vec![start];
        let mut places = HashMap::from([(start, 0)]);
        while let Some(&last) = path.last() {
            let Some(ends) = next.get_mut(&last) else {
                // Runs in and not out: nothing to fill here.
                break;
            };
            let to = ends.swap_remove(0);
            if ends.is_empty() {
                next.remove(&last);
            }
            if let Some(&place) = places.get(&to) {
                let ring: Vec<u32> = path.drain(place..).collect();
                for vertex in &ring {
                    places.remove(vertex);
                }
                if ring.len() > 2 {
                    loops.push(ring);
                }
            }
            places.insert(to, path.len());
            path.push(to);
            if !next.contains_key(&to) {
                break;
            }
        }
    }
    loops
}

/// The triangles of least area that span a closed border, and their area. [Barequet & Sharir 1995,
/// "Filling gaps in the boundary of a polyhedron", Comput. Aided Geom. Des. 12, 207]
fn least_area(mesh: &Indexed, border: &[u32]) -> (f64, Vec<[u32; 3]>) {
    let count = border.len();
    let mut least = vec![0.0; count * count];
    let mut apex = vec![0; count * count];
    for width in 2..count {
        for first in 0..count - width {
            let last = first + width;
            let mut best = (f64::INFINITY, first + 1);
            for middle in first + 1..last {
                let total = least[first * count + middle]
                    + least[middle * count + last]
                    + mesh.area([border[first], border[middle], border[last]]);
                if total < best.0 {
                    best = (total, middle);
                }
            }
            least[first * count + last] = best.0;
            apex[first * count + last] = best.1;
        }
    }
    let mut patch = Vec::with_capacity(count - 2);
    let mut open = vec![(0, count - 1)];
    while let Some((first, last)) = open.pop() {
        if last - first < 2 {
            continue;
        }
        let middle = apex[first * count + last];
        patch.push([border[first], border[middle], border[last]]);
        open.push((middle, last));
        open.push((first, middle));
    }
    (least[count - 1], patch)
}
