//! Which coordinate planes a mesh is symmetric about.

use rayon::prelude::*;

use super::Mesh;
use crate::{Bounds, Shape, Vector};

/// Mirrored vertices may be off the surface by this many welding tolerances.
const SLACK: f64 = 2.0;

/// The planes `(axis, position)`, through the middle of the bounding box, about which the mirror
/// image of every vertex lies on the surface.
pub(super) fn mirrors(mesh: &Mesh, tolerance: f64) -> Vec<(usize, f64)> {
    let mut visible = vec![false; mesh.vertices.len()];
    for (facet, _) in mesh.facets.iter().zip(&mesh.hidden).filter(|f| !f.1) {
        for &vertex in facet {
            visible[vertex as usize] = true;
        }
    }
    let gap = |p: &Vector<3>| (mesh.closest(p).point - p).norm();
    if mesh.exposed.is_some() {
        // A triangle that others cross has corners inside of the solid.
        let on_surface = |v: usize| visible[v] && gap(&mesh.vertices[v]) <= tolerance;
        visible = (0..visible.len()).into_par_iter().map(on_surface).collect();
    }
    let seen = mesh.vertices.iter().zip(&visible).filter(|v| *v.1);
    let vertices: Vec<Vector<3>> = seen.map(|(vertex, _)| *vertex).collect();
    planes(&mesh.bounds(), &vertices, tolerance, gap)
}

/// The planes through the middle of `bounds` about which the images of all vertices have next to no
/// `gap` from the surface.
pub(super) fn planes(
    bounds: &Bounds<3>,
    vertices: &[Vector<3>],
    tolerance: f64,
    gap: impl Fn(&Vector<3>) -> f64 + Sync,
) -> Vec<(usize, f64)> {
    let middle = 0.5 * (bounds.min + bounds.max);
    (0..3)
        .map(|axis| {
            let near_zero = middle[axis].abs() <= tolerance;
            (axis, if near_zero { 0.0 } else { middle[axis] })
        })
        .filter(|&(axis, position)| {
            let on_surface = |p: &Vector<3>| {
                let mut image = *p;
                image[axis] = 2.0 * position - image[axis];
                gap(&image) <= SLACK * tolerance
            };
            vertices.par_iter().all(on_surface)
        })
        .collect()
}
