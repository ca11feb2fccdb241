//! Convex cells: an interval, a polygon or a polyhedron, cut by one half-space after another.
//!
//! The cut is decided vertex by vertex and everything else follows from it combinatorially, so that a plane through
//! vertices, edges or whole facets, which is what a lattice offers everywhere, leaves a closed cell like any other.

use aero_geometry::Vector;

/// Part of the unit of length by which a vertex may lie beyond a plane and still count as inside.
const TOLERANCE: f64 = 1e-12;

/// A convex cell around the origin, which is where its point lies.
#[derive(Clone, Debug, PartialEq)]
pub struct Polytope<const D: usize> {
    /// Corners.
    pub vertices: Vec<Vector<D>>,
    /// Sides.
    pub facets: Vec<Facet>,
}

/// One side of a cell.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Facet {
    /// Which plane it lies on: the number given to [`Polytope::clip`], or twice the axis plus the end of the first box.
    pub label: u32,
    /// Vertices, counter-clockwise as seen from outside; in the plane start and end with the outside to the right; on a
    /// line one.
    pub corners: Vec<u32>,
}

impl<const D: usize> Polytope<D> {
    /// The box from `low` to `high`.
    pub fn block(low: &Vector<D>, high: &Vector<D>) -> Self {
        let vertices = (0..1_usize << D)
            .map(|n| Vector::from_fn(|k, _| if n >> k & 1 == 0 { low[k] } else { high[k] }))
            .collect();
        let loops: &[&[u32]] = match D {
            1 => &[&[0], &[1]],
            2 => &[&[2, 0], &[1, 3], &[0, 1], &[3, 2]],
            _ => &[
                &[0, 4, 6, 2],
                &[1, 3, 7, 5],
                &[0, 1, 5, 4],
                &[2, 6, 7, 3],
                &[0, 2, 3, 1],
                &[4, 5, 7, 6],
            ],
        };
        let facets = loops
            .iter()
            .enumerate()
            .map(|(label, corners)| Facet {
                label: label as u32,
                corners: corners.to_vec(),
            })
            .collect();
        Self { vertices, facets }
    }

    /// Square of the distance of the farthest vertex from the origin.
    pub fn reach_squared(&self) -> f64 {
        self.vertices
            .iter()
            .fold(0.0, |most, vertex| most.max(vertex.norm_squared()))
    }

    /// Keeps what lies at `x . normal <= offset`, `normal` a unit vector; lengths are in the order of `unit`. Says
    /// whether anything was cut off.
    pub fn clip(&mut self, normal: &Vector<D>, offset: f64, label: u32, unit: f64) -> bool {
        let tolerance = TOLERANCE * unit;
        let heights = self
            .vertices
            .iter()
            .map(|vertex| vertex.dot(normal) - offset);
        if heights.clone().all(|height| height <= tolerance) {
            return false;
        }
        let mut cut = Cut {
            heights: heights.collect(),
            tolerance,
            made: Vec::new(),
        };
        if D == 1 {
            self.clip_interval(&cut, normal, offset, label);
        } else {
            let mut rim = Vec::new();
            let facets = std::mem::take(&mut self.facets);
            for facet in facets {
                self.clip_facet(facet, &mut cut, &mut rim);
            }
            self.close(&rim, label);
        }
        self.leave_out_unused();
        true
    }

    fn clip_interval(&mut self, cut: &Cut, normal: &Vector<D>, offset: f64, label: u32) {
        for facet in &mut self.facets {
            if cut.is_out(facet.corners[0]) {
                facet.label = label;
                facet.corners[0] = self.vertices.len() as u32;
                self.vertices.push(normal * offset);
            }
        }
    }

    /// Keeps the inner part of a facet, and notes the piece of the new facet's rim that the cut leaves on it.
    fn clip_facet(&mut self, facet: Facet, cut: &mut Cut, rim: &mut Vec<[u32; 2]>) {
        let corners = &facet.corners;
        let out = corners.iter().filter(|&&corner| cut.is_out(corner)).count();
        if out == 0 {
            self.facets.push(facet);
            return;
        }
        if out == corners.len() {
            return;
        }
        let mut kept = Vec::with_capacity(corners.len() + 1);
        let (mut exits, mut entries) = (Vec::new(), Vec::new());
        // An edge of a polygon is an open chain of two.
        let edges = if D == 2 { 1 } else { corners.len() };
        for k in 0..edges {
            let (a, b) = (corners[k], corners[(k + 1) % corners.len()]);
            if !cut.is_out(a) {
                kept.push(a);
            }
            if cut.is_out(a) != cut.is_out(b) {
                let place = cut.vertex(a, b, &mut self.vertices);
                kept.push(place);
                if cut.is_out(b) {
                    exits.push(place);
                } else {
                    entries.push(place);
                }
            }
            if D == 2 && !cut.is_out(b) {
                kept.push(b);
            }
        }
        if D == 2 {
            rim.extend(exits.iter().map(|&exit| [exit, u32::MAX]));
            rim.extend(entries.iter().map(|&entry| [u32::MAX, entry]));
        } else {
            let first = usize::from(cut.is_out(corners[0]));
            let count = exits.len();
            rim.extend((0..count).map(|k| [entries[(k + first) % count], exits[k]]));
        }
        self.facets.push(Facet {
            corners: kept,
            ..facet
        });
    }

    /// Closes the cell over the rim of the cut.
    fn close(&mut self, rim: &[[u32; 2]], label: u32) {
        if D == 2 {
            let exit = rim.iter().find(|piece| piece[1] == u32::MAX);
            let entry = rim.iter().find(|piece| piece[0] == u32::MAX);
            if let (Some(exit), Some(entry)) = (exit, entry) {
                self.facets.push(Facet {
                    label,
                    corners: vec![exit[0], entry[1]],
                });
            }
            return;
        }
        let mut left: Vec<[u32; 2]> = rim.to_vec();
        while let Some([first, mut last]) = left.pop() {
            let mut corners = vec![first];
            while last != first {
                corners.push(last);
                let Some(next) = left.iter().position(|piece| piece[0] == last) else {
                    break;
                };
                last = left.swap_remove(next)[1];
            }
            if corners.len() > 2 {
                self.facets.push(Facet { label, corners });
            }
        }
    }

    fn leave_out_unused(&mut self) {
        let mut place = vec![u32::MAX; self.vertices.len()];
        let mut vertices = Vec::with_capacity(self.vertices.len());
        for facet in &mut self.facets {
            for corner in &mut facet.corners {
                let old = *corner as usize;
                if place[old] == u32::MAX {
                    place[old] = vertices.len() as u32;
                    vertices.push(self.vertices[old]);
                }
                *corner = place[old];
            }
        }
        self.vertices = vertices;
    }

    /// The vertices of a polygon's outline, and the label of the edge that starts at each.
    pub fn outline(&self) -> Vec<(u32, u32)> {
        let mut chain = Vec::with_capacity(self.facets.len());
        let Some(first) = self.facets.first() else {
            return chain;
        };
        let mut edge = first;
        loop {
            chain.push((edge.corners[0], edge.label));
            let end = edge.corners[1];
            let next = self.facets.iter().find(|facet| facet.corners[0] == end);
            match next {
                Some(next) if chain.len() < self.facets.len() => edge = next,
                _ => return chain,
            }
        }
    }
}

/// One cut on its way.
struct Cut {
    /// Of each vertex above the plane.
    heights: Vec<f64>,
    tolerance: f64,
    /// Vertices made so far, by the edges on which they lie.
    made: Vec<([u32; 2], u32)>,
}

impl Cut {
    /// New vertices lie on the plane.
    fn is_out(&self, vertex: u32) -> bool {
        self.heights
            .get(vertex as usize)
            .is_some_and(|&height| height > self.tolerance)
    }

    /// The vertex where the edge between `a` and `b`, one of them out, meets the plane.
    fn vertex<const D: usize>(&mut self, a: u32, b: u32, vertices: &mut Vec<Vector<D>>) -> u32 {
        let [inner, outer] = if self.is_out(a) { [b, a] } else { [a, b] };
        if let Some((_, place)) = self.made.iter().find(|(edge, _)| *edge == [inner, outer]) {
            return *place;
        }
        let (low, high) = (self.heights[inner as usize], self.heights[outer as usize]);
        // One within the tolerance stays where it is.
        let share = (low / (low - high)).clamp(0.0, 1.0);
        let (from, to) = (vertices[inner as usize], vertices[outer as usize]);
        let place = vertices.len() as u32;
        vertices.push(from + (to - from) * share);
        self.made.push(([inner, outer], place));
        place
    }
}

/// The vector product, of vectors in space.
pub fn cross<const D: usize>(a: &Vector<D>, b: &Vector<D>) -> Vector<D> {
    let mut product = Vector::<D>::zeros();
    if D == 3 {
        for k in 0..3 {
            let (l, m) = ((k + 1) % 3, (k + 2) % 3);
            product[k] = a[l] * b[m] - a[m] * b[l];
        }
    }
    product
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Area vector of a loop of points in space, out of the loop that runs counter-clockwise.
    fn loop_area(points: &[Vector<3>]) -> Vector<3> {
        let corners = points.windows(2).skip(1);
        corners
            .map(|pair| 0.5 * cross(&(pair[0] - points[0]), &(pair[1] - points[0])))
            .sum()
    }
    use approx::assert_relative_eq;

    fn volume(cell: &Polytope<3>) -> f64 {
        let mut volume = 0.0;
        for facet in &cell.facets {
            let points: Vec<_> = facet
                .corners
                .iter()
                .map(|&c| cell.vertices[c as usize])
                .collect();
            volume += loop_area(&points).dot(&points[0]) / 3.0;
        }
        volume
    }

    #[test]
    fn a_cube_cut_at_its_corners_keeps_closed() {
        let one = Vector::<3>::repeat(1.0);
        let mut cell = Polytope::block(&-one, &one);
        assert_relative_eq!(volume(&cell), 8.0, epsilon = 1e-14);
        for n in 0..8 {
            let normal = Vector::<3>::from_fn(|k, _| if n >> k & 1 == 0 { -1.0 } else { 1.0 });
            assert!(cell.clip(&normal.normalize(), 2.0 / 3.0_f64.sqrt(), 10 + n, 1.0));
        }
        // A corner at distance 1 from the plane's foot along each axis: 1/6 each.
        assert_relative_eq!(volume(&cell), 8.0 - 8.0 / 6.0, epsilon = 1e-13);
        assert_eq!(cell.facets.len(), 14);
    }

    #[test]
    fn planes_through_vertices_and_facets_cut_nothing() {
        let one = Vector::<3>::repeat(1.0);
        let mut cell = Polytope::block(&-one, &one);
        let before = cell.clone();
        assert!(!cell.clip(&Vector::<3>::x(), 1.0, 9, 1.0));
        assert!(!cell.clip(&one.normalize(), 3.0_f64.sqrt(), 9, 1.0));
        assert!(!cell.clip(
            &Vector::<3>::new(1.0, 1.0, 0.0).normalize(),
            2.0_f64.sqrt(),
            9,
            1.0
        ));
        assert_eq!(cell, before);
    }

    #[test]
    fn a_polygon_keeps_its_outline_in_order() {
        let one = Vector::<2>::repeat(1.0);
        let mut cell = Polytope::block(&-one, &one);
        assert!(cell.clip(&one.normalize(), 0.5_f64.sqrt(), 7, 1.0));
        let outline = cell.outline();
        assert_eq!(outline.len(), 5);
        let at = |k: usize| cell.vertices[outline[k % 5].0 as usize];
        let doubled: f64 = (0..5).map(|k| at(k).perp(&at(k + 1))).sum();
        assert_relative_eq!(0.5 * doubled, 3.5, epsilon = 1e-14);
    }

    #[test]
    fn an_interval_ends_at_the_plane() {
        let mut cell = Polytope::block(&Vector::<1>::new(-3.0), &Vector::<1>::new(3.0));
        assert!(cell.clip(&Vector::<1>::new(-1.0), 0.5, 4, 1.0));
        let low = cell.facets.iter().find(|facet| facet.label == 4).unwrap();
        assert_relative_eq!(cell.vertices[low.corners[0] as usize][0], -0.5);
    }
}
