//! The closest point of a triangle.

use crate::Vector;

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
        if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
            return Self::Edge(0, d1 / (d1 - d3));
        }
        let cp = p - c;
        let (d5, d6) = (ab.dot(&cp), ac.dot(&cp));
        if d6 >= 0.0 && d5 <= d6 {
            return Self::Vertex(2);
        }
        let vb = d5 * d2 - d1 * d6;
        if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
            return Self::Edge(2, 1.0 - d2 / (d2 - d6));
        }
        let va = d3 * d6 - d5 * d4;
        if va <= 0.0 && d4 >= d3 && d5 >= d6 {
            return Self::Edge(1, (d4 - d3) / ((d4 - d3) + (d5 - d6)));
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

/// The point of the triangle closest to `p`, and what it lies on.
pub(super) fn closest_on(corners: &[Vector<3>; 3], p: &Vector<3>) -> OnTriangle {
    let region = Region::of(corners, p);
    OnTriangle {
        point: region.point(corners),
        weights: region.weights(),
        feature: region.feature(),
    }
}

/// How far the triangle is from `p`, squared.
#[inline]
pub(super) fn distance_squared(corners: &[Vector<3>; 3], p: &Vector<3>) -> f64 {
    (Region::of(corners, p).point(corners) - p).norm_squared()
}
