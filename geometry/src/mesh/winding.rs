//! The winding number of a closed surface: how many times it winds around a point, counted by the
//! triangles that a ray from there passes through, outwards for, inwards against.
//!
//! On a closed surface this is the sum of all solid angles over 4 pi, a whole number, and exact: sums
//! over far parts of the surface by their dipoles are off by more than a half inside of some
//! hundred thousand small solids.

use super::tree::Tree;
use crate::Vector;

/// Directions of the rays, tried in turn until one meets no edge. No two corners of a body that
/// somebody made lie in such a direction from each other.
const DIRECTIONS: [[f64; 3]; 4] = [
    [0.304_762_1, 0.529_118_7, 0.791_938_3],
    [-0.830_217_9, 0.447_361_3, 0.332_516_9],
    [0.412_873_7, -0.871_204_1, 0.265_639_7],
    [-0.228_117_3, -0.361_942_9, -0.903_867_1],
];

/// A point on an edge, where the number jumps, is asked for this part of the surface's diagonal away.
const NUDGE: f64 = 1e-11;

/// Points so many tolerances off a triangle are off what lies on it, too, which is within one of it. Farther off they may be through what is
/// really there: where parts overlap by a few tolerances.
pub(super) const OFF_SKIN: f64 = 2.0;

/// How many times the triangles of a `tree`, a closed surface, wind around `p`; on the surface itself,
/// around a point next to it.
pub(super) fn winding_number(
    tree: &Tree,
    p: &Vector<3>,
    corners: impl Fn(u32) -> [Vector<3>; 3],
) -> f64 {
    let mut number = 0;
    let nudge = NUDGE * tree.diagonal();
    for (times, direction) in DIRECTIONS.into_iter().enumerate() {
        let near = p + times as f64 * nudge * Vector::<3>::from(direction);
        if crossings(tree, &near, &corners, |_| true, |_, side| number += side) {
            break;
        }
    }
    f64::from(number)
}

/// Calls `visit(facet, side)` with every wanted triangle that a ray from `p` passes through, `side`
/// +1 where it leaves the solid and -1 where it enters it. False, with no calls, where each ray tried
/// meets an edge, which happens where `p` is on one.
pub(super) fn crossings(
    tree: &Tree,
    p: &Vector<3>,
    corners: impl Fn(u32) -> [Vector<3>; 3],
    wanted: impl Fn(u32) -> bool,
    mut visit: impl FnMut(u32, i32),
) -> bool {
    let mut found = Vec::new();
    for direction in DIRECTIONS {
        let ray = Ray::new(p, direction);
        found.clear();
        let clear = tree.all_along(p, &ray.inverse, |facet| {
            if !wanted(facet) {
                return true;
            }
            match ray.meets(&corners(facet)) {
                Meeting::Edge => return false,
                Meeting::Crossing(side, _) => found.push((facet, side)),
                Meeting::None => {}
            }
            true
        });
        if clear {
            for (facet, side) in found {
                visit(facet, side);
            }
            return true;
        }
    }
    false
}

/// How far it is from `p` along `direction`, a unit vector, to where that leaves what the triangles wind around; zero outside of
/// that. Nothing where the way meets an edge.
pub(super) fn way_out(
    tree: &Tree,
    p: &Vector<3>,
    direction: &Vector<3>,
    corners: impl Fn(u32) -> [Vector<3>; 3],
) -> Option<f64> {
    let ray = Ray::new(p, (*direction).into());
    let mut found = Vec::new();
    let clear = tree.all_along(p, &ray.inverse, |facet| {
        match ray.meets(&corners(facet)) {
            Meeting::Edge => return false,
            Meeting::Crossing(side, way) => found.push((way, side)),
            Meeting::None => {}
        }
        true
    });
    if !clear {
        return None;
    }
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut number: i32 = found.iter().map(|crossing| crossing.1).sum();
    if number <= 0 {
        return Some(0.0);
    }
    let out = found.iter().find(|crossing| {
        number -= crossing.1;
        number <= 0
    });
    out.map(|crossing| crossing.0)
}

/// How a ray meets a triangle.
enum Meeting {
    None,
    /// Through its inside: outwards, +1, or inwards, -1; and how far away, in lengths of the direction.
    Crossing(i32, f64),
    Edge,
}

/// A ray, whose triangles are seen along it: two triangles with a common edge see that edge alike to
/// the last bit, so that no ray slips between them or counts both.
/// [Woop, Benthin & Wald 2013, "Watertight ray/triangle intersection", J. Comput. Graph. Tech. 2, 65]
struct Ray {
    origin: Vector<3>,
    /// Axes across and along, the last the one along which the ray runs fastest.
    axes: [usize; 3],
    /// Shear that turns the ray into that axis, and its scale.
    shear: [f64; 3],
    inverse: Vector<3>,
}

impl Ray {
    fn new(origin: &Vector<3>, direction: [f64; 3]) -> Self {
        let mut last = 0;
        for axis in 1..3 {
            if direction[axis].abs() > direction[last].abs() {
                last = axis;
            }
        }
        let mut axes = [(last + 1) % 3, (last + 2) % 3, last];
        if direction[last] < 0.0 {
            // Keeps the sense of rotation.
            axes.swap(0, 1);
        }
        let along = direction[last];
        Self {
            origin: *origin,
            axes,
            shear: [
                direction[axes[0]] / along,
                direction[axes[1]] / along,
                1.0 / along,
            ],
            // Across an axis it never arrives; infinitely many of its lengths times no way would be no number.
            inverse: Vector::<3>::from(direction).map(|d| d.recip().clamp(f64::MIN, f64::MAX)),
        }
    }

    fn meets(&self, corners: &[Vector<3>; 3]) -> Meeting {
        let [x, y, z] = self.axes;
        let [a, b, c] = corners.map(|corner| {
            let v = corner - self.origin;
            [
                v[x] - self.shear[0] * v[z],
                v[y] - self.shear[1] * v[z],
                self.shear[2] * v[z],
            ]
        });
        let beside = |from: [f64; 3], to: [f64; 3]| to[0] * from[1] - to[1] * from[0];
        let (u, v, w) = (beside(b, c), beside(c, a), beside(a, b));
        let below = u < 0.0 || v < 0.0 || w < 0.0;
        let above = u > 0.0 || v > 0.0 || w > 0.0;
        if below && above {
            return Meeting::None;
        }
        let ahead = u * a[2] + v * b[2] + w * c[2];
        let whole = u + v + w;
        if u == 0.0 || v == 0.0 || w == 0.0 {
            // Behind the origin an edge does no harm, unless its place along the ray is lost too.
            let behind = [a, b, c].iter().all(|corner| corner[2] < 0.0);
            return if behind { Meeting::None } else { Meeting::Edge };
        }
        if ahead * whole.signum() <= 0.0 {
            return Meeting::None;
        }
        Meeting::Crossing(if whole < 0.0 { 1 } else { -1 }, ahead / whole)
    }
}
