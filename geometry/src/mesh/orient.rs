//! One orientation for the whole surface: outwards, and inwards around cavities.

use std::collections::BTreeMap;

use super::edges::{NONE, by_edge, half_edges, neighbours, parts};
use super::holes;
use super::tree::Tree;
use super::weld::{Indexed, bounds};
use super::winding::crossings;
use crate::Vector;
use crate::error::GeometryError;

/// Turns triangles so that neighbours agree and the solid is inside, and fills small holes; refuses
/// what is open then.
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
    refuse_open(mesh)?;
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

/// Six times the volume that a connected part of the surface encloses.
fn volume(mesh: &Indexed, facets: &[u32]) -> f64 {
    let corners = |f: u32| mesh.facets[f as usize].map(|v| mesh.vertices[v as usize]);
    let bounds = bounds(facets.iter().flat_map(|&f| corners(f)));
    // About a point nearby, lest cancellation eat the digits.
    let middle = 0.5 * (bounds.min + bounds.max);
    let doubled = |&f: &u32| {
        let [a, b, c] = corners(f).map(|v| v - middle);
        a.dot(&b.cross(&c))
    };
    facets.iter().map(doubled).sum()
}

/// Turns whole parts that are inside out. A part inside of an odd number of others that faces
/// inwards is the wall of a cavity and stays.
fn turn_outwards(mesh: &mut Indexed, part: &[u32], count: usize, repairs: &mut Vec<String>) {
    let mut lists = vec![Vec::new(); count];
    for (facet, &number) in part.iter().enumerate() {
        lists[number as usize].push(facet as u32);
    }
    lists.retain(|facets: &Vec<u32>| volume(mesh, facets) < 0.0);
    if lists.is_empty() {
        return;
    }
    let (mut turned, mut cavities) = (0, 0);
    let (tree, order) = Tree::new(&mesh.vertices, &mesh.facets);
    let own = |place: u32| part[order[place as usize] as usize];
    let mut outwards: Vec<u32> = Vec::new();
    for facets in &lists {
        let corners = |f: u32| mesh.facets[f as usize].map(|v| mesh.vertices[v as usize]);
        let [a, b, c] = corners(facets[0]);
        let probe = (a + b + c) / 3.0;
        // Which others wind around it, either way.
        let mut around: BTreeMap<u32, i32> = BTreeMap::new();
        crossings(
            &tree,
            &probe,
            |place| corners(order[place as usize]),
            |place| own(place) != part[facets[0] as usize],
            |place, side| *around.entry(own(place)).or_default() += side,
        );
        let depth = around.values().filter(|&&times| times != 0).count();
        if depth % 2 == 1 {
            cavities += 1;
        } else {
            turned += 1;
            outwards.extend(facets);
        }
    }
    for &facet in &outwards {
        mesh.facets[facet as usize].swap(1, 2);
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

fn refuse_open(mesh: &Indexed) -> Result<(), GeometryError> {
    let Some((count, p)) = open_edges(mesh) else {
        return Ok(());
    };
    Err(GeometryError::Surface(format!(
        "is open at {count} edges, the first near ({:.6}, {:.6}, {:.6}); close it",
        p.x, p.y, p.z
    )))
}

/// Edges at which the surface does not close: how many, and the middle of the first one, which is
/// that of the triangle that comes first in the file.
fn open_edges(mesh: &Indexed) -> Option<(usize, Vector<3>)> {
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
