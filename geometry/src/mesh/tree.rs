//! A tree of boxes over triangles, for the closest one.
//!
//! Leaves hold consecutive triangles: the mesh keeps its triangles in the tree's order.

use super::triangle::distance_squared;
use crate::Vector;

/// Triangles per leaf at most.
const LEAF: usize = 4;
/// Bins of the split search; more gain nothing.
const BINS: usize = 16;
/// Below this depth triangles are halved by number, so that the depth stays bounded.
const DEEP: usize = 40;
/// Deepest possible tree: [`DEEP`] plus halvings of 2^32 triangles.
const DEEPEST: usize = DEEP + 33;

#[derive(Clone, Debug)]
pub(super) struct Node {
    pub min: Vector<3>,
    pub max: Vector<3>,
    /// First triangle of a leaf, or the first of two children.
    pub first: u32,
    /// Triangles of a leaf; zero in inner nodes.
    pub count: u32,
}

impl Node {
    #[inline]
    fn distance_squared(&self, p: &Vector<3>) -> f64 {
        // One instruction: that of `f64` looks for what is no number.
        let larger = |a: f64, b: f64| if a > b { a } else { b };
        let mut sum = 0.0;
        for axis in 0..3 {
            let outside = larger(self.min[axis] - p[axis], p[axis] - self.max[axis]);
            let outside = larger(outside, 0.0);
            sum += outside * outside;
        }
        sum
    }
}

#[derive(Clone, Debug)]
pub(super) struct Tree {
    pub nodes: Vec<Node>,
}

/// A triangle's box and number while the tree grows.
#[derive(Clone, Copy)]
struct Item {
    min: Vector<3>,
    max: Vector<3>,
    number: u32,
}

impl Item {
    fn middle(&self, axis: usize) -> f64 {
        self.min[axis] + self.max[axis]
    }
}

impl Tree {
    /// The tree, and the order in which its leaves hold the triangles.
    pub fn new(vertices: &[Vector<3>], facets: &[[u32; 3]]) -> (Self, Vec<u32>) {
        Self::over(facets, |facet| facet.map(|v| vertices[v as usize]))
    }

    /// The same over anything with three corners.
    pub fn over<T>(facets: &[T], corners: impl Fn(&T) -> [Vector<3>; 3]) -> (Self, Vec<u32>) {
        let mut items: Vec<Item> = facets
            .iter()
            .enumerate()
            .map(|(number, facet)| {
                let [a, b, c] = corners(facet);
                Item {
                    min: a.inf(&b).inf(&c),
                    max: a.sup(&b).sup(&c),
                    number: number as u32,
                }
            })
            .collect();
        let mut nodes = vec![around(&items)];
        // Each entry: a node without children yet, its items, its depth.
        let mut open = vec![(0, 0..items.len(), 0)];
        while let Some((node, range, depth)) = open.pop() {
            if range.len() <= LEAF {
                nodes[node].first = range.start as u32;
                nodes[node].count = range.len() as u32;
                continue;
            }
            let cut = range.start + split(&mut items[range.clone()], depth);
            let child = nodes.len();
            nodes[node].first = child as u32;
            nodes.push(around(&items[range.start..cut]));
            nodes.push(around(&items[cut..range.end]));
            open.push((child + 1, cut..range.end, depth + 1));
            open.push((child, range.start..cut, depth + 1));
        }
        let order = items.iter().map(|item| item.number).collect();
        (Self { nodes }, order)
    }

    /// The closest triangle to `p` among those not `hidden`, and its distance squared.
    pub fn closest(
        &self,
        p: &Vector<3>,
        corners: impl Fn(u32) -> [Vector<3>; 3],
        hidden: impl Fn(u32) -> bool,
    ) -> Option<(u32, f64)> {
        let mut best = (u32::MAX, f64::INFINITY);
        let mut stack = [(0_u32, 0.0_f64); DEEPEST];
        stack[0] = (0, self.nodes[0].distance_squared(p));
        let mut size = 1;
        while size > 0 {
            size -= 1;
            let (index, near) = stack[size];
            if near >= best.1 {
                continue;
            }
            let node = &self.nodes[index as usize];
            if node.count > 0 {
                for facet in node.first..node.first + node.count {
                    if hidden(facet) {
                        continue;
                    }
                    let distance = distance_squared(&corners(facet), p);
                    if distance < best.1 {
                        best = (facet, distance);
                    }
                }
                continue;
            }
            let (left, right) = (node.first, node.first + 1);
            let to_left = self.nodes[left as usize].distance_squared(p);
            let to_right = self.nodes[right as usize].distance_squared(p);
            // The nearer child goes on top.
            let pair = if to_left <= to_right {
                [(right, to_right), (left, to_left)]
            } else {
                [(left, to_left), (right, to_right)]
            };
            stack[size..size + 2].copy_from_slice(&pair);
            size += 2;
        }
        (best.0 != u32::MAX).then_some(best)
    }
}

impl Tree {
    /// Calls `visit` with all triangles of leaves whose boxes a ray meets, until it says false; false then.
    /// The ray is given by its start and by one over each component of its direction.
    pub fn all_along(
        &self,
        start: &Vector<3>,
        inverse: &Vector<3>,
        mut visit: impl FnMut(u32) -> bool,
    ) -> bool {
        let mut stack = [0_u32; DEEPEST];
        let mut size = 1;
        while size > 0 {
            size -= 1;
            let node = &self.nodes[stack[size] as usize];
            let (mut enters, mut leaves) = (0.0_f64, f64::INFINITY);
            for axis in 0..3 {
                let a = (node.min[axis] - start[axis]) * inverse[axis];
                let b = (node.max[axis] - start[axis]) * inverse[axis];
                enters = enters.max(a.min(b));
                leaves = leaves.min(a.max(b));
            }
            // Rounding must not let a ray pass by.
            if enters > leaves * (1.0 + 4.0 * f64::EPSILON) {
                continue;
            }
            if node.count > 0 {
                if !(node.first..node.first + node.count).all(&mut visit) {
                    return false;
                }
            } else {
                stack[size] = node.first + 1;
                stack[size + 1] = node.first;
                size += 2;
            }
        }
        true
    }

    /// Calls `visit` with all triangles of leaves whose boxes meet the given one.
    pub fn for_each_in(&self, low: &Vector<3>, high: &Vector<3>, mut visit: impl FnMut(u32)) {
        let mut stack = vec![0_u32];
        while let Some(index) = stack.pop() {
            let node = &self.nodes[index as usize];
            let apart = (0..3).any(|k| node.min[k] > high[k] || node.max[k] < low[k]);
            if apart {
                continue;
            }
            if node.count > 0 {
                (node.first..node.first + node.count).for_each(&mut visit);
            } else {
                stack.extend([node.first + 1, node.first]);
            }
        }
    }
}

fn around(items: &[Item]) -> Node {
    let empty = (
        Vector::<3>::repeat(f64::INFINITY),
        Vector::<3>::repeat(f64::NEG_INFINITY),
    );
    let (min, max) = items.iter().fold(empty, |(min, max), item| {
        (min.inf(&item.min), max.sup(&item.max))
    });
    Node {
        min,
        max,
        first: 0,
        count: 0,
    }
}

/// Sorts items into two non-empty sides, and says where the second begins.
fn split(items: &mut [Item], depth: usize) -> usize {
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for item in items.iter() {
        for axis in 0..3 {
            low[axis] = low[axis].min(item.middle(axis));
            high[axis] = high[axis].max(item.middle(axis));
        }
    }
    let mut axis = 0;
    for other in 1..3 {
        if high[other] - low[other] > high[axis] - low[axis] {
            axis = other;
        }
    }
    let width = high[axis] - low[axis];
    if depth < DEEP && width > 0.0 {
        let scale = BINS as f64 / width;
        let bin = |item: &Item| (((item.middle(axis) - low[axis]) * scale) as usize).min(BINS - 1);
        let border = cheapest_border(items, bin);
        let mut cut = 0;
        for index in 0..items.len() {
            if bin(&items[index]) < border {
                items.swap(cut, index);
                cut += 1;
            }
        }
        if cut > 0 && cut < items.len() {
            return cut;
        }
    }
    let half = items.len() / 2;
    items.select_nth_unstable_by(half, |a, b| {
        let order = a.middle(axis).total_cmp(&b.middle(axis));
        order.then(a.number.cmp(&b.number))
    });
    half
}

/// The border between bins with the least expected work: area times number, both sides.
/// [Wald 2007, "On fast construction of SAH-based bounding volume hierarchies"]
fn cheapest_border(items: &[Item], bin: impl Fn(&Item) -> usize) -> usize {
    let empty = (
        0.0,
        Vector::<3>::repeat(f64::INFINITY),
        Vector::<3>::repeat(f64::NEG_INFINITY),
    );
    let mut bins = [empty; BINS];
    for item in items {
        let (count, min, max) = &mut bins[bin(item)];
        *count += 1.0;
        *min = min.inf(&item.min);
        *max = max.sup(&item.max);
    }
    let join = |a: &(f64, Vector<3>, Vector<3>), b: &(f64, Vector<3>, Vector<3>)| {
        (a.0 + b.0, a.1.inf(&b.1), a.2.sup(&b.2))
    };
    let cost = |(count, min, max): &(f64, Vector<3>, Vector<3>)| {
        if *count == 0.0 {
            return 0.0;
        }
        let size = max - min;
        count * (size.x * size.y + size.y * size.z + size.z * size.x)
    };
    let mut right = [empty; BINS];
    right[BINS - 1] = bins[BINS - 1];
    for k in (0..BINS - 1).rev() {
        right[k] = join(&bins[k], &right[k + 1]);
    }
    let mut left = empty;
    let mut best = (1, f64::INFINITY);
    for border in 1..BINS {
        left = join(&left, &bins[border - 1]);
        if left.0 == 0.0 || right[border].0 == 0.0 {
            continue;
        }
        let total = cost(&left) + cost(&right[border]);
        if total < best.1 {
            best = (border, total);
        }
    }
    best.0
}
