//! A tree of boxes over triangles, for the closest one.
//!
//! Each node holds the boxes of its children side by side, so that the processor's vectors tell of all of them at once.
//! Leaves hold consecutive triangles: the mesh keeps its triangles in the tree's order.

mod grow;

use std::ops::Range;

use arrayvec::ArrayVec;
use wide::f64x4;

use super::triangle::{TOGETHER, distances_squared};
use crate::Vector;

/// Children of a node at most, one to a lane.
const WIDTH: usize = 4;
/// Triangles per leaf at most.
const LEAF: usize = TOGETHER;
/// Below this depth triangles are halved by number, so that the depth stays bounded.
const DEEP: usize = 40;
/// Deepest possible tree: [`DEEP`] plus halvings of 2^32 triangles.
const DEEPEST: usize = DEEP + 33;
/// Most that waits while a tree is walked: all but one child of each node on the way down, and the last.
const WAITING: usize = (WIDTH - 1) * DEEPEST + 1;

/// The boxes of its children, one in each lane; those of missing ones are inside out.
#[derive(Clone, Debug)]
struct Node {
    min: [f64x4; 3],
    max: [f64x4; 3],
    children: [Child; WIDTH],
}

/// What a box holds.
#[derive(Clone, Copy, Debug, Default)]
struct Child {
    /// First triangle of a leaf, or the number of a node; zero, the root, where there is no child.
    first: u32,
    /// Triangles of a leaf; zero in inner nodes.
    count: u32,
}

impl Child {
    /// The root's number.
    const ROOT: Self = Self { first: 0, count: 0 };

    fn is_there(self) -> bool {
        self.count > 0 || self.first > 0
    }

    fn triangles(self) -> Range<u32> {
        self.first..self.first + self.count
    }
}

impl Node {
    /// How far the children's boxes are from `p`, squared.
    #[inline(always)]
    fn distances_squared(&self, p: &[f64x4; 3]) -> [f64; WIDTH] {
        let mut sum = f64x4::ZERO;
        for axis in 0..3 {
            let outside = (self.min[axis] - p[axis]).fast_max(p[axis] - self.max[axis]);
            let outside = outside.fast_max(f64x4::ZERO);
            sum += outside * outside;
        }
        sum.to_array()
    }
}

#[derive(Clone, Debug)]
pub(super) struct Tree {
    nodes: Vec<Node>,
    /// Length of the diagonal of the box around all.
    diagonal: f64,
}

impl Tree {
    pub fn diagonal(&self) -> f64 {
        self.diagonal
    }

    /// The closest triangle to `p` among those not `hidden`, and its distance squared.
    pub fn closest<'a>(
        &self,
        p: &Vector<3>,
        corners: impl Fn(u32) -> [&'a Vector<3>; 3],
        hidden: impl Fn(u32) -> bool,
    ) -> Option<(u32, f64)> {
        let mut best = (u32::MAX, f64::INFINITY);
        let point = [p.x, p.y, p.z].map(f64x4::splat);
        let mut waiting: ArrayVec<(f64, Child), WAITING> = ArrayVec::new();
        waiting.push((0.0, Child::ROOT));
        while let Some((near, child)) = waiting.pop() {
            if near >= best.1 {
                continue;
            }
            if child.count > 0 {
                let last = child.first + child.count - 1;
                let all = std::array::from_fn(|k| corners(last.min(child.first + k as u32)));
                let distances = distances_squared(&all, &point);
                for (facet, distance) in child.triangles().zip(distances) {
                    if distance < best.1 && !hidden(facet) {
                        best = (facet, distance);
                    }
                }
                continue;
            }
            let node = &self.nodes[child.first as usize];
            let distances = node.distances_squared(&point);
            let (mut top, mut nearest) = (usize::MAX, f64::INFINITY);
            for (&near, &child) in distances.iter().zip(&node.children) {
                if near < best.1 {
                    if near < nearest {
                        (top, nearest) = (waiting.len(), near);
                    }
                    waiting.push((near, child));
                }
            }
            if top != usize::MAX {
                let last = waiting.len() - 1;
                waiting.swap(top, last);
            }
        }
        (best.0 != u32::MAX).then_some(best)
    }

    /// Calls `visit` with all triangles of leaves whose boxes a ray meets, until it says false; false then.
    /// The ray is given by its start and by one over each component of its direction.
    pub fn all_along(
        &self,
        start: &Vector<3>,
        inverse: &Vector<3>,
        mut visit: impl FnMut(u32) -> bool,
    ) -> bool {
        self.walk(
            |node| {
                let (mut enters, mut leaves) = ([0.0_f64; WIDTH], [f64::INFINITY; WIDTH]);
                for axis in 0..3 {
                    for lane in 0..WIDTH {
                        let a = (node.min[axis].as_array()[lane] - start[axis]) * inverse[axis];
                        let b = (node.max[axis].as_array()[lane] - start[axis]) * inverse[axis];
                        enters[lane] = enters[lane].max(a.min(b));
                        leaves[lane] = leaves[lane].min(a.max(b));
                    }
                }
                // Rounding must not let a ray pass by.
                std::array::from_fn(|k| enters[k] <= leaves[k] * (1.0 + 4.0 * f64::EPSILON))
            },
            |mut triangles| triangles.all(&mut visit),
        )
    }

    /// Calls `visit` with all triangles of leaves whose boxes meet the given one.
    pub fn for_each_in(&self, low: &Vector<3>, high: &Vector<3>, mut visit: impl FnMut(u32)) {
        self.walk(
            |node| {
                std::array::from_fn(|k| {
                    let (min, max) = (&node.min, &node.max);
                    (0..3).all(|axis| {
                        min[axis].as_array()[k] <= high[axis]
                            && max[axis].as_array()[k] >= low[axis]
                    })
                })
            },
            |triangles| {
                triangles.for_each(&mut visit);
                true
            },
        );
    }

    /// Calls `visit` with the triangles of leaves that `wanted` and all nodes above them are, until it says false; false then.
    fn walk(
        &self,
        wanted: impl Fn(&Node) -> [bool; WIDTH],
        mut visit: impl FnMut(Range<u32>) -> bool,
    ) -> bool {
        let mut waiting: ArrayVec<u32, WAITING> = ArrayVec::new();
        waiting.push(Child::ROOT.first);
        while let Some(index) = waiting.pop() {
            let node = &self.nodes[index as usize];
            for (child, wanted) in node.children.iter().zip(wanted(node)) {
                if !wanted || !child.is_there() {
                    continue;
                }
                if child.count == 0 {
                    waiting.push(child.first);
                } else if !visit(child.triangles()) {
                    return false;
                }
            }
        }
        true
    }
}
