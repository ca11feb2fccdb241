//! One orientation for the whole surface: outwards, and inwards around cavities.

use super::edges::{HalfEdge, NONE, by_edge, half_edges, in_pairs};
use super::neighbours::neighbours;
use super::openings::Caps;
use super::weld::Indexed;
use super::{facing, holes, patches};
use crate::Vector;
use crate::error::{GeometryError, WRAP};

/// Turns triangles so that neighbours agree and the solid is inside, and fills small holes, or all if
/// `fill` is set; refuses what is open then, or could stand for more than one solid.
pub(super) fn orient(
    mesh: &mut Indexed,
    fill: bool,
    repairs: &mut Vec<String>,
) -> Result<(), GeometryError> {
    let mut half_edges = half_edges(&mesh.facets);
    let mut turned = agree(mesh, &in_pairs(&mesh.facets, &half_edges))?;
    if turned.contains(&true) {
        half_edges = self::half_edges(&mesh.facets);
    }
    if patches::turn(mesh, &half_edges, &mut turned) {
        half_edges = self::half_edges(&mesh.facets);
    }
    let count = turned.iter().filter(|&&turned| turned).count();
    if count > 0 {
        repairs.push(format!("turned {count} triangles to agree with the rest"));
    }
    if holes::fill(mesh, &half_edges, repairs) {
        half_edges = self::half_edges(&mesh.facets);
    }
    let caps = Caps::new(mesh, &half_edges, fill)?;
    if !caps.is_empty() {
        half_edges = self::half_edges(&mesh.facets);
    }
    refuse_open(mesh, &half_edges)?;
    let across = neighbours(mesh, &half_edges);
    drop(half_edges);
    facing::settle(mesh, &across, &turned, (&caps, fill), repairs)
}

/// Flips triangles that disagree with their neighbours, of each connected patch the smaller area; says
/// which.
pub(super) fn agree(mesh: &mut Indexed, across: &[[u32; 3]]) -> Result<Vec<bool>, GeometryError> {
    let mut flip: Vec<Option<bool>> = vec![None; mesh.facets.len()];
    let mut all_turned = vec![false; mesh.facets.len()];
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
                             near ({:.6}, {:.6}, {:.6}); {WRAP}",
                            p.x, p.y, p.z
                        )));
                    }
                    Some(_) => {}
                }
            }
        }
        let turned = |f: &usize| flip[*f] == Some(true);
        if !part.iter().any(turned) {
            continue;
        }
        let area = |f: &usize| mesh.area(mesh.facets[*f]);
        let most = part.iter().filter(|f| turned(f)).map(area).sum::<f64>()
            > part.iter().filter(|f| !turned(f)).map(area).sum();
        for facet in part {
            if turned(&facet) ^ most {
                mesh.facets[facet].swap(1, 2);
                all_turned[facet] = true;
            }
        }
    }
    Ok(all_turned)
}

/// True where the triangle has the edge from `a` to `b`, in this direction.
fn runs(facet: &[u32; 3], a: u32, b: u32) -> bool {
    (0..3).any(|k| facet[k] == a && facet[(k + 1) % 3] == b)
}

fn refuse_open(mesh: &Indexed, half_edges: &[HalfEdge]) -> Result<(), GeometryError> {
    let Some((count, p)) = open_edges(mesh, half_edges) else {
        return Ok(());
    };
    Err(GeometryError::Surface(format!(
        "is open at {count} edges that go around no hole, the first near ({:.6}, {:.6}, {:.6}); {WRAP}",
        p.x, p.y, p.z
    )))
}

/// Edges at which the surface does not close: how many, and the middle of the first one, which is
/// that of the triangle that comes first in the file.
fn open_edges(mesh: &Indexed, half_edges: &[HalfEdge]) -> Option<(usize, Vector<3>)> {
    let mut count = 0;
    let mut first: Option<(u32, [u32; 2])> = None;
    for group in by_edge(half_edges) {
        if group.iter().map(HalfEdge::sign).sum::<i32>() != 0 {
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
