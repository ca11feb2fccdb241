//! Places where the surface touches itself, in an edge or in a single vertex. They are no harm: the
//! triangles around one are kept apart by how they hang together.

use super::edges::{HalfEdge, NONE, by_edge};
use super::weld::Indexed;
use crate::Vector;

/// The pinches of a surface.
pub(super) struct Pinches {
    /// Vertices in which the surface touches itself, edges' ends among them; empty where there are none.
    pub vertices: Vec<bool>,
    /// Edges in which more than two triangles meet.
    pub edges: usize,
    /// Vertices that touch without an edge.
    single: usize,
}

impl Pinches {
    pub fn new(mesh: &Indexed, half_edges: &[HalfEdge], across: &[[u32; 3]]) -> Self {
        let mut pinched = vec![false; mesh.vertices.len()];
        let mut edges = 0;
        for group in by_edge(half_edges).filter(|group| group.len() > 2) {
            edges += 1;
            for vertex in group[0].vertices() {
                pinched[vertex as usize] = true;
            }
        }
        let mut single = 0;
        for (pinched, fans) in pinched.iter_mut().zip(fans(mesh, across)) {
            if fans > 1 && !*pinched {
                *pinched = true;
                single += 1;
            }
        }
        if edges + single == 0 {
            pinched = Vec::new();
        }
        Self {
            vertices: pinched,
            edges,
            single,
        }
    }

    /// Tells of the pinches; nothing where there are none.
    pub fn note(&self, vertices: &[Vector<3>]) -> Option<String> {
        let p = vertices[self.vertices.iter().position(|&is| is)?];
        Some(format!(
            "kept {} edges and {} single vertices at which the surface touches itself, one at \
             ({:.6}, {:.6}, {:.6})",
            self.edges, self.single, p.x, p.y, p.z
        ))
    }
}

/// How many fans of triangles, each hanging together across edges, meet in each vertex.
fn fans(mesh: &Indexed, across: &[[u32; 3]]) -> Vec<u32> {
    let mut count = vec![0; mesh.vertices.len()];
    let mut open = Vec::new();
    let mut seen = vec![[false; 3]; mesh.facets.len()];
    for facet in 0..mesh.facets.len() {
        for corner in 0..3 {
            if seen[facet][corner] {
                continue;
            }
            let vertex = mesh.facets[facet][corner];
            count[vertex as usize] += 1;
            open.push((facet, corner));
            seen[facet][corner] = true;
            while let Some((facet, corner)) = open.pop() {
                // The edges that begin and end in the corner.
                for edge in [corner, (corner + 2) % 3] {
                    let other = across[facet][edge];
                    if other == NONE {
                        continue;
                    }
                    let other = other as usize;
                    let place = mesh.facets[other].iter().position(|&v| v == vertex);
                    if let Some(place) = place.filter(|&place| !seen[other][place]) {
                        seen[other][place] = true;
                        open.push((other, place));
                    }
                }
            }
        }
    }
    count
}
