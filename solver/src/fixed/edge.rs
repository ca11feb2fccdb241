//! Sharp edges in space, and the pieces that gas meets.

use aero_geometry::{Crease, Vector};

use super::bend::Bend;

/// What gas does at an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// It turns away round it.
    Ridge,
    /// It turns into a wall there.
    Hollow,
    /// It parts there.
    Tip,
}

/// An edge, and who owns both of its sides.
#[derive(Clone, Copy, Debug)]
pub struct Edge<const D: usize> {
    /// Numbers of bodies, or of what else walls belong to.
    pub owners: [u32; 2],
    /// Where it is.
    pub crease: Crease<D>,
}

impl<const D: usize> Edge<D> {
    /// A part of it, or as much of the line it lies on.
    pub fn part(&self, ends: [Vector<D>; 2]) -> Self {
        let crease = Crease {
            ends,
            ..self.crease
        };
        Self { crease, ..*self }
    }
}

/// A straight piece of an edge.
#[derive(Clone, Debug)]
pub struct Piece<const D: usize> {
    /// What the edge is to gas.
    pub kind: Kind,
    /// Its ends.
    pub ends: [Vector<D>; 2],
    /// The edge as gas meets it from either side, where it can; of a tip, as gas on either side of it does.
    pub bends: Vec<Bend<D>>,
    /// How its walls lie: one of the bends, but of a tip both walls as one convex bend.
    pub walls: Bend<D>,
    /// Whether the edge goes on beyond each end.
    pub goes_on: [bool; 2],
    /// The same number for all pieces of one edge.
    pub edge: usize,
}

impl<const D: usize> Piece<D> {
    /// Square of the distance of a place, and whether that is neither farther across the edge than `farthest`, in spacings, nor beyond an end of it.
    pub fn sees(&self, place: &Vector<D>, farthest: f64) -> (f64, bool) {
        let unit = self.walls.unit;
        let [from, to] = self.ends;
        let half = 0.5 * (to - from).norm();
        let way = (to - from) / (2.0 * half);
        let arm = place - 0.5 * (from + to);
        let along = way.dot(&arm);
        let beyond = (along.abs() - half).max(0.0);
        let across = (arm - way * along).norm();
        let is_beside = beyond <= 1e-6 * unit || self.goes_on[usize::from(along > 0.0)];
        let is_near = across < farthest * unit;
        let is_open = self.walls.opens_to(&(place - Vector::from(self.walls.at)));
        (
            across * across + beyond * beyond,
            is_beside && is_near && is_open,
        )
    }
}
