//! Needles without area: they are flipped into their neighbours, which closes what dropping them
//! would tear open.

use std::collections::HashSet;

use super::edges::{NONE, half_edges};
use super::neighbours::neighbours;
use super::weld::Indexed;

/// Rounds of flipping; a needle may need several where many lie side by side.
const ROUNDS: usize = 20;

/// Twice the area over the longest edge: the height of a triangle over that edge, and the edge.
fn height(mesh: &Indexed, [a, b, c]: [u32; 3]) -> (f64, usize) {
    let [a, b, c] = [a, b, c].map(|v| mesh.vertices[v as usize]);
    let lengths = [(b - a).norm(), (c - b).norm(), (a - c).norm()];
    let mut longest = 0;
    for edge in 1..3 {
        if lengths[edge] > lengths[longest] {
            longest = edge;
        }
    }
    ((b - a).cross(&(c - a)).norm() / lengths[longest], longest)
}

/// True for triangles whose height is lost in the rounding of their corners.
pub(super) fn is_sliver(mesh: &Indexed, facet: [u32; 3]) -> bool {
    height(mesh, facet).0 <= mesh.tolerance
}

/// Exchanges the long edge that a needle shares with its neighbour for the other diagonal of the
/// two, wherever that helps.
pub(super) fn flip(mesh: &mut Indexed, repairs: &mut Vec<String>) {
    let mut flipped = 0;
    for _ in 0..ROUNDS {
        let slivers: Vec<usize> = (0..mesh.facets.len())
            .filter(|&facet| is_sliver(mesh, mesh.facets[facet]))
            .collect();
        if slivers.is_empty() {
            break;
        }
        let before = flipped;
        flipped += round(mesh, &slivers);
        if flipped == before {
            break;
        }
    }
    if flipped > 0 {
        repairs.push(format!("flipped {flipped} needle triangles without area"));
    }
}

fn round(mesh: &mut Indexed, slivers: &[usize]) -> usize {
    let half_edges = half_edges(&mesh.facets);
    let across = neighbours(mesh, &half_edges);
    let exists = |a: u32, b: u32| {
        let edge = [a.min(b), a.max(b)];
        half_edges
            .binary_search_by(|half| half.vertices().cmp(&edge))
            .is_ok()
    };
    let mut touched = vec![false; mesh.facets.len()];
    let mut made: HashSet<[u32; 2]> = HashSet::new();
    let mut flipped = 0;
    for &facet in slivers {
        let (low, edge) = height(mesh, mesh.facets[facet]);
        let other = across[facet][edge];
        if other == NONE || touched[facet] || touched[other as usize] {
            continue;
        }
        let other = other as usize;
        let corners = mesh.facets[facet];
        let [a, c, b] = [
            corners[edge],
            corners[(edge + 1) % 3],
            corners[(edge + 2) % 3],
        ];
        let Some(&d) = mesh.facets[other].iter().find(|&&v| v != a && v != c) else {
            continue;
        };
        let new = [[b, a, d], [d, c, b]];
        let better = b != d && new.iter().all(|&f| height(mesh, f).0 > low);
        if !better || exists(b, d) || made.contains(&[b.min(d), b.max(d)]) {
            continue;
        }
        for changed in [facet, other] {
            touched[changed] = true;
            for &near in across[changed].iter().filter(|&&near| near != NONE) {
                touched[near as usize] = true;
            }
        }
        mesh.facets[facet] = new[0];
        mesh.facets[other] = new[1];
        made.insert([b.min(d), b.max(d)]);
        flipped += 1;
    }
    flipped
}
