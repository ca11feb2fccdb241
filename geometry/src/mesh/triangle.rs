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

/// The point of the triangle closest to `p`, by the region of its Voronoi diagram that `p` lies
/// in. [Ericson 2005, Real-Time Collision Detection, section 5.1.5]
#[inline]
pub(super) fn closest_on([a, b, c]: &[Vector<3>; 3], p: &Vector<3>) -> OnTriangle {
    let (ab, ac, ap) = (b - a, c - a, p - a);
    let (d1, d2) = (ab.dot(&ap), ac.dot(&ap));
    if d1 <= 0.0 && d2 <= 0.0 {
        return corner(0, a);
    }
    let bp = p - b;
    let (d3, d4) = (ab.dot(&bp), ac.dot(&bp));
    if d3 >= 0.0 && d4 <= d3 {
        return corner(1, b);
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        return on_edge(0, [a, b], d1 / (d1 - d3));
    }
    let cp = p - c;
    let (d5, d6) = (ab.dot(&cp), ac.dot(&cp));
    if d6 >= 0.0 && d5 <= d6 {
        return corner(2, c);
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        return on_edge(2, [c, a], 1.0 - d2 / (d2 - d6));
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 >= d3 && d5 >= d6 {
        return on_edge(1, [b, c], (d4 - d3) / ((d4 - d3) + (d5 - d6)));
    }
    let scale = 1.0 / (va + vb + vc);
    let (v, w) = (vb * scale, vc * scale);
    OnTriangle {
        point: a + ab * v + ac * w,
        weights: [1.0 - v - w, v, w],
        feature: Feature::Face,
    }
}

fn corner(index: usize, point: &Vector<3>) -> OnTriangle {
    let mut weights = [0.0; 3];
    weights[index] = 1.0;
    OnTriangle {
        point: *point,
        weights,
        feature: Feature::Vertex(index),
    }
}

fn on_edge(edge: usize, [from, to]: [&Vector<3>; 2], part: f64) -> OnTriangle {
    let mut weights = [0.0; 3];
    weights[edge] = 1.0 - part;
    weights[(edge + 1) % 3] = part;
    OnTriangle {
        point: from + (to - from) * part,
        weights,
        feature: Feature::Edge(edge),
    }
}
