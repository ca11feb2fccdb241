//! Rims: the closed lines in which a surface ends, each around one hole.

use std::collections::{BTreeMap, HashMap};

use super::edges::{HalfEdge, by_edge};
use super::weld::{Indexed, bounds};
use crate::Vector;
use crate::halves::ROUNDED;

/// So many holes are told of one by one.
const TOLD: usize = 3;

/// The borders of all holes, each in the direction in which what fills it runs. One that meets
/// itself in a vertex is taken apart there.
pub(super) fn rims(half_edges: &[HalfEdge]) -> Vec<Vec<u32>> {
    let mut next: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    for group in by_edge(half_edges) {
        let [low, high] = group[0].vertices();
        let ascending = group.iter().filter(|half| half.ascending).count();
        let descending = group.len() - ascending;
        // What fills the hole runs against the triangle beside it.
        let (from, to) = if ascending > descending {
            (high, low)
        } else {
            (low, high)
        };
        for _ in 0..ascending.abs_diff(descending) {
            next.entry(from).or_default().push(to);
        }
    }
    let mut rims = Vec::new();
    while let Some(&start) = next.keys().next() {
        let mut path = vec![start];
        let mut places = HashMap::from([(start, 0)]);
        while let Some(&last) = path.last() {
            let Some(ends) = next.get_mut(&last) else {
                // Runs in and not out: nothing to fill here.
                break;
            };
            let to = ends.swap_remove(0);
            if ends.is_empty() {
                next.remove(&last);
            }
            if let Some(&place) = places.get(&to) {
                let ring: Vec<u32> = path.drain(place..).collect();
                for vertex in &ring {
                    places.remove(vertex);
                }
                if ring.len() > 2 {
                    rims.push(ring);
                }
            }
            places.insert(to, path.len());
            path.push(to);
            if !next.contains_key(&to) {
                break;
            }
        }
    }
    rims
}

/// A hole as users are told of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Hole {
    /// The mean of its rim.
    pub place: Vector<3>,
    /// Diagonal of the box around its rim.
    pub width: f64,
    /// The axis across which its rim is flat, if there is one. Of a million holes little is kept of each.
    flat: Option<u8>,
}

impl Hole {
    pub fn of(mesh: &Indexed, rim: &[u32]) -> Self {
        let points = || rim.iter().map(|&v| mesh.vertices[v as usize]);
        let size = bounds(points()).size();
        let width = size.norm();
        Self {
            place: points().sum::<Vector<3>>() / rim.len() as f64,
            width,
            flat: (0..3_u8).find(|&axis| size[usize::from(axis)] <= ROUNDED * width),
        }
    }

    /// True where its rim lies in the plane across an axis through this place, to within a tolerance.
    pub fn lies_in(&self, axis: usize, place: f64, tolerance: f64) -> bool {
        let is_flat = self.flat.is_some_and(|flat| usize::from(flat) == axis);
        is_flat && (self.place[axis] - place).abs() <= tolerance
    }
}

/// How many holes there are, and how wide and where the widest are.
pub(super) fn tell(holes: &[Hole]) -> String {
    let mut widest: Vec<&Hole> = holes.iter().collect();
    widest.sort_by(|a, b| b.width.total_cmp(&a.width));
    let told: Vec<String> = widest
        .iter()
        .take(TOLD)
        .map(|hole| {
            let (p, width) = (hole.place, hole.width);
            format!("{width:.3e} wide near ({:.6}, {:.6}, {:.6})", p.x, p.y, p.z)
        })
        .collect();
    let plural = if holes.len() == 1 { "hole" } else { "holes" };
    let others = if holes.len() > TOLD {
        ", others smaller"
    } else {
        ""
    };
    format!("{} {plural}: {}{others}", holes.len(), told.join(", "))
}
