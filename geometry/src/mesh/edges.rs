//! Which triangles share which edges.

use rayon::prelude::*;

/// No triangle on the other side.
pub(super) const NONE: u32 = u32::MAX;

/// One side of an edge: the triangle and which of its three edges.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct HalfEdge {
    low: u32,
    high: u32,
    pub facet: u32,
    pub edge: u8,
    /// True where the triangle runs from the lower vertex to the higher.
    pub ascending: bool,
}

impl HalfEdge {
    pub fn vertices(&self) -> [u32; 2] {
        [self.low, self.high]
    }

    /// How much it adds to the balance of its edge, which is zero where the surface is closed.
    pub fn sign(&self) -> i32 {
        if self.ascending { 1 } else { -1 }
    }
}

/// All half-edges, sorted so that those of one edge are neighbours.
pub(super) fn half_edges(facets: &[[u32; 3]]) -> Vec<HalfEdge> {
    let mut all: Vec<HalfEdge> = facets
        .iter()
        .enumerate()
        .flat_map(|(facet, corners)| {
            (0..3).map(move |edge| {
                let (a, b) = (corners[edge], corners[(edge + 1) % 3]);
                HalfEdge {
                    low: a.min(b),
                    high: a.max(b),
                    facet: facet as u32,
                    edge: edge as u8,
                    ascending: a < b,
                }
            })
        })
        .collect();
    all.par_sort_unstable();
    all
}

/// The half-edges of each edge in turn.
pub(super) fn by_edge(half_edges: &[HalfEdge]) -> impl Iterator<Item = &[HalfEdge]> {
    half_edges.chunk_by(|a, b| a.vertices() == b.vertices())
}

/// The triangle across each edge of each triangle, where two meet in it.
pub(super) fn in_pairs(facets: &[[u32; 3]], half_edges: &[HalfEdge]) -> Vec<[u32; 3]> {
    let mut across = vec![[NONE; 3]; facets.len()];
    for group in by_edge(half_edges).filter(|group| group.len() == 2) {
        join(&mut across, &group[0], &group[1]);
    }
    across
}

/// Makes two half-edges' triangles neighbours.
pub(super) fn join(across: &mut [[u32; 3]], a: &HalfEdge, b: &HalfEdge) {
    across[a.facet as usize][a.edge as usize] = b.facet;
    across[b.facet as usize][b.edge as usize] = a.facet;
}

/// The connected parts of a surface, numbered in the order of their first triangles: the part of
/// each triangle, and how many there are.
pub(super) fn parts(across: &[[u32; 3]]) -> (Vec<u32>, usize) {
    let mut part = vec![NONE; across.len()];
    let mut count = 0;
    let mut stack = Vec::new();
    for seed in 0..across.len() {
        if part[seed] != NONE {
            continue;
        }
        part[seed] = count;
        stack.push(seed);
        while let Some(facet) = stack.pop() {
            for &other in across[facet].iter().filter(|&&other| other != NONE) {
                if part[other as usize] == NONE {
                    part[other as usize] = count;
                    stack.push(other as usize);
                }
            }
        }
        count += 1;
    }
    (part, count as usize)
}
