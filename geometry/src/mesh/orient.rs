//! One orientation for the whole surface: outwards, and inwards around cavities.

use super::edges::{NONE, by_edge, half_edges, neighbours, parts};
use super::holes;
use super::weld::{Indexed, bounds};
use super::winding::solid_angle;
use crate::error::GeometryError;
use crate::{Bounds, Vector};

/// Turns triangles so that neighbours agree and the solid is inside, and fills small holes.
pub(super) fn orient(mesh: &mut Indexed, repairs: &mut Vec<String>) -> Result<(), GeometryError> {
    let half_edges = half_edges(&mesh.facets);
    let across = neighbours(&mesh.facets, &half_edges);
    let flipped = agree(mesh, &across)?;
    if flipped > 0 {
        repairs.push(format!("turned {flipped} triangles to agree with the rest"));
    }
    let whole = mesh.facets.len();
    holes::fill(mesh, repairs);
    let across = if mesh.facets.len() > whole {
        neighbours(&mesh.facets, &self::half_edges(&mesh.facets))
    } else {
        across
    };
    let (part, count) = parts(&across);
    turn_outwards(mesh, &part, count, repairs);
    Ok(())
}

/// Flips triangles that disagree with their neighbours, within each part the smaller number.
fn agree(mesh: &mut Indexed, across: &[[u32; 3]]) -> Result<usize, GeometryError> {
    let mut flip: Vec<Option<bool>> = vec![None; mesh.facets.len()];
    let mut total = 0;
    for seed in 0..mesh.facets.len() {
        if flip[seed].is_some() {
            continue;
        }
        flip[seed] = Some(false);
        let mut part = vec![seed];
        let mut next = 0;
        while let Some(&facet) = part.get(next) {
            next += 1;
            let mine = flip[facet] == Some(true);
            for edge in 0..3 {
                let other = across[facet][edge];
                if other == NONE {
                    continue;
                }
                let a = mesh.facets[facet][edge];
                let b = mesh.facets[facet][(edge + 1) % 3];
                let turned = mine ^ runs(&mesh.facets[other as usize], a, b);
                match flip[other as usize] {
                    None => {
                        flip[other as usize] = Some(turned);
                        part.push(other as usize);
                    }
                    Some(before) if before != turned => {
                        let p = 0.5 * (mesh.vertices[a as usize] + mesh.vertices[b as usize]);
                        return Err(GeometryError::Surface(format!(
                            "has no inside and outside: its triangles cannot be made to agree \
                             near ({:.6}, {:.6}, {:.6})",
                            p.x, p.y, p.z
                        )));
                    }
                    Some(_) => {}
                }
            }
        }
        let turned = part.iter().filter(|&&f| flip[f] == Some(true)).count();
        let most = 2 * turned > part.len();
        total += turned.min(part.len() - turned);
        for facet in part {
            if (flip[facet] == Some(true)) ^ most {
                mesh.facets[facet].swap(1, 2);
            }
        }
    }
    Ok(total)
}

/// True where the triangle has the edge from `a` to `b`, in this direction.
fn runs(facet: &[u32; 3], a: u32, b: u32) -> bool {
    (0..3).any(|k| facet[k] == a && facet[(k + 1) % 3] == b)
}

/// What is known of one connected part of the surface.
struct Part {
    facets: Vec<u32>,
    bounds: Bounds<3>,
    volume: f64,
}

impl Part {
    fn new(mesh: &Indexed, facets: Vec<u32>) -> Self {
        let corners = |&f: &u32| corners(mesh, f);
        let bounds = bounds(facets.iter().flat_map(corners));
        // About a point nearby, lest cancellation eat the digits.
        let middle = 0.5 * (bounds.min + bounds.max);
        let volume = facets
            .iter()
            .map(|&f| {
                let [a, b, c] = corners(&f).map(|v| v - middle);
                a.dot(&b.cross(&c)) / 6.0
            })
            .sum();
        Self {
            facets,
            bounds,
            volume,
        }
    }

    /// True where the part's surface winds around `p`, either way.
    fn encloses(&self, mesh: &Indexed, p: &Vector<3>) -> bool {
        if !self.bounds.contains(p) {
            return false;
        }
        let total: f64 = self
            .facets
            .iter()
            .map(|&f| solid_angle(&corners(mesh, f).map(|v| v - p)))
            .sum();
        total.abs() > 2.0 * std::f64::consts::PI
    }
}

fn corners(mesh: &Indexed, facet: u32) -> [Vector<3>; 3] {
    mesh.facets[facet as usize].map(|v| mesh.vertices[v as usize])
}

/// Turns whole parts that are inside out. A part inside of an odd number of others that faces
/// inwards is the wall of a cavity and stays.
fn turn_outwards(mesh: &mut Indexed, part: &[u32], count: usize, repairs: &mut Vec<String>) {
    let mut lists = vec![Vec::new(); count];
    for (facet, &number) in part.iter().enumerate() {
        lists[number as usize].push(facet as u32);
    }
    let parts: Vec<Part> = lists
        .into_iter()
        .map(|facets| Part::new(mesh, facets))
        .collect();
    let (mut turned, mut cavities) = (0, 0);
    for (index, part) in parts.iter().enumerate().filter(|(_, p)| p.volume < 0.0) {
        let [a, b, c] = corners(mesh, part.facets[0]);
        let probe = (a + b + c) / 3.0;
        let depth = parts
            .iter()
            .enumerate()
            .filter(|&(other, p)| other != index && p.encloses(mesh, &probe))
            .count();
        if depth % 2 == 1 {
            cavities += 1;
            continue;
        }
        turned += 1;
        for &facet in &part.facets {
            mesh.facets[facet as usize].swap(1, 2);
        }
    }
    if turned > 0 {
        repairs.push(format!(
            "turned {turned} closed parts of the surface that were inside out"
        ));
    }
    if cavities > 0 {
        repairs.push(format!("kept {cavities} cavities inside of the solid"));
    }
}

/// Edges at which the surface does not close: how many, and the middle of the first one, which is
/// that of the triangle that comes first in the file.
pub(super) fn open_edges(mesh: &Indexed) -> Option<(usize, Vector<3>)> {
    let half_edges = half_edges(&mesh.facets);
    let mut count = 0;
    let mut first: Option<(u32, [u32; 2])> = None;
    for group in by_edge(&half_edges) {
        let ascending = group.iter().filter(|half| half.ascending).count();
        if 2 * ascending != group.len() {
            count += 1;
            let here = (group[0].facet, group[0].vertices());
            first = Some(first.map_or(here, |before| before.min(here)));
        }
    }
    first.map(|(_, [a, b])| {
        let middle = 0.5 * (mesh.vertices[a as usize] + mesh.vertices[b as usize]);
        (count, middle)
    })
}
