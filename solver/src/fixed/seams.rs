//! Seams: where bodies in space meet the planes that close the domain, as a hollow that gas turns at. A leading edge that lies in a mirror is one.

use aero_geometry::{Bounds, Crease, Shape, Vector};

use super::edge::Edge;
use super::polytope::cross;
use crate::problem::{Problem, Side};
use crate::walls::wall_sides;

/// Owner of planes of symmetry, which are as walls to gas that slides along.
pub const MIRROR: u32 = u32::MAX;

/// Turn from which on no shock stands in a seam, radians: 60 degrees. What a plane cuts square, as half of a round body, goes on beyond it.
const BLUNT: f64 = std::f64::consts::FRAC_PI_3;

/// Corners this near to a plane, in spacings, lie in it.
const IN_PLANE: f64 = 1e-6;

/// The seams of the bodies of `problem`, curved ones in pieces about `size` long.
pub fn seams<const D: usize>(problem: &Problem<D>, size: f64) -> Vec<Edge<D>> {
    let domain = &problem.domain;
    let walls = wall_sides(domain);
    let mut found = Vec::new();
    for (axis, end, side, position) in domain.each_side() {
        let place = walls.iter().position(|wall| *wall == (axis, end));
        let owner = match (side, place) {
            (Side::Symmetry, _) => MIRROR,
            (_, Some(number)) => (problem.bodies.len() + number) as u32,
            _ => continue,
        };
        let mut inwards = Vector::zeros();
        inwards[axis] = [1.0, -1.0][end];
        let plane = Plane {
            inwards,
            depth: position * inwards[axis],
            tolerance: IN_PLANE * size,
        };
        let mut region = domain.bounds;
        region.min[axis] = position;
        region.max[axis] = position;
        for (body, shape) in (0_u32..).zip(problem.bodies.iter().map(|body| &body.shape)) {
            let pieces = plane.pieces(shape.as_ref(), size, &region.grown(plane.tolerance));
            found.extend(pieces.into_iter().map(|crease| Edge {
                owners: [owner, body],
                crease,
            }));
        }
    }
    found
}

/// A plane that closes the domain.
struct Plane<const D: usize> {
    /// Its unit normal, into the domain.
    inwards: Vector<D>,
    /// Where it is along that.
    depth: f64,
    /// What is nearer than this lies in it.
    tolerance: f64,
}

impl<const D: usize> Plane<D> {
    /// The seams of a body within a `region` of the plane.
    fn pieces(&self, shape: &dyn Shape<D>, size: f64, region: &Bounds<D>) -> Vec<Crease<D>> {
        let mut pieces = Vec::new();
        if !shape
            .bounds()
            .grown(self.tolerance)
            .intersection(region)
            .is_empty()
        {
            shape.for_each_facet(size, region, &mut |facet| {
                let normal = cross(&(facet[1] - facet[0]), &(facet[2 % D] - facet[0]));
                if let (Some(ends), Some(normal)) = (self.cut(&facet), normal.try_normalize(0.0)) {
                    let piece = Crease {
                        ends,
                        normals: [self.inwards, normal],
                        is_convex: false,
                    };
                    pieces.extend((piece.turn() < BLUNT).then_some(piece));
                }
            });
        }
        pieces
    }

    /// Height of a place over the plane, where it is not in it.
    fn height(&self, place: &Vector<D>) -> f64 {
        let height = place.dot(&self.inwards) - self.depth;
        if height.abs() < self.tolerance {
            0.0
        } else {
            height
        }
    }

    /// The segment in which a facet that is over the plane, or in part, meets it.
    fn cut(&self, facet: &[Vector<D>; D]) -> Option<[Vector<D>; 2]> {
        let heights = facet.each_ref().map(|corner| self.height(corner));
        if heights.iter().all(|height| *height <= 0.0) {
            return None;
        }
        let mut ends = Vec::with_capacity(2);
        for n in 0..D {
            let next = (n + 1) % D;
            if heights[n] == 0.0 {
                ends.push(facet[n]);
            } else if heights[n] * heights[next] < 0.0 {
                // Of an edge that two facets share both say the same to the last bit.
                let [low, high] = if heights[n] < 0.0 {
                    [n, next]
                } else {
                    [next, n]
                };
                let part = heights[low] / (heights[low] - heights[high]);
                ends.push(facet[low] + (facet[high] - facet[low]) * part);
            }
        }
        <[Vector<D>; 2]>::try_from(ends).ok()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixed::tests::flows::stream;
    use crate::fixed::tests::lattice::WALL;
    use crate::fixed::tests::ridges::prism;

    /// A ramp of 20 degrees on the floor and one under the roof, with backs that stand square on them; by whom sides are owned.
    #[test]
    fn seams_face_into_the_domain_on_either_side_of_it() {
        let rise = f64::to_radians(20.0).tan();
        let on_floor = [[0.0, -0.1], [1.0, -0.1], [1.0, rise], [0.0, 0.0]];
        let under_roof = [[0.0, 1.0], [1.0, 1.0 - rise], [1.0, 1.1], [0.0, 1.1]];
        let bodies = [on_floor, under_roof].map(|section| prism(&section, [-1.0, 1.0]));
        let bounds = [[-0.5, 0.0, -0.5], [1.5, 1.0, 0.5]];
        let mut problem = stream(3.0, bounds, 0.1, bodies.to_vec());
        problem.domain.sides[1] = [WALL, Side::Symmetry];
        let found = seams(&problem, 0.1);
        for (owners, way) in [([2, 0], 1.0), ([MIRROR, 1], -1.0)] {
            let own = found.iter().filter(|edge| edge.owners == owners);
            let own: Vec<_> = own.map(|edge| edge.crease).collect();
            assert!(!own.is_empty(), "{found:?}");
            for seam in own {
                assert_eq!(seam.normals[0], Vector::<3>::new(0.0, way, 0.0));
                assert!((seam.turn().to_degrees() - 20.0).abs() < 1e-6 && !seam.is_convex);
                assert!(seam.ends.iter().all(|end| end.x.abs() < 1e-9));
            }
        }
        let has_owners = |edge: &Edge<3>| [[2, 0], [MIRROR, 1]].contains(&edge.owners);
        assert!(found.iter().all(has_owners));
    }

    /// Pieces of a seam meet in places that are the same to the last bit.
    #[test]
    fn facets_that_share_an_edge_end_alike() {
        let [a, b, c, d] = [
            [0.1, -0.83, 0.3],
            [0.7, 0.31, 0.2],
            [0.9, 0.4, 1.7],
            [0.35, -0.77, -1.9],
        ]
        .map(Vector::from);
        let [one, other] = [[a, b, c], [b, a, d]].map(|facet| FLOOR.cut(&facet).unwrap());
        assert!(
            one.iter().any(|end| other.contains(end)),
            "{one:?} {other:?}"
        );
    }

    const FLOOR: Plane<3> = Plane {
        inwards: Vector::<3>::new(0.0, 1.0, 0.0),
        depth: -0.5,
        tolerance: 1e-6,
    };

    fn cut(heights: [f64; 3]) -> Option<[Vector<3>; 2]> {
        let [a, b, c] = heights.map(|height| height - 0.5);
        FLOOR.cut(&[[0.0, a, 0.0], [1.0, b, 0.0], [0.0, c, 1.0]].map(Vector::from))
    }

    /// Through it, from a corner on, along an edge; not what is beyond, lies in it, or ends there in a corner.
    #[test]
    fn facets_that_reach_over_a_plane_meet_it_in_a_segment() {
        let [from, to] = cut([-1.0, 1.0, 1.0]).unwrap();
        assert_eq!((from[1], to[1]), (-0.5, -0.5));
        assert!((from - Vector::<3>::new(0.5, -0.5, 0.0)).norm() < 1e-12);
        assert!((to - Vector::<3>::new(0.0, -0.5, 0.5)).norm() < 1e-12);
        assert!(cut([0.0, 1.0, -1.0]).is_some());
        assert!(cut([1e-9, 1.0, 0.0]).is_some());
        for none in [
            [0.0, -1.0, 0.0],
            [0.0; 3],
            [0.0, 1.0, 1.0],
            [-1.0; 3],
            [1.0; 3],
        ] {
            assert!(cut(none).is_none(), "{none:?}");
        }
    }
}
