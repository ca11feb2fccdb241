//! Small holes, cracks and T-junctions are filled; large ones are left for [`super::openings`].

use super::caps::span;
use super::edges::HalfEdge;
use super::rims::rims;
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
    let rims = rims(half_edges);
    if rims.is_empty() {
        return false;
    }
    let extent = bounds(mesh.facets.iter().flatten().map(|&v| corner(mesh, v)));
    let small = (SMALL * extent.size().norm()).powi(2);
    let patches: Vec<(f64, Vec<[u32; 3]>)> = rims
        .iter()
        .filter(|border| border.len() <= MOST_CORNERS)
        .map(|border| span(mesh, border))
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
