//! The signed distance that a wrap follows.

use rayon::prelude::*;

use super::super::caps::span;
use super::super::edges::{NONE, half_edges, in_pairs, parts};
use super::super::rims::rims;
use super::super::tree::Tree;
use super::super::triangle::closest_on;
use super::super::triangle::normal;
use super::super::weld::{BackToBack, Indexed, bounds, drop_duplicates, weld};
use super::super::winding::winding_number;
use crate::error::GeometryError;
use crate::stl::{Facet, Soup};
use crate::{Bounds, Vector};

/// A shell whose holes are less than this part of it is a solid with holes, others are panels.
const MOST_OPEN: f64 = 0.25;

/// Depths, in parts of the spacing, at which it is asked whether a solid is that thick.
const DEPTHS: [f64; 4] = [0.25, 0.5, 0.75, 1.0];

/// Triangles and the tree over them.
struct Set {
    facets: Vec<Facet>,
    tree: Tree,
}

impl Set {
    fn new(facets: &[Facet]) -> Option<Self> {
        if facets.is_empty() {
            return None;
        }
        let (tree, order) = Tree::over(facets, |facet| *facet);
        let facets = order.iter().map(|&n| facets[n as usize]).collect();
        Some(Self { facets, tree })
    }

    fn corners(&self, facet: u32) -> Facet {
        self.facets[facet as usize]
    }

    /// The closest point and the normal of its triangle.
    fn closest(&self, p: &Vector<3>) -> Option<(Vector<3>, Vector<3>)> {
        let (facet, _) = self
            .tree
            .closest(p, |f| self.facets[f as usize].each_ref(), |_| false)?;
        let corners = self.corners(facet);
        Some((closest_on(&corners, p).point, normal(&corners)))
    }

    fn winds_around(&self, p: &Vector<3>) -> bool {
        winding_number(&self.tree, p, |f| self.corners(f)) > 0.5
    }
}

/// Closed parts, and what has to be made thicker.
pub(super) struct Field {
    solid: Option<Set>,
    /// Triangles and the distance by which each set of them grows.
    thin: Vec<(Set, f64)>,
    pub bounds: Bounds<3>,
}

impl Field {
    pub fn new(
        soup: &Soup,
        spacing: f64,
        repairs: &mut Vec<String>,
    ) -> Result<Self, GeometryError> {
        let mut mesh = weld(&soup.facets, &mut Vec::new());
        drop_duplicates(&mut mesh.facets, BackToBack::KeepOne);
        mesh.facets
            .retain(|&facet| normal(&mesh_corners(&mesh.vertices, facet)) != Vector::<3>::zeros());
        if mesh.facets.is_empty() {
            return Err(GeometryError::Surface(
                "has no triangles with an area".into(),
            ));
        }
        let (closed, panels) = sorted(&mesh);
        let solid = Set::new(&closed);
        // Bins by thickness, the panels first.
        let mut bins = vec![panels.clone()];
        bins.resize(DEPTHS.len() + 1, Vec::new());
        if let Some(set) = &solid {
            let found: Vec<(Facet, usize)> = closed
                .par_iter()
                .flat_map_iter(|facet| pieces(*facet, spacing))
                .filter_map(|piece| Some((piece, thickness(set, &piece, spacing, mesh.tolerance)?)))
                .collect();
            for (piece, bin) in found {
                bins[bin].push(piece);
            }
        }
        let thinner: usize = bins[1..].iter().map(Vec::len).sum();
        if !panels.is_empty() || thinner > 0 {
            repairs.push(format!(
                "made {} panels{} as thick as the spacing",
                panels.len(),
                if thinner > 0 { " and thin parts" } else { "" }
            ));
        }
        let thin = bins.iter().enumerate().filter_map(|(bin, facets)| {
            let missing = 1.0 - bin as f64 / DEPTHS.len() as f64;
            Some((Set::new(facets)?, 0.5 * missing * spacing))
        });
        Ok(Self {
            bounds: bounds(
                mesh.facets
                    .iter()
                    .flat_map(|&f| mesh_corners(&mesh.vertices, f)),
            ),
            thin: thin.collect(),
            solid,
        })
    }

    /// Signed distance at `p`, negative in the solid, and its direction.
    pub fn at(&self, p: &Vector<3>) -> (f64, Vector<3>) {
        let mut best = (f64::INFINITY, Vector::<3>::zeros());
        if let Some(set) = &self.solid
            && let Some((point, up)) = set.closest(p)
        {
            let sign = if set.winds_around(p) { -1.0 } else { 1.0 };
            let distance = (p - point).norm();
            let out = if distance > 0.0 {
                sign / distance * (p - point)
            } else {
                up
            };
            best = (sign * distance, out);
        }
        for (set, half) in &self.thin {
            if let Some((point, up)) = set.closest(p) {
                let distance = (p - point).norm();
                if distance - half < best.0 {
                    let out = (p - point).try_normalize(0.0).unwrap_or(up);
                    best = (distance - half, out);
                }
            }
        }
        best
    }

    /// Calls `visit` with boxes that hold the surface, each about `size` wide.
    pub fn near_surface(&self, size: f64, mut visit: impl FnMut(&Vector<3>, &Vector<3>)) {
        let solid = self.solid.iter().map(|set| (set, 0.0));
        for (set, half) in solid.chain(self.thin.iter().map(|(set, half)| (set, *half))) {
            for facet in &set.facets {
                for [a, b, c] in pieces(*facet, size) {
                    let low = a.inf(&b).inf(&c).add_scalar(-half);
                    let high = a.sup(&b).sup(&c).add_scalar(half);
                    visit(&low, &high);
                }
            }
        }
    }
}

fn mesh_corners(vertices: &[Vector<3>], facet: [u32; 3]) -> Facet {
    facet.map(|v| vertices[v as usize])
}

/// The triangles of closed parts, outwards, with what closes their holes; and all others.
fn sorted(mesh: &Indexed) -> (Vec<Facet>, Vec<Facet>) {
    let across = in_pairs(&mesh.facets, &half_edges(&mesh.facets));
    let (part_of, count) = parts(&across);
    let mut lists = vec![Vec::new(); count];
    for (facet, &part) in part_of.iter().enumerate() {
        lists[part as usize].push(facet);
    }
    let (mut closed, mut panels) = (Vec::new(), Vec::new());
    for list in lists {
        match shell(mesh, &across, &list) {
            Some(facets) => closed.extend(facets),
            None => panels.extend(list.iter().map(|&f| mesh.corners(mesh.facets[f]))),
        }
    }
    (closed, panels)
}

/// The triangles of a part that encloses a solid but for a few holes, outwards and with those closed.
fn shell(mesh: &Indexed, across: &[[u32; 3]], part: &[usize]) -> Option<Vec<Facet>> {
    let mut facets = agreed(mesh, across, part)?;
    let area = |list: &[[u32; 3]]| list.iter().map(|&f| mesh.area(f)).sum::<f64>();
    let whole = area(&facets);
    for rim in rims(&half_edges(&facets)) {
        facets.extend(span(mesh, &rim).1);
    }
    if area(&facets) > (1.0 + MOST_OPEN) * whole {
        return None;
    }
    let balanced = |group: &[super::super::edges::HalfEdge]| {
        group
            .iter()
            .map(super::super::edges::HalfEdge::sign)
            .sum::<i32>()
            == 0
    };
    if !super::super::edges::by_edge(&half_edges(&facets)).all(balanced) {
        return None;
    }
    let origin = mesh.vertices[facets[0][0] as usize];
    let sixfold = |&facet: &[u32; 3]| {
        let [a, b, c] = mesh.corners(facet).map(|v| v - origin);
        a.dot(&b.cross(&c))
    };
    let volume = facets.iter().map(sixfold).sum::<f64>();
    if volume.abs() <= mesh.tolerance * whole {
        return None;
    }
    let outwards = |[a, b, c]: Facet| if volume < 0.0 { [a, c, b] } else { [a, b, c] };
    Some(facets.iter().map(|&f| outwards(mesh.corners(f))).collect())
}

/// The triangles of a part, turned so that neighbours agree; nothing where they cannot.
fn agreed(mesh: &Indexed, across: &[[u32; 3]], part: &[usize]) -> Option<Vec<[u32; 3]>> {
    let place = |facet: u32| part.binary_search(&(facet as usize)).ok();
    let mut turned: Vec<Option<bool>> = vec![None; part.len()];
    turned[0] = Some(false);
    let mut open = vec![0];
    while let Some(n) = open.pop() {
        let facet = mesh.facets[part[n]];
        for edge in 0..3 {
            let other = across[part[n]][edge];
            if other == NONE {
                continue;
            }
            let other = place(other)?;
            let (a, b) = (facet[edge], facet[(edge + 1) % 3]);
            let near = mesh.facets[part[other]];
            let alike = (0..3).any(|k| near[k] == a && near[(k + 1) % 3] == b);
            let wanted = turned[n] == Some(!alike);
            match turned[other] {
                None => {
                    turned[other] = Some(wanted);
                    open.push(other);
                }
                Some(before) if before != wanted => return None,
                Some(_) => {}
            }
        }
    }
    let facet = |(&f, turned): (&usize, &Option<bool>)| {
        let [a, b, c] = mesh.facets[f];
        if *turned == Some(true) {
            [a, c, b]
        } else {
            [a, b, c]
        }
    };
    Some(part.iter().zip(&turned).map(facet).collect())
}

/// Which of [`DEPTHS`] the solid below a piece of its surface does not reach; nothing where it is thick,
/// or where the piece is inside of the solid.
fn thickness(set: &Set, piece: &Facet, spacing: f64, tolerance: f64) -> Option<usize> {
    let middle = (piece[0] + piece[1] + piece[2]) / 3.0;
    let up = normal(piece);
    if set.winds_around(&(middle + 10.0 * tolerance * up)) {
        return None;
    }
    let thin = |depth: &f64| !set.winds_around(&(middle - depth * spacing * up));
    DEPTHS.iter().position(thin)
}

/// Parts of a triangle with edges of at most about `size`.
fn pieces(facet: Facet, size: f64) -> impl Iterator<Item = Facet> {
    let mut open = vec![facet];
    std::iter::from_fn(move || {
        loop {
            let [a, b, c] = open.pop()?;
            let lengths = [(b - a).norm(), (c - b).norm(), (a - c).norm()];
            let longest = (0..3).max_by(|&k, &l| lengths[k].total_cmp(&lengths[l]))?;
            if lengths[longest] <= size {
                return Some([a, b, c]);
            }
            let [p, q, r] = [[a, b, c], [b, c, a], [c, a, b]][longest];
            let middle = 0.5 * (p + q);
            open.push([p, middle, r]);
            open.push([middle, q, r]);
        }
    })
}
