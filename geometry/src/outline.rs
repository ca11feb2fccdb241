//! Exact outlines: closed or endless curves of straight pieces and circular arcs around a solid.
//!
//! An outline answers distance queries and shows its pieces, so that layers can be laid along its
//! arc length. Nothing is tessellated. Bodies with names are made in [`crate::bodies`].

mod assemble;
mod check;
mod chords;
mod copies;
mod creases;
mod crossing;
mod foot;
mod halves;
mod joint;
mod measure;
pub(crate) mod piece;
pub(crate) mod polygon;
mod symmetry;

use std::ops::Range;

use creases::Pieces;
use foot::{Foot, Place};
pub use joint::Corner;
pub(crate) use joint::Joint;
use parry2d::partitioning::{Bvh, BvhNode};
pub use piece::{Arc, Line, Piece};

use crate::{Bounds, Closest, Shape, Vector};

/// A connected run of pieces.
#[derive(Clone, Debug, PartialEq)]
pub struct Chain {
    /// Its pieces, in the order of travel (solid to the left).
    pub pieces: Range<usize>,
    /// How it ends.
    pub ends: Ends,
    /// Its length; infinite where it is endless.
    pub length: f64,
}

/// How a chain of pieces ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ends {
    /// The last piece leads into the first: counter-clockwise around a solid.
    Closed,
    /// The first piece comes from infinity and the last one runs there.
    Endless,
    /// Both ends lie on the axis `y = 0`, which mirrors the curve: a meridian of a body of
    /// revolution.
    Axis,
}

/// A solid bounded by lines and arcs; see the [module](self) for its purpose.
#[derive(Clone, Debug)]
pub struct Outline {
    pieces: Vec<Piece>,
    /// Smooth face per piece.
    faces: Vec<u32>,
    /// Joint at the start and at the end of each piece; [`NO_JOINT`] at infinity.
    ends: Vec<[u32; 2]>,
    joints: Vec<Joint>,
    chains: Vec<Chain>,
    corners: Vec<Corner>,
    mirrors: Vec<(usize, f64)>,
    bounds: Bounds<2>,
    /// The size of the finite part, by which tolerances are measured.
    size: f64,
    /// What its pieces stand for, and so which joints separate smooth faces.
    stand_for: Pieces,
    search: Option<Search>,
}

const NO_JOINT: u32 = u32::MAX;

/// Outlines of more pieces than this are searched through a tree of boxes.
const FEW_PIECES: usize = 16;

/// A tree of boxes over the finite pieces, and the endless ones beside it.
#[derive(Clone, Debug)]
struct Search {
    tree: Bvh,
    endless: Vec<u32>,
}

impl Outline {
    /// The pieces, chain after chain, each travelled with the solid to its left.
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// The connected runs of pieces.
    pub fn chains(&self) -> &[Chain] {
        &self.chains
    }

    /// Number of the smooth face that piece `index` belongs to, as in [`Closest::face`].
    pub fn face(&self, index: usize) -> u32 {
        self.faces[index]
    }

    /// The creases, in the order of travel.
    pub fn corners(&self) -> &[Corner] {
        &self.corners
    }

    /// Extent of the finite part of the outline (its corners and arcs).
    pub fn size(&self) -> f64 {
        self.size
    }

    /// Index and foot of the nearest piece; the lower index wins a tie where there are few.
    fn nearest(&self, p: &Vector<2>) -> (usize, Foot) {
        let nearer = |best: (usize, Foot), index: usize| {
            let foot = self.pieces[index].foot(p);
            if foot.distance_squared < best.1.distance_squared {
                (index, foot)
            } else {
                best
            }
        };
        let first = (0, self.pieces[0].foot(p));
        let Some(search) = &self.search else {
            return (1..self.pieces.len()).fold(first, nearer);
        };
        let endless = search.endless.iter().map(|&index| index as usize);
        let start = endless.fold(first, nearer);
        let point = parry2d::math::Vector::new(p.x, p.y);
        let found = search.tree.find_best(
            start.1.distance_squared,
            |node: &BvhNode, _| {
                let outside = (node.mins() - point).max(point - node.maxs());
                outside.max(parry2d::math::Vector::ZERO).length_squared()
            },
            |index, _| Some(self.pieces[index as usize].foot(p).distance_squared),
        );
        found.map_or(start, |(index, _)| nearer(start, index as usize))
    }
}

impl Shape<2> for Outline {
    fn bounds(&self) -> Bounds<2> {
        self.bounds
    }

    fn closest(&self, p: &Vector<2>) -> Closest<2> {
        let (index, foot) = self.nearest(p);
        let joint = match foot.place {
            Place::Within => None,
            Place::Start => Some(self.ends[index][0]),
            Place::End => Some(self.ends[index][1]),
        };
        let Some(joint) = joint.and_then(|joint| self.joints.get(joint as usize)) else {
            let (distance, normal) = self.pieces[index].side(p);
            return Closest {
                point: foot.point,
                distance,
                normal,
                face: self.faces[index],
            };
        };
        let offset = p - joint.point;
        let length = offset.norm();
        let sign = joint.sign(&offset);
        // At the joint itself the offset is rounding noise.
        let normal = if length > 1e-13 * self.size {
            sign / length * offset
        } else {
            joint.bisector
        };
        Closest {
            point: joint.point,
            distance: sign * length,
            normal,
            face: self.faces[joint.nearer(&offset)],
        }
    }

    fn mirror_planes(&self) -> Vec<(usize, f64)> {
        self.mirrors.clone()
    }

    fn outline(&self) -> Option<&Outline> {
        Some(self)
    }

    fn facets(&self, size: f64, region: &Bounds<2>) -> Vec<[Vector<2>; 2]> {
        self.pieces
            .iter()
            .flat_map(|piece| piece.chords(size, region))
            .collect()
    }

    fn measure(&self) -> Option<f64> {
        self.area()
    }
}
