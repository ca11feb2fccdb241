//! From loose triangles to shared vertices: welding, and dropping of what has no area or comes
//! twice.

use std::collections::HashMap;

use foldhash::fast::FixedState;

use crate::stl::Facet;
use crate::{Bounds, Vector};

/// Vertices closer than this, relative to the diagonal of the bounding box, are one: exporters
/// round to single precision, which is a tenth of it.
const WELD: f64 = 1e-6;

/// The same relative to the largest coordinate: far from the origin single precision is coarser.
const WELD_FAR: f64 = 2.5e-7;

/// Triangles by vertex numbers.
#[derive(Clone, Debug, Default)]
pub(super) struct Indexed {
    pub vertices: Vec<Vector<3>>,
    pub facets: Vec<[u32; 3]>,
    /// Distance below which points are one.
    pub tolerance: f64,
}

impl Indexed {
    pub fn corners(&self, facet: [u32; 3]) -> Facet {
        facet.map(|v| self.vertices[v as usize])
    }

    pub fn area(&self, facet: [u32; 3]) -> f64 {
        let [a, b, c] = self.corners(facet);
        0.5 * (b - a).cross(&(c - a)).norm()
    }
}

pub(crate) fn bounds(points: impl Iterator<Item = Vector<3>>) -> Bounds<3> {
    let empty = Bounds::new(
        Vector::<3>::repeat(f64::INFINITY),
        Vector::<3>::repeat(f64::NEG_INFINITY),
    );
    points.fold(empty, |all, p| {
        Bounds::new(all.min.inf(&p), all.max.sup(&p))
    })
}

/// Gives equal corners one vertex, and notes what was not equal to the last bit.
pub(super) fn weld(soup: &[Facet], repairs: &mut Vec<String>) -> Indexed {
    let extent = bounds(soup.iter().flatten().copied());
    let far = extent.min.abs().sup(&extent.max.abs()).max();
    let tolerance = (WELD * extent.size().norm()).max(WELD_FAR * far);
    let (exact, facets) = merge_equal(soup);
    let (kept, number) = merge_near(&exact, tolerance);
    if kept.len() < exact.len() {
        repairs.push(format!(
            "welded {} vertices closer than {tolerance:.2e} to others",
            exact.len() - kept.len()
        ));
    }
    let before = facets.len();
    let facets: Vec<[u32; 3]> = facets
        .into_iter()
        .map(|facet| facet.map(|v| number[v as usize]))
        .filter(|[a, b, c]| a != b && b != c && c != a)
        .collect();
    if facets.len() < before {
        repairs.push(format!(
            "dropped {} triangles shrunk to a point or an edge",
            before - facets.len()
        ));
    }
    Indexed {
        vertices: kept,
        facets,
        tolerance,
    }
}

fn merge_equal(soup: &[Facet]) -> (Vec<Vector<3>>, Vec<[u32; 3]>) {
    let hasher = FixedState::default();
    let mut numbers: HashMap<[u64; 3], u32, _> =
        HashMap::with_capacity_and_hasher(soup.len() / 2, hasher);
    let mut vertices = Vec::with_capacity(soup.len() / 2);
    let facets = soup
        .iter()
        .map(|corners| {
            corners.map(|corner| {
                // Adding zero makes -0 and 0 one.
                let point = corner.add_scalar(0.0);
                let key = [point.x, point.y, point.z].map(f64::to_bits);
                *numbers.entry(key).or_insert_with(|| {
                    vertices.push(point);
                    vertices.len() as u32 - 1
                })
            })
        })
        .collect();
    (vertices, facets)
}

/// Merges each vertex into the first kept one within `tolerance`; gives the kept vertices and the
/// number of each vertex among them.
fn merge_near(vertices: &[Vector<3>], tolerance: f64) -> (Vec<Vector<3>>, Vec<u32>) {
    // Cells much larger than the tolerance, so that most vertices look into one only.
    let inverse_width = 1.0 / (32.0 * tolerance).max(f64::MIN_POSITIVE);
    let cell = |p: Vector<3>| p.map(|x| (x * inverse_width).floor() as i64);
    let hasher = FixedState::default();
    // The last vertex kept in each cell, and of each kept one the one before it in its cell.
    let mut grid: HashMap<[i64; 3], u32, _> =
        HashMap::with_capacity_and_hasher(vertices.len(), hasher);
    let mut before: Vec<Option<u32>> = Vec::with_capacity(vertices.len());
    let mut kept: Vec<Vector<3>> = Vec::with_capacity(vertices.len());
    let mut number = Vec::with_capacity(vertices.len());
    for p in vertices {
        let (low, high) = (
            cell(p.add_scalar(-tolerance)),
            cell(p.add_scalar(tolerance)),
        );
        let mut found: Option<u32> = None;
        for x in low.x..=high.x {
            for y in low.y..=high.y {
                for z in low.z..=high.z {
                    let last = grid.get(&[x, y, z]).copied();
                    let near = std::iter::successors(last, |&v| before[v as usize]);
                    let first = near
                        .filter(|&v| (kept[v as usize] - p).norm() <= tolerance)
                        .min();
                    found = match (found, first) {
                        (Some(a), Some(b)) => Some(a.min(b)),
                        (a, b) => a.or(b),
                    };
                }
            }
        }
        number.push(found.unwrap_or_else(|| {
            let new = kept.len() as u32;
            let home = cell(*p);
            before.push(grid.insert([home.x, home.y, home.z], new));
            kept.push(*p);
            new
        }));
    }
    (kept, number)
}

/// What to do with triangles that lie back to back.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum BackToBack {
    /// They are a wall inside of touching solids: drop both.
    Cancel,
    /// They are one triangle, given from both sides: keep one.
    KeepOne,
}

/// Drops triangles that come more than once; says how many it dropped.
pub(super) fn drop_duplicates(facets: &mut Vec<[u32; 3]>, rule: BackToBack) -> usize {
    let before = facets.len();
    let mut sorted: Vec<([u32; 3], u32)> = facets
        .iter()
        .enumerate()
        .map(|(index, facet)| {
            let mut key = *facet;
            key.sort_unstable();
            (key, index as u32)
        })
        .collect();
    sorted.sort_unstable();
    let mut keep = vec![true; facets.len()];
    for group in sorted.chunk_by(|a, b| a.0 == b.0).filter(|g| g.len() > 1) {
        let copies = group.iter().map(|&(_, index)| index as usize);
        let even = copies.clone().filter(|&f| is_even(&facets[f])).count();
        let balanced = 2 * even == group.len();
        // The side that most copies show wins.
        let side = 2 * even >= group.len();
        let survivor = copies.clone().find(|&f| is_even(&facets[f]) == side);
        for copy in copies {
            let cancelled = balanced && rule == BackToBack::Cancel;
            keep[copy] = !cancelled && Some(copy) == survivor;
        }
    }
    let mut kept = keep.iter();
    facets.retain(|_| *kept.next().unwrap_or(&true));
    before - facets.len()
}

/// True where the vertex numbers are a rotation of their ascending order.
fn is_even(facet: &[u32; 3]) -> bool {
    let descents = (0..3).filter(|&k| facet[k] > facet[(k + 1) % 3]);
    descents.count() == 1
}
