//! What is left of the surface of solids that overlap, or of one that folds through itself: the
//! parts of triangles that have the solid on one side and the outside on the other.
//!
//! Triangles that others cross are quartered until a piece is crossed no more, or is small.

use rayon::prelude::*;

use super::tree::Tree;
use super::triangle::{Feature, OnTriangle, closest_on};
use crate::{Bounds, Vector};

/// Pieces with a longest edge below this part of the body's diagonal are not cut further: the exposed
/// surface ends so near to where the triangles really cross.
const SMALLEST: f64 = 1e-3;

/// Most pieces of all triangles together: a surface that crosses itself everywhere is not cut further.
const MOST: usize = 4_000_000;

type Corners = [Vector<3>; 3];

/// A piece and the triangle that it is part of.
type Part = (Corners, u32);

/// The exposed pieces and the triangles that they are parts of.
#[derive(Clone, Debug)]
pub(super) struct Exposed {
    tree: Tree,
    pieces: Vec<Part>,
}

/// A piece on its way.
struct Piece {
    corners: Corners,
    owner: u32,
    /// Triangles that may cross it.
    near: Vec<u32>,
}

/// What the search needs to know of the whole surface.
pub(super) struct Surface<'a> {
    pub tree: &'a Tree,
    pub vertices: &'a [Vector<3>],
    pub facets: &'a [[u32; 3]],
    /// Distance below which points are one.
    pub tolerance: f64,
    pub bounds: Bounds<3>,
}

impl Surface<'_> {
    fn corners(&self, facet: u32) -> Corners {
        self.facets[facet as usize].map(|v| self.vertices[v as usize])
    }

    /// True where triangles that are not `hidden` and have no vertex in common cross or touch.
    pub fn crosses_itself(&self, hidden: &[bool]) -> bool {
        (0..self.facets.len() as u32)
            .into_par_iter()
            .filter(|&facet| !hidden[facet as usize])
            .any(|facet| {
                let own = self.corners(facet);
                let near = self.neighbours(facet);
                near.iter()
                    .any(|&other| meet(&own, &self.corners(other), self.tolerance))
            })
    }

    /// Triangles without a common vertex whose boxes meet that of `facet`.
    fn neighbours(&self, facet: u32) -> Vec<u32> {
        let own = self.facets[facet as usize];
        let [a, b, c] = self.corners(facet);
        let low = a.inf(&b).inf(&c).add_scalar(-self.tolerance);
        let high = a.sup(&b).sup(&c).add_scalar(self.tolerance);
        let mut found = Vec::new();
        self.tree.for_each_in(&low, &high, |other| {
            let shares = self.facets[other as usize].iter().any(|v| own.contains(v));
            if !shares {
                found.push(other);
            }
        });
        found
    }
}

impl Exposed {
    /// Cuts the triangles that are not `hidden` up, and keeps the pieces for which `parting` holds. Nothing where no piece is left.
    pub fn new(
        surface: &Surface<'_>,
        hidden: &[bool],
        parting: impl Fn(&Corners) -> bool + Sync,
    ) -> Option<Self> {
        let smallest = SMALLEST * surface.bounds.size().norm();
        let mut open: Vec<Piece> = (0..surface.facets.len() as u32)
            .into_par_iter()
            .filter(|&facet| !hidden[facet as usize])
            .map(|owner| Piece {
                corners: surface.corners(owner),
                owner,
                near: surface.neighbours(owner),
            })
            .collect();
        let mut whole: Vec<Part> = Vec::new();
        while !open.is_empty() {
            let last = open.len() + whole.len() > MOST;
            let cut: Vec<(Option<Part>, Vec<Piece>)> = open
                .into_par_iter()
                .map(|mut piece| {
                    piece.near.retain(|&other| {
                        meet(&piece.corners, &surface.corners(other), surface.tolerance)
                    });
                    if last || piece.near.is_empty() || longest(&piece.corners) < smallest {
                        (Some((piece.corners, piece.owner)), Vec::new())
                    } else {
                        (None, quarters(&piece))
                    }
                })
                .collect();
            open = Vec::new();
            for (done, rest) in cut {
                whole.extend(done);
                open.extend(rest);
            }
        }
        let pieces: Vec<Part> = whole
            .into_par_iter()
            .filter(|piece| parting(&piece.0))
            .collect();
        if pieces.is_empty() {
            return None;
        }
        let vertices: Vec<Vector<3>> = pieces.iter().flat_map(|piece| piece.0).collect();
        let facets: Vec<[u32; 3]> = (0..pieces.len() as u32)
            .map(|n| [3 * n, 3 * n + 1, 3 * n + 2])
            .collect();
        let (tree, order) = Tree::new(&vertices, &facets);
        let pieces = order.iter().map(|&n| pieces[n as usize]).collect();
        Some(Self { tree, pieces })
    }

    /// The triangle with the closest exposed piece, and the closest point of that piece.
    pub fn closest(&self, p: &Vector<3>) -> Option<(u32, OnTriangle)> {
        let corners = |n: u32| self.pieces[n as usize].0;
        let (piece, _) = self.tree.closest(p, corners, |_| false)?;
        let (corners, owner) = &self.pieces[piece as usize];
        Some((*owner, closest_on(corners, p)))
    }

    /// Owners of the pieces.
    pub fn owners(&self) -> impl Iterator<Item = u32> {
        self.pieces.iter().map(|piece| piece.1)
    }

    /// Whether a point of the exposed surface lies where it was cut off, given the feature of the
    /// whole triangle and that of its piece there.
    pub fn is_cut(whole: Feature, piece: Feature) -> bool {
        whole == Feature::Face && piece != Feature::Face
    }
}

fn longest([a, b, c]: &Corners) -> f64 {
    (b - a).norm().max((c - b).norm()).max((a - c).norm())
}

/// The four parts between the middles of the edges.
fn quarters(piece: &Piece) -> Vec<Piece> {
    let [a, b, c] = piece.corners;
    let (ab, bc, ca) = (0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a));
    [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
        .into_iter()
        .map(|corners| Piece {
            corners,
            owner: piece.owner,
            near: piece.near.clone(),
        })
        .collect()
}

/// True where two triangles cross or touch.
fn meet(a: &Corners, b: &Corners, tolerance: f64) -> bool {
    let edges = |t: &Corners| [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]];
    edges(a).iter().any(|edge| pierces(edge, b, tolerance))
        || edges(b).iter().any(|edge| pierces(edge, a, tolerance))
}

/// True where the edge comes within `tolerance` of the triangle: where it passes through its plane,
/// or at an end.
fn pierces([from, to]: &[Vector<3>; 2], triangle: &Corners, tolerance: f64) -> bool {
    let [a, b, c] = triangle;
    let Some(normal) = (b - a).cross(&(c - a)).try_normalize(0.0) else {
        return false;
    };
    let (low, high) = ((from - a).dot(&normal), (to - a).dot(&normal));
    let near = |p: &Vector<3>| (closest_on(triangle, p).point - p).norm() <= tolerance;
    if low.abs() <= tolerance && near(from) || high.abs() <= tolerance && near(to) {
        return true;
    }
    low * high < 0.0 && near(&(from + low / (low - high) * (to - from)))
}
