//! What is left of the surface of solids that overlap or touch, or of one that folds through itself:
//! the parts of triangles that have the solid on one side and the outside on the other.

use rayon::prelude::*;

use super::cuts::{self, Corners, Cut, Meeting, Polygon, is_cut};
use super::tree::Tree;
use super::triangle::{Feature, OnTriangle, closest_on, normal};
use crate::Vector;

/// A piece and the triangle that it is part of.
type Part = (Corners, u32);

/// The exposed pieces and the triangles that they are parts of.
#[derive(Clone, Debug)]
pub(super) struct Exposed {
    tree: Tree,
    pieces: Vec<Part>,
}

/// What the search needs to know of the whole surface.
pub(super) struct Surface<'a> {
    pub tree: &'a Tree,
    pub vertices: &'a [Vector<3>],
    pub facets: &'a [[u32; 3]],
    /// Triangles that are no part of the surface.
    pub hidden: &'a [bool],
    /// Distance below which points are one.
    pub tolerance: f64,
}

impl Surface<'_> {
    fn corners(&self, facet: u32) -> Corners {
        self.facets[facet as usize].map(|v| self.vertices[v as usize])
    }

    fn visible(&self) -> impl ParallelIterator<Item = u32> {
        let hidden = |&facet: &u32| self.hidden[facet as usize];
        (0..self.facets.len() as u32)
            .into_par_iter()
            .filter(move |facet| !hidden(facet))
    }

    /// True where triangles cross or lie on each other.
    pub fn crosses_itself(&self) -> bool {
        self.visible()
            .any(|facet| is_cut(&self.corners(facet), &self.met(facet).0, self.tolerance))
    }

    /// The lines along which others meet a triangle, and the earlier ones that lie on it and face its
    /// way.
    fn met(&self, facet: u32) -> (Vec<Cut>, Vec<u32>) {
        let own = self.corners(facet);
        let [a, b, c] = own;
        let low = a.inf(&b).inf(&c).add_scalar(-self.tolerance);
        let high = a.sup(&b).sup(&c).add_scalar(self.tolerance);
        let (mut found, mut copies) = (Vec::new(), Vec::new());
        self.tree.for_each_in(&low, &high, |other| {
            if other == facet || self.hidden[other as usize] {
                return;
            }
            let meeting = cuts::cuts(&own, &self.corners(other), self.tolerance, &mut found);
            if meeting == (Meeting::Flush { alike: true }) && other < facet {
                copies.push(other);
            }
        });
        (found, copies)
    }

    /// The pieces of a triangle that no other one enters, those aside on which an earlier triangle lies.
    fn pieces(&self, facet: u32) -> Vec<Polygon> {
        let own = self.corners(facet);
        let (found, copies) = self.met(facet);
        let mut pieces = cuts::pieces(&own, found, self.tolerance);
        pieces.retain(|piece| {
            let middle = middle(piece);
            copies.iter().all(|&copy| {
                let on = closest_on(&self.corners(copy), &middle).point;
                (on - middle).norm() > self.tolerance
            })
        });
        pieces
    }
}

impl Exposed {
    /// Cuts up the triangles that are not hidden, and keeps the pieces for which
    /// `parting(middle, normal)` holds. Nothing where no piece is left.
    pub fn new(
        surface: &Surface<'_>,
        parting: impl Fn(&Vector<3>, &Vector<3>) -> bool + Sync,
    ) -> Option<Self> {
        let pieces: Vec<Part> = surface
            .visible()
            .flat_map_iter(|facet| {
                let up = normal(&surface.corners(facet));
                let mut pieces = surface.pieces(facet);
                pieces.retain(|piece| parting(&middle(piece), &up));
                pieces.into_iter().flat_map(move |polygon| {
                    fan(&polygon)
                        .map(|corners| (corners, facet))
                        .collect::<Vec<_>>()
                })
            })
            .collect();
        if pieces.is_empty() {
            return None;
        }
        let (tree, order) = Tree::over(&pieces, |piece| piece.0);
        let pieces = order.iter().map(|&n| pieces[n as usize]).collect();
        Some(Self { tree, pieces })
    }

    /// The triangle with the closest exposed piece, and the closest point of that piece.
    pub fn closest(&self, p: &Vector<3>) -> Option<(u32, OnTriangle)> {
        let corners = |n: u32| self.pieces[n as usize].0.each_ref();
        let (piece, _) = self.tree.closest(p, corners, |_| false)?;
        let (corners, owner) = &self.pieces[piece as usize];
        Some((*owner, closest_on(corners, p)))
    }

    /// Owners of the pieces.
    pub fn owners(&self) -> impl Iterator<Item = u32> {
        self.pieces.iter().map(|piece| piece.1)
    }

    /// The corners of the pieces.
    pub fn corners(&self) -> impl Iterator<Item = Corners> {
        self.pieces.iter().map(|piece| piece.0)
    }

    /// Whether a point of the exposed surface lies where it was cut off, given the feature of the
    /// whole triangle and that of its piece there.
    pub fn is_cut(whole: Feature, piece: Feature) -> bool {
        whole == Feature::Face && piece != Feature::Face
    }
}

/// The mean of the corners of a polygon.
fn middle(polygon: &[Vector<3>]) -> Vector<3> {
    polygon.iter().sum::<Vector<3>>() / polygon.len() as f64
}

/// The triangles of a convex polygon; those without an area are no loss.
fn fan(polygon: &[Vector<3>]) -> impl Iterator<Item = Corners> + '_ {
    (2..polygon.len())
        .map(|k| [polygon[0], polygon[k - 1], polygon[k]])
        .filter(|corners| normal(corners) != Vector::<3>::zeros())
}
