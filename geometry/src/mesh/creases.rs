//! Which edges of a mesh part smooth surfaces, and which stand for a part of a curve.

use super::edges::NONE;
use super::triangle::normal;
use crate::Vector;

/// An edge that bends more than this (radians; 30 degrees) is a crease.
const CREASE: f64 = std::f64::consts::FRAC_PI_6;

/// An edge that bends less than this (radians; 3 degrees) is never a crease.
pub(super) const FLAT: f64 = std::f64::consts::PI / 60.0;

/// So many bends, one after the other, are a curve; fewer are edges, of a ramp or a rhombus.
const CURVE: usize = 4;

/// A surface bends on at an edge that turns by at least this part of what it does there.
const ALIKE: f64 = 1.0 / 3.0;

/// The next bend of a curve is not farther than this, in widths of the wider triangle at an edge.
const REACH: f64 = 2.5;

/// Triangles passed on the way to the next bend, at most.
const MOST: usize = 64;

/// A triangulated surface.
#[derive(Clone, Copy)]
pub(super) struct Creases<'a> {
    pub vertices: &'a [Vector<3>],
    pub facets: &'a [[u32; 3]],
    /// The triangle across each edge of each.
    pub across: &'a [[u32; 3]],
}

/// On the way across a surface.
#[derive(Clone, Copy)]
struct Walk {
    facet: u32,
    /// The edge of it that was crossed last.
    edge: usize,
    at: Vector<3>,
    /// Unit vector in the plane of the triangle.
    way: Vector<3>,
}

impl Creases<'_> {
    fn corners(&self, facet: u32) -> [Vector<3>; 3] {
        self.facets[facet as usize].map(|v| self.vertices[v as usize])
    }

    /// True where an edge of a triangle parts smooth surfaces.
    ///
    /// Some degrees may be a ridge, as of a fin, or stand for a part of a curve: what is beside them tells, for a curve bends on.
    pub fn has(&self, facet: u32, edge: usize) -> bool {
        let other = self.across[facet as usize][edge];
        if other == NONE {
            return true;
        }
        // Most edges are of fine surfaces, and flat: an angle takes longer than its tangent.
        let (a, b) = (normal(&self.corners(facet)), normal(&self.corners(other)));
        let along = a.dot(&b);
        if along > 0.0 && a.cross(&b).norm_squared() <= (FLAT.tan() * along).powi(2) {
            return false;
        }
        let bend = self.bend(facet, edge).abs();
        if bend <= FLAT || bend > CREASE {
            return bend > CREASE;
        }
        let beyond = self.width(other, self.back(other, facet));
        !self.is_curve(facet, edge, REACH * self.width(facet, edge).max(beyond))
    }

    /// Angle between the triangles that share an edge, radians; positive where the surface bulges.
    fn bend(&self, facet: u32, edge: usize) -> f64 {
        let (own, other) = (
            self.corners(facet),
            self.corners(self.across[facet as usize][edge]),
        );
        let (a, b) = (normal(&own), normal(&other));
        let middle = (other[0] + other[1] + other[2]) / 3.0;
        let angle = a.cross(&b).norm().atan2(a.dot(&b));
        angle.copysign(-a.dot(&(middle - own[edge])))
    }

    /// Height of a triangle over an edge.
    fn width(&self, facet: u32, edge: usize) -> f64 {
        let corners = self.corners(facet);
        let along = corners[(edge + 1) % 3] - corners[edge];
        let doubled = (corners[1] - corners[0]).cross(&(corners[2] - corners[0]));
        doubled.norm() / along.norm()
    }

    /// The edge of `facet` that `other` lies across.
    fn back(&self, facet: u32, other: u32) -> usize {
        let edges = self.across[facet as usize];
        edges.iter().position(|&f| f == other).unwrap_or(0)
    }

    /// True of an edge that is one of several alike, one after the other across it.
    fn is_curve(&self, facet: u32, edge: usize, reach: f64) -> bool {
        let bend = self.bend(facet, edge);
        let other = self.across[facet as usize][edge];
        let sides = [(facet, edge), (other, self.back(other, facet))];
        let count: usize = sides
            .into_iter()
            .filter_map(|(facet, edge)| self.start(facet, edge))
            .map(|walk| self.bends_on(walk, bend, reach))
            .sum();
        1 + count >= CURVE
    }

    /// From the middle of an edge straight into a triangle; none where it has no area.
    fn start(&self, facet: u32, edge: usize) -> Option<Walk> {
        let corners = self.corners(facet);
        let (a, b) = (corners[edge], corners[(edge + 1) % 3]);
        let way = normal(&corners).cross(&(b - a)).try_normalize(0.0)?;
        let at = 0.5 * (a + b);
        Some(Walk {
            facet,
            edge,
            at,
            way,
        })
    }

    /// How many times the surface bends on as by `bend`, within `reach` each, up to as often as makes a curve.
    fn bends_on(&self, mut walk: Walk, bend: f64, reach: f64) -> usize {
        let mut count = 0;
        while count + 1 < CURVE {
            let Some(next) = self.next_bend(walk, bend, reach) else {
                break;
            };
            walk = next;
            count += 1;
        }
        count
    }

    /// Where the surface has bent on, along the way, as by `bend`, be that at one edge or at several; none within `reach`, nor beyond a crease or
    /// a rim.
    fn next_bend(&self, mut walk: Walk, bend: f64, reach: f64) -> Option<Walk> {
        let (from, ahead) = (walk.at, walk.way);
        let above = normal(&self.corners(walk.facet));
        for _ in 0..MOST {
            let edge = self.way_out(&mut walk)?;
            if (walk.at - from).norm() > reach {
                return None;
            }
            let other = self.across[walk.facet as usize][edge];
            if other == NONE || self.bend(walk.facet, edge).abs() > CREASE {
                return None;
            }
            let plane = normal(&self.corners(other));
            walk = Walk {
                facet: other,
                edge: self.back(other, walk.facet),
                at: walk.at,
                way: (walk.way - plane * plane.dot(&walk.way)).try_normalize(0.0)?,
            };
            let turned = plane.dot(&ahead).atan2(plane.dot(&above));
            if turned * bend.signum() >= ALIKE * bend.abs() {
                return Some(walk);
            }
        }
        None
    }

    /// Goes on to the edge by which the way leaves its triangle, and tells which that is; none where there is no telling.
    fn way_out(&self, walk: &mut Walk) -> Option<usize> {
        let corners = self.corners(walk.facet);
        let plane = normal(&corners);
        let others = (0..3).filter(|&k| k != walk.edge);
        let reached = others.filter_map(|k| {
            let along = corners[(k + 1) % 3] - corners[k];
            let outward = along.cross(&plane);
            let speed = walk.way.dot(&outward);
            (speed > 0.0).then(|| (k, (corners[k] - walk.at).dot(&outward) / speed))
        });
        let (edge, far) = reached.min_by(|a, b| a.1.total_cmp(&b.1))?;
        walk.at += walk.way * far.max(0.0);
        Some(edge)
    }
}

#[cfg(test)]
mod tests {
    use crate::{Bounds, Mesh, Shape, Vector};

    /// The section of a prism, from `z = 0` to `span`, each side in `rows` strips along the span and `columns` across.
    fn prism(section: &[[f64; 2]], span: f64, [rows, columns]: [usize; 2]) -> Mesh {
        let count = section.len();
        let mut facets = Vec::new();
        let mix = |a: f64, b: f64, n: usize, of: usize| a + (b - a) * n as f64 / of as f64;
        for n in 0..count {
            let (from, to) = (section[n], section[(n + 1) % count]);
            let at = |i: usize, j: usize| {
                let [x, y] = [0, 1].map(|k| mix(from[k], to[k], i, columns));
                Vector::<3>::new(x, y, mix(0.0, span, j, rows))
            };
            for i in 0..columns {
                for j in 0..rows {
                    facets.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
                    facets.push([at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
                }
            }
        }
        // The ends, from the middle to the same vertices.
        let middle = |z: f64| Vector::<3>::new(0.5, 0.0, z);
        for n in 0..count {
            let (from, to) = (section[n], section[(n + 1) % count]);
            for i in 0..columns {
                let [a, b] = [i, i + 1].map(|i| [0, 1].map(|k| mix(from[k], to[k], i, columns)));
                let place = |p: [f64; 2], z: f64| Vector::<3>::new(p[0], p[1], z);
                facets.push([middle(0.0), place(b, 0.0), place(a, 0.0)]);
                facets.push([middle(span), place(a, span), place(b, span)]);
            }
        }
        Mesh::from_facets(facets).expect("a prism")
    }

    /// Length of the edges that bulge by less than 60 degrees.
    fn ridges(mesh: &Mesh) -> f64 {
        let all = Bounds::new(Vector::repeat(-99.0), Vector::repeat(99.0));
        let ridges = mesh.creases(0.1, &all);
        let shallow = ridges
            .iter()
            .filter(|ridge| ridge.is_convex && ridge.turn() < 1.0);
        shallow
            .map(|ridge| (ridge.ends[1] - ridge.ends[0]).norm())
            .sum()
    }

    const DIAMOND: [[f64; 2]; 4] = [[0.0, 0.0], [0.5, -0.05], [1.0, 0.0], [0.5, 0.05]];

    /// A wing's ridges bend by 11 degrees whatever its span, and however its faces are cut up.
    #[test]
    fn ridges_of_a_wing_are_creases_at_any_span() {
        for span in [0.5, 4.0, 40.0] {
            for cut in [[1, 1], [8, 1], [1, 5], [12, 7]] {
                let found = ridges(&prism(&DIAMOND, span, cut));
                assert!(
                    (found / (2.0 * span) - 1.0).abs() < 1e-9,
                    "{span} {cut:?}: {found}"
                );
            }
        }
    }

    /// So do those of a section of six sides, two to a face.
    #[test]
    fn two_bends_are_no_curve() {
        let section = [
            [0.0, 0.0],
            [0.3, -0.04],
            [0.7, -0.04],
            [1.0, 0.0],
            [0.7, 0.04],
            [0.3, 0.04],
        ];
        for cut in [[1, 1], [6, 4]] {
            let found = ridges(&prism(&section, 8.0, cut));
            assert!((found / 32.0 - 1.0).abs() < 1e-9, "{cut:?}: {found}");
        }
    }

    /// A round bar of 24 sides is round, and so is a wing whose faces are arcs of eight pieces, but for its two edges.
    #[test]
    fn curves_have_no_creases() {
        let round: Vec<[f64; 2]> = (0..24)
            .map(|n| {
                let (sine, cosine) = (f64::from(n) * std::f64::consts::TAU / 24.0).sin_cos();
                [0.5 + 0.5 * cosine, 0.5 * sine]
            })
            .collect();
        let thick = |x: f64| 1.2 * x * (1.0 - x);
        let lower = (0..8).map(|n| f64::from(n) / 8.0).map(|x| [x, -thick(x)]);
        let upper = (0..8)
            .map(|n| 1.0 - f64::from(n) / 8.0)
            .map(|x| [x, thick(x)]);
        let arcs: Vec<[f64; 2]> = lower.chain(upper).collect();
        for section in [round, arcs] {
            for cut in [[1, 1], [9, 1], [3, 2]] {
                assert_eq!(ridges(&prism(&section, 5.0, cut)), 0.0, "{cut:?}");
            }
        }
    }

    /// An octahedron whose faces are cut in four, so many times, drawn out to an ellipsoid.
    fn ellipsoid(times: usize, axes: [f64; 3]) -> Mesh {
        let unit =
            |k: usize, sign: f64| Vector::<3>::from_fn(|n, _| if n == k { sign } else { 0.0 });
        let mut facets = Vec::new();
        for [x, y, z] in [
            [1, 1, 1],
            [-1, 1, 1],
            [1, -1, 1],
            [1, 1, -1],
            [-1, -1, 1],
            [-1, 1, -1],
            [1, -1, -1],
            [-1, -1, -1],
        ] {
            let [a, b, c] = [
                unit(0, f64::from(x)),
                unit(1, f64::from(y)),
                unit(2, f64::from(z)),
            ];
            facets.push(if x * y * z > 0 { [a, b, c] } else { [a, c, b] });
        }
        for _ in 0..times {
            facets = facets
                .into_iter()
                .flat_map(|[a, b, c]| {
                    let [d, e, f] =
                        [a + b, b + c, c + a].map(|middle: Vector<3>| middle.normalize());
                    [[a, d, f], [d, b, e], [f, e, c], [d, e, f]]
                })
                .collect();
        }
        let place = |at: Vector<3>| at.component_mul(&Vector::from(axes));
        Mesh::from_facets(facets.into_iter().map(|facet| facet.map(place)).collect())
            .expect("an ellipsoid")
    }

    /// Triangles of all shapes, and edges that run every way.
    #[test]
    fn round_bodies_have_no_creases() {
        for times in [3, 4] {
            for axes in [[1.0; 3], [1.0, 0.8, 1.3], [2.0, 1.0, 1.0]] {
                let found = ridges(&ellipsoid(times, axes));
                assert_eq!(found, 0.0, "{times} {axes:?}");
            }
        }
    }
}
