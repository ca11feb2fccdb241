//! The edges of a cell and where they cross the surface: found once, for both facets that meet in an edge.

use aero_geometry::Vector;

use super::polytope::Polytope;
use super::section::Edge;
use super::solids::{Line, Solids};
use super::whole::Whole;

/// Where the edges of a cell cross the surface.
pub struct Edges<const D: usize> {
    /// Of each vertex.
    heights: Vec<f64>,
    /// By their two vertices, the lower number first.
    crossings: Vec<([u32; 2], Vec<f64>)>,
}

impl<const D: usize> Edges<D> {
    /// Of a cell.
    pub fn new(whole: &Whole<'_, D>, solids: &Solids<D>) -> Self {
        let cell = whole.cell;
        let height = |vertex: &Vector<D>| solids.height(&(whole.point + vertex));
        let mut edges = Self {
            heights: cell.vertices.iter().map(height).collect(),
            crossings: Vec::new(),
        };
        for facet in &cell.facets {
            let corners = &facet.corners;
            let count = if D == 3 { corners.len() } else { D - 1 };
            for k in 0..count {
                let (a, b) = (corners[k], corners[(k + 1) % corners.len()]);
                let key = [a.min(b), a.max(b)];
                if edges.crossings.iter().any(|(known, _)| *known == key) {
                    continue;
                }
                let line = Line {
                    from: whole.point + cell.vertices[key[0] as usize],
                    to: whole.point + cell.vertices[key[1] as usize],
                    unit: whole.unit,
                };
                let ends = key.map(|vertex| edges.heights[vertex as usize]);
                edges.crossings.push((key, solids.crossings(&line, ends)));
            }
        }
        edges
    }

    /// The edges of the polygon through `corners`.
    pub fn around(&self, cell: &Polytope<D>, corners: &[u32]) -> Vec<Edge<D>> {
        let count = corners.len();
        let edge = |k: usize| {
            let (a, b) = (corners[k], corners[(k + 1) % count]);
            let key = [a.min(b), a.max(b)];
            let known = self.crossings.iter().find(|(edge, _)| *edge == key);
            let mut crossings = known.map_or_else(Vec::new, |(_, parts)| parts.clone());
            if a > b {
                crossings.reverse();
                for part in &mut crossings {
                    *part = 1.0 - *part;
                }
            }
            Edge {
                from: cell.vertices[a as usize],
                to: cell.vertices[b as usize],
                starts_in_gas: self.heights[a as usize] > 0.0,
                crossings,
                is_reversed: a > b,
            }
        };
        (0..count).map(edge).collect()
    }
}
