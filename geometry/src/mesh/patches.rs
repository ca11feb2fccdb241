//! Patches of the surface that end in edges of more than two triangles: no neighbour tells which way
//! one of them faces, but the balance of those edges does.

use std::collections::{BTreeMap, BTreeSet};

use super::edges::{HalfEdge, by_edge, in_pairs, parts};
use super::weld::Indexed;

/// Rounds of turning; what one patch closes may let the next be turned.
const ROUNDS: usize = 20;

/// What one patch adds to its edges.
struct Patch {
    area: f64,
    /// Edge, and how many triangles of the patch run up it less those that run down.
    edges: Vec<(usize, i32)>,
}

/// Turns patches whose edges close better so, as long as no other edge opens: the smaller ones first.
/// Marks the triangles of those; false where there are none.
pub(super) fn turn(mesh: &mut Indexed, half_edges: &[HalfEdge], turned: &mut [bool]) -> bool {
    let crowded = || by_edge(half_edges).filter(|group| group.len() > 2);
    let balance = |group: &[HalfEdge]| group.iter().map(HalfEdge::sign).sum::<i32>();
    if crowded().all(|group| balance(group) == 0) {
        return false;
    }
    let mut open: Vec<i32> = crowded().map(balance).collect();
    let (part, _) = parts(&in_pairs(&mesh.facets, half_edges));
    let mut patches: BTreeMap<u32, Patch> = BTreeMap::new();
    for (edge, group) in crowded().enumerate() {
        for half in group {
            let patch = patches.entry(part[half.facet as usize]).or_insert(Patch {
                area: 0.0,
                edges: Vec::new(),
            });
            match patch.edges.last_mut() {
                Some((last, sum)) if *last == edge => *sum += half.sign(),
                _ => patch.edges.push((edge, half.sign())),
            }
        }
    }
    for (&facet, number) in mesh.facets.iter().zip(&part) {
        if let Some(patch) = patches.get_mut(number) {
            patch.area += mesh.area(facet);
        }
    }
    let mut order: Vec<(u32, Patch)> = patches.into_iter().collect();
    order.sort_by(|a, b| a.1.area.total_cmp(&b.1.area));
    let mut flip = vec![false; order.len()];
    for _ in 0..ROUNDS {
        let before = flip.clone();
        for (flip, (_, patch)) in flip.iter_mut().zip(&mut order) {
            if closes(patch, &open) {
                *flip = !*flip;
                for (edge, sum) in &mut patch.edges {
                    open[*edge] -= 2 * *sum;
                    *sum = -*sum;
                }
            }
        }
        if flip == before {
            break;
        }
    }
    let flipped: BTreeSet<u32> = (order.iter().zip(flip))
        .filter_map(|((number, _), flip)| flip.then_some(*number))
        .collect();
    for (facet, number) in part.iter().enumerate() {
        if flipped.contains(number) {
            mesh.facets[facet].swap(1, 2);
            turned[facet] = !turned[facet];
        }
    }
    !flipped.is_empty()
}

/// True where turning the patch closes an edge better and opens none.
fn closes(patch: &Patch, open: &[i32]) -> bool {
    let gain = |&(edge, sum): &(usize, i32)| open[edge].abs() - (open[edge] - 2 * sum).abs();
    patch.edges.iter().all(|e| gain(e) >= 0) && patch.edges.iter().any(|e| gain(e) > 0)
}
