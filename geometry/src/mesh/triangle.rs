//! The normal and the closest point of a triangle.

use wide::f64x4;

use crate::Vector;

/// Unit normal of a triangle; zero where it has no area.
#[inline]
pub(super) fn normal([a, b, c]: &[Vector<3>; 3]) -> Vector<3> {
    (b - a)
        .cross(&(c - a))
        .try_normalize(0.0)
        .unwrap_or_default()
}

/// The part of a triangle that a point lies on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Feature {
    Face,
    /// The edge from this corner to the next.
    Edge(usize),
    Vertex(usize),
}

/// A point of a triangle.
#[derive(Clone, Copy, Debug)]
pub(super) struct OnTriangle {
    pub point: Vector<3>,
    /// Barycentric weights of the three corners.
    pub weights: [f64; 3],
    pub feature: Feature,
}

/// The part of a triangle that is closest to a point, and where on it that is.
#[derive(Clone, Copy)]
enum Region {
    Vertex(usize),
    /// The edge from this corner to the next, and the part of the way along it.
    Edge(usize, f64),
    /// Weights of the second and the third corner.
    Face(f64, f64),
}

impl Region {
    /// By the region of the triangle's Voronoi diagram that `p` lies in. [Ericson 2005, Real-Time Collision Detection, section 5.1.5]
    #[inline(always)]
    fn of([a, b, c]: &[Vector<3>; 3], p: &Vector<3>) -> Self {
        let (ab, ac, ap) = (b - a, c - a, p - a);
        let (d1, d2) = (ab.dot(&ap), ac.dot(&ap));
        if d1 <= 0.0 && d2 <= 0.0 {
            return Self::Vertex(0);
        }
        let bp = p - b;
        let (d3, d4) = (ab.dot(&bp), ac.dot(&bp));
        if d3 >= 0.0 && d4 <= d3 {
            return Self::Vertex(1);
        }
        let vc = d1 * d4 - d3 * d2;
        if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 && d1 > d3 {
            return Self::Edge(0, part_of_way(d1, d1 - d3));
        }
        let cp = p - c;
        let (d5, d6) = (ab.dot(&cp), ac.dot(&cp));
        if d6 >= 0.0 && d5 <= d6 {
            return Self::Vertex(2);
        }
        let vb = d5 * d2 - d1 * d6;
        if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
            return Self::Edge(2, 1.0 - part_of_way(d2, d2 - d6));
        }
        let va = d3 * d6 - d5 * d4;
        if va <= 0.0 && d4 >= d3 && d5 >= d6 {
            return Self::Edge(1, part_of_way(d4 - d3, (d4 - d3) + (d5 - d6)));
        }
        let scale = 1.0 / (va + vb + vc);
        Self::Face(vb * scale, vc * scale)
    }

    #[inline(always)]
    fn point(self, corners: &[Vector<3>; 3]) -> Vector<3> {
        match self {
            Self::Vertex(corner) => corners[corner],
            Self::Edge(edge, part) => {
                let (from, to) = (&corners[edge], &corners[(edge + 1) % 3]);
                from + (to - from) * part
            }
            Self::Face(v, w) => {
                let [a, b, c] = corners;
                a + (b - a) * v + (c - a) * w
            }
        }
    }

    fn weights(self) -> [f64; 3] {
        let mut weights = [0.0; 3];
        match self {
            Self::Vertex(corner) => weights[corner] = 1.0,
            Self::Edge(edge, part) => {
                weights[edge] = 1.0 - part;
                weights[(edge + 1) % 3] = part;
            }
            Self::Face(v, w) => weights = [1.0 - v - w, v, w],
        }
        weights
    }

    fn feature(self) -> Feature {
        match self {
            Self::Vertex(corner) => Feature::Vertex(corner),
            Self::Edge(edge, _) => Feature::Edge(edge),
            Self::Face(..) => Feature::Face,
        }
    }
}

/// Part of the way along an edge; an edge without length has no parts, and its start stands for it.
fn part_of_way(product: f64, squared: f64) -> f64 {
    let part = product / squared;
    if part > 0.0 { part } else { 0.0 }
}

/// The point of the triangle closest to `p`, and what it lies on.
pub(super) fn closest_on(corners: &[Vector<3>; 3], p: &Vector<3>) -> OnTriangle {
    let region = Region::of(corners, p);
    OnTriangle {
        point: region.point(corners),
        weights: region.weights(),
        feature: region.feature(),
    }
}

/// Triangles that are looked at together.
pub(super) const TOGETHER: usize = 4;

/// How far triangles are from `p`, squared: the least of the distances to their edges and, where `p` is above the face, to
/// that. The products are those of [`Region::of`].
#[inline(always)]
pub(super) fn distances_squared(
    triangles: &[[&Vector<3>; 3]; TOGETHER],
    p: &Three,
) -> [f64; TOGETHER] {
    let [a, b, c] = [
        side_by_side(triangles, 0),
        side_by_side(triangles, 1),
        side_by_side(triangles, 2),
    ];
    let (ab, ac, bc) = (minus(&b, &a), minus(&c, &a), minus(&c, &b));
    let (ap, bp, cp) = (minus(p, &a), minus(p, &b), minus(p, &c));
    let (d1, d2) = (dot(&ab, &ap), dot(&ac, &ap));
    let (d3, d4) = (dot(&ab, &bp), dot(&ac, &bp));
    let (d5, d6) = (dot(&ab, &cp), dot(&ac, &cp));
    let to_edges = to_edge(&ap, &ab, d1, d1 - d3)
        .fast_min(to_edge(&ap, &ac, d2, d2 - d6))
        .fast_min(to_edge(&bp, &bc, d4 - d3, (d4 - d3) + (d5 - d6)));
    let (va, vb, vc) = (d3 * d6 - d5 * d4, d5 * d2 - d1 * d6, d1 * d4 - d3 * d2);
    let scale = f64x4::ONE / (va + vb + vc);
    let foot = along(&along(&ap, &ab, vb * scale), &ac, vc * scale);
    let above = va.fast_min(vb).fast_min(vc).simd_gt(f64x4::ZERO);
    let to_face = above.select(dot(&foot, &foot), f64x4::splat(f64::INFINITY));
    to_face.fast_min(to_edges).to_array()
}

/// Vectors, one in each lane.
pub(super) type Three = [f64x4; 3];

/// The corners with one number.
#[inline(always)]
fn side_by_side([s, t, u, v]: &[[&Vector<3>; 3]; TOGETHER], corner: usize) -> Three {
    let [s, t, u, v] = [s[corner], t[corner], u[corner], v[corner]];
    let along = |axis: usize| f64x4::new([s[axis], t[axis], u[axis], v[axis]]);
    [along(0), along(1), along(2)]
}

#[inline(always)]
fn minus(a: &Three, b: &Three) -> Three {
    std::array::from_fn(|axis| a[axis] - b[axis])
}

#[inline(always)]
fn dot(a: &Three, b: &Three) -> f64x4 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// `offset`, seen from a place that lies the part `part` along `way`.
#[inline(always)]
fn along(offset: &Three, way: &Three, part: f64x4) -> Three {
    std::array::from_fn(|axis| offset[axis] - way[axis] * part)
}

/// Distance squared to an edge, by the offset from its start, its way, their product and the square of its length, as [`part_of_way`].
#[inline(always)]
fn to_edge(offset: &Three, way: &Three, product: f64x4, squared: f64x4) -> f64x4 {
    let part = product / squared;
    let part = part.simd_gt(f64x4::ZERO).select(part, f64x4::ZERO);
    let foot = along(offset, way, part.fast_min(f64x4::ONE));
    dot(&foot, &foot)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn four_triangles_at_once_are_as_far_as_one_by_one() {
        let mut seed = 11_u64;
        let mut next = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (seed >> 11) as f64 / (1_u64 << 53) as f64
        };
        let mut seen = [0; 3];
        for round in 0..5000 {
            let mut triangles: [[Vector<3>; 3]; TOGETHER] = std::array::from_fn(|_| {
                std::array::from_fn(|_| Vector::<3>::from_fn(|_, _| next()))
            });
            // Edges without length, points and needles; of triangles that are lines the nearest part is anyone's guess.
            match round % 5 {
                0 => triangles[0][1] = triangles[0][0],
                1 => {
                    let [a, b, c] = triangles[1];
                    triangles[1][2] = a + 0.7 * (b - a) + 1e-5 * (c - a);
                }
                2 => triangles[2] = [triangles[2][0]; 3],
                3 => triangles[3][2] = triangles[3][1] + 1e-7 * triangles[3][2],
                _ => {}
            }
            let p = Vector::<3>::from_fn(|_, _| 1.6 * next() - 0.3);
            let splat = [p.x, p.y, p.z].map(f64x4::splat);
            let found = distances_squared(&triangles.each_ref().map(<[_; 3]>::each_ref), &splat);
            for (corners, found) in triangles.iter().zip(found) {
                let on = closest_on(corners, &p);
                let expected = (on.point - p).norm();
                assert!((found.sqrt() - expected).abs() < 1e-9, "{corners:?} {p:?}");
                seen[match on.feature {
                    Feature::Face => 0,
                    Feature::Edge(_) => 1,
                    Feature::Vertex(_) => 2,
                }] += 1;
            }
        }
        assert!(seen.iter().all(|&count| count > 800), "{seen:?}");
    }
}
