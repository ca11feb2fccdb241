//! Places where the surface touches itself, in an edge or in a single vertex. They are no harm: the
//! triangles around one are kept apart by how they hang together.

use super::edges::{HalfEdge, NONE, by_edge};
use super::weld::Indexed;

/// Tells of pinches; nothing where there are none.
pub(super) fn found(
    mesh: &Indexed,
    half_edges: &[HalfEdge],
    across: &[[u32; 3]],
) -> Option<String> {
    let mut pinched = vec![false; mesh.vertices.len()];
    let mut edges = 0;
    for group in by_edge(half_edges).filter(|group| group.len() > 2) {
        edges += 1;
        for vertex in group[0].vertices() {
            pinched[vertex as usize] = true;
        }
    }
    let mut first = pinched.iter().position(|&is| is);
    let mut vertices = 0;
    for (vertex, fans) in fans(mesh, across).into_iter().enumerate() {
        if fans > 1 && !pinched[vertex] {
            vertices += 1;
            first = first.or(Some(vertex));
        }
    }
    let p = mesh.vertices[first?];
    Some(format!(
        "kept {edges} edges and {vertices} single vertices at which the surface touches itself, one at \
         ({:.6}, {:.6}, {:.6})",
        p.x, p.y, p.z
    ))
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
