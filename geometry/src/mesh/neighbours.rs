//! Which triangles of an oriented surface lie across which edges.

use super::edges::{HalfEdge, by_edge, in_pairs, join};
use super::wedges::wedges;
use super::weld::Indexed;

/// The triangle across each edge of each triangle of an oriented surface. Where more than two meet,
/// those that bound one wedge of the solid are neighbours.
pub(super) fn neighbours(mesh: &Indexed, half_edges: &[HalfEdge]) -> Vec<[u32; 3]> {
    let mut across = in_pairs(&mesh.facets, half_edges);
    for group in by_edge(half_edges).filter(|group| group.len() > 2) {
        for [a, b] in wedges(mesh, group) {
            join(&mut across, &a, &b);
        }
    }
    across
}
