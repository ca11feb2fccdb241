//! Creases of a mesh as edges in space.

use super::Mesh;
use super::edges::NONE;
use super::triangle::normal;
use crate::{Bounds, Crease};

impl Mesh {
    /// The edges between triangles that are creases, as far as they meet `region`.
    pub(super) fn sharp_edges(&self, region: &Bounds<3>) -> Vec<Crease<3>> {
        let mut found = Vec::new();
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
                let is_convex = normals[0].dot(&(middle - ends[0])) < 0.0;
                let is_there = !region.intersection(&bounds).is_empty();
                if is_there && is_seen(facet) && is_seen(other) {
                    found.push(Crease {
                        ends,
                        normals,
                        is_convex,
                    });
                }
            }
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Shape, Vector};

    /// The solid below a roof with a ridge and a valley, a metre wide.
    fn roof() -> Mesh {
        let section = [
            [0.0, -1.0],
            [3.0, -1.0],
            [3.0, 0.0],
            [2.0, -0.3],
            [1.0, 0.3],
            [0.0, 0.0],
        ];
        let at = |n: usize, z: f64| Vector::<3>::new(section[n % 6][0], section[n % 6][1], z);
        let mut facets = Vec::new();
        for n in 0..6 {
            facets.push([at(n, 0.0), at(n + 1, 0.0), at(n + 1, 1.0)]);
            facets.push([at(n, 0.0), at(n + 1, 1.0), at(n, 1.0)]);
        }
        for [a, b, c] in [[0, 4, 5], [0, 1, 4], [1, 3, 4], [1, 2, 3]] {
            facets.push([at(a, 1.0), at(b, 1.0), at(c, 1.0)]);
            facets.push([at(a, 0.0), at(c, 0.0), at(b, 0.0)]);
        }
        Mesh::from_facets(facets).unwrap()
    }

    #[test]
    fn ridges_and_valleys_are_told_apart() {
        let all = Bounds::new(Vector::repeat(-9.0), Vector::repeat(9.0));
        let (ridges, valleys): (Vec<_>, Vec<_>) = roof()
            .creases(0.1, &all)
            .into_iter()
            .partition(|crease| crease.is_convex);
        let along = |creases: &[Crease<3>], x: f64, y: f64| {
            let there = |end: &Vector<3>| (end.x - x).abs() < 1e-12 && (end.y - y).abs() < 1e-12;
            let on = creases
                .iter()
                .filter(|crease| crease.ends.iter().all(there));
            on.map(Crease::turn).next()
        };
        let turn = f64::atan(0.3) + f64::atan(0.6);
        assert!((along(&ridges, 1.0, 0.3).unwrap() - turn).abs() < 1e-12);
        assert!((along(&valleys, 2.0, -0.3).unwrap() - turn).abs() < 1e-12);
        // The outline of both ends as well, but for the diagonals of sides.
        assert_eq!([ridges.len(), valleys.len()], [5 + 12, 1]);
        let above = Bounds::new(
            Vector::<3>::new(0.5, 0.1, 0.2),
            Vector::<3>::new(1.5, 0.9, 0.8),
        );
        assert_eq!(roof().creases(0.1, &above).len(), 1);
    }
}
