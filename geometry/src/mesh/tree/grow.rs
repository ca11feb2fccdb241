//! How the tree of boxes over triangles grows: parted again and again.

use std::ops::Range;

use wide::f64x4;

use super::{Child, DEEP, LEAF, Node, Tree, WIDTH};
use crate::Vector;

/// Bins of the split search; more gain nothing.
const BINS: usize = 16;

/// A triangle's box and number.
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

/// Items side by side that are one child of a node.
#[derive(Clone)]
struct Branch {
    items: Range<usize>,
    /// Partings on the way to it.
    depth: usize,
    min: Vector<3>,
    max: Vector<3>,
}

impl Branch {
    fn new(all: &[Item], items: Range<usize>, depth: usize) -> Self {
        let empty = (
            Vector::<3>::repeat(f64::INFINITY),
            Vector::<3>::repeat(f64::NEG_INFINITY),
        );
        let (min, max) = all[items.clone()].iter().fold(empty, |(min, max), item| {
            (min.inf(&item.min), max.sup(&item.max))
        });
        Self {
            items,
            depth,
            min,
            max,
        }
    }

    fn is_leaf(&self) -> bool {
        self.items.len() <= LEAF
    }

    fn part(&self, all: &mut [Item]) -> [Self; 2] {
        let cut = self.items.start + split(&mut all[self.items.clone()], self.depth);
        [self.items.start..cut, cut..self.items.end]
            .map(|items| Self::new(all, items, self.depth + 1))
    }

    /// As many parts of it as a node has children: the largest is parted until there are so many.
    fn children(self, all: &mut [Item]) -> Vec<Self> {
        let mut parts = vec![self];
        while parts.len() < WIDTH {
            let size = |part: &Self| half_surface(&part.max, &part.min);
            let largest = (0..parts.len())
                .filter(|&k| !parts[k].is_leaf())
                .max_by(|&a, &b| size(&parts[a]).total_cmp(&size(&parts[b])));
            let Some(largest) = largest else {
                break;
            };
            let halves = parts[largest].part(all);
            parts.splice(largest..=largest, halves);
        }
        parts
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
        let root = Branch::new(&items, 0..items.len(), 0);
        let diagonal = (root.max - root.min).norm();
        let mut nodes = vec![Node::EMPTY];
        // Nodes that have no children yet.
        let mut open = vec![(0, root)];
        while let Some((node, branch)) = open.pop() {
            let first = open.len();
            for (lane, child) in branch.children(&mut items).into_iter().enumerate() {
                let Range { start, end } = child.items;
                let held = if child.is_leaf() {
                    Child {
                        first: start as u32,
                        count: (end - start) as u32,
                    }
                } else {
                    nodes.push(Node::EMPTY);
                    Child {
                        first: nodes.len() as u32 - 1,
                        count: 0,
                    }
                };
                nodes[node].set(lane, held, (&child.min, &child.max));
                if !child.is_leaf() {
                    open.push((held.first as usize, child));
                }
            }
            // What is near in space is near in memory.
            open[first..].reverse();
        }
        let order = items.iter().map(|item| item.number).collect();
        (Self { nodes, diagonal }, order)
    }
}

impl Node {
    const EMPTY: Self = Self {
        min: [f64x4::splat(f64::INFINITY); 3],
        max: [f64x4::splat(f64::NEG_INFINITY); 3],
        children: [Child::ROOT; WIDTH],
    };

    fn set(&mut self, lane: usize, child: Child, (min, max): (&Vector<3>, &Vector<3>)) {
        for axis in 0..3 {
            self.min[axis].as_mut_array()[lane] = min[axis];
            self.max[axis].as_mut_array()[lane] = max[axis];
        }
        self.children[lane] = child;
    }
}

/// Half of the surface of a box.
fn half_surface(max: &Vector<3>, min: &Vector<3>) -> f64 {
    let size = max - min;
    size.x * size.y + size.y * size.z + size.z * size.x
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
        count * half_surface(max, min)
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
