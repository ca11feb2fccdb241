//! Creases of a mesh that are convex.

use super::Mesh;
use super::edges::NONE;
use super::smooth::normal;
use crate::{Bounds, Ridge};

impl Mesh {
    /// The edges between triangles that bulge and are creases, as far as they meet `region`.
    pub(super) fn convex_creases(&self, region: &Bounds<3>) -> Vec<Ridge<3>> {
        let mut ridges = Vec::new();
        for facet in 0..self.facets.len() as u32 {
            for edge in 0..3 {
                let other = self.across[facet as usize][edge];
                let is_seen = |f: u32| !self.hidden.get(f as usize).copied().unwrap_or(false);
                if other == NONE || other < facet || !self.smooth.is_crease(facet, edge) {
                    continue;
                }
                let (own, beyond) = (self.corners(facet), self.corners(other));
                let ends = [own[edge], own[(edge + 1) % 3]];
                let normals = [normal(&own), normal(&beyond)];
                let bounds = Bounds::new(ends[0].inf(&ends[1]), ends[0].sup(&ends[1]));
                let middle = (beyond[0] + beyond[1] + beyond[2]) / 3.0;
                let bulges = normals[0].dot(&(middle - ends[0])) < 0.0;
                let is_there = !region.intersection(&bounds).is_empty();
                if bulges && is_there && is_seen(facet) && is_seen(other) {
                    ridges.push(Ridge { ends, normals });
                }
            }
        }
        ridges
    }
}
