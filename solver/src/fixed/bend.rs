//! A sharp convex bend of a wall, and what lies around it.

use aero_geometry::Vector;

use super::net::{Face, FaceShape};
use super::polytope::cross;
use super::state::Primitive;

/// A convex bend in the plane, or a piece of an edge in space, met from one side.
#[derive(Clone, Debug, PartialEq)]
pub struct Bend<const D: usize> {
    /// Where it is, in space its middle.
    pub at: [f64; D],
    /// Direction of the edge in space; zero in the plane.
    pub edge: [f64; D],
    /// Cells on the wall before it, and what each counts, in all one.
    pub donors: Vec<(u32, f64)>,
    /// Direction of the wall behind it, away from it.
    pub along: [f64; D],
    /// Direction of the wall before it, towards it.
    pub before: [f64; D],
    /// Normal of that wall, into the gas.
    pub up: [f64; D],
    /// Spacing of the points there.
    pub unit: f64,
}

/// What of a block lies around a bend.
#[derive(Clone, Debug)]
pub struct Surroundings<const D: usize> {
    /// The bend as it is met from one side, or from either.
    pub bends: Vec<Bend<D>>,
    /// Numbers of faces.
    pub faces: Vec<u32>,
    /// Numbers of walls.
    pub walls: Vec<u32>,
}

/// A face near a bend; all places as seen from there, across the edge.
#[derive(Clone, Copy, Debug)]
pub struct BentFace<const D: usize> {
    /// Points of both cells.
    pub points: [[f64; D]; 2],
    /// Middle of the face.
    pub middle: [f64; D],
    /// How far that is from the bend, in spacings.
    pub away: f64,
}

/// A wall near a bend; all places as seen from there, across the edge.
#[derive(Clone, Copy, Debug)]
pub struct BentWall<const D: usize> {
    /// Point of its cell.
    pub point: [f64; D],
    /// Middle of the wall.
    pub middle: [f64; D],
    /// How far that is from the bend, in spacings.
    pub away: f64,
}

impl<const D: usize> Bend<D> {
    /// An arm from the bend less what of it goes along the edge.
    pub fn across(&self, arm: &Vector<D>) -> Vector<D> {
        let edge = Vector::from(self.edge);
        arm - edge * edge.dot(arm)
    }

    /// The gas before it.
    pub fn front(&self, states: &[Primitive<D>]) -> Primitive<D> {
        let donors = self.donors.iter();
        donors.fold(Primitive::ZERO, |sum, &(i, part)| {
            sum.plus(part, &states[i as usize])
        })
    }

    /// The `face` of this shape, whose first cell is at `point`.
    pub fn face(&self, points: &[Vector<D>], face: &Face, shape: &FaceShape<D>) -> BentFace<D> {
        let at = Vector::from(self.at);
        let arm = |i: u32| points[i as usize] - at;
        let [first, second] = [arm(face.i), arm(face.j)];
        let middle = middle(&first, shape);
        let middle = self.across(&middle);
        BentFace {
            points: [self.across(&first).into(), self.across(&second).into()],
            middle: middle.into(),
            away: middle.norm() / self.unit,
        }
    }

    /// The wall with its middle at `foot` of a cell at `point`.
    pub fn wall(&self, point: &Vector<D>, foot: &Vector<D>) -> BentWall<D> {
        let at = Vector::from(self.at);
        let middle = self.across(&(foot - at));
        BentWall {
            point: self.across(&(point - at)).into(),
            middle: middle.into(),
            away: middle.norm() / self.unit,
        }
    }

    /// From the middle of a face of this shape half of its length each way: across the edge, and where the edge does not lie in
    /// the face the other way as well.
    pub fn halves(&self, shape: &FaceShape<D>) -> [[f64; D]; 2] {
        let normal = Vector::from(shape.area) / shape.size;
        if D == 2 {
            let length = shape.weight * Vector::from(shape.apart).norm();
            return [(turned(&normal) * (0.5 * length)).into(), [0.0; D]];
        }
        let half = 0.5 * shape.size.sqrt();
        let edge = Vector::from(self.edge);
        let leaning = normal.dot(&edge);
        let across = cross(&edge, &normal);
        let first = if across.norm() > LYING {
            across.normalize()
        } else {
            Vector::from(self.up)
        };
        let second = if leaning.abs() > LYING {
            cross(&normal, &first) * half
        } else {
            Vector::zeros()
        };
        [(first * half).into(), second.into()]
    }
}

/// Cosine between an edge and the normal of a face up to which it lies in the face.
const LYING: f64 = 1e-3;

/// The middle of a face of this shape between a cell at `first` and another.
pub fn middle<const D: usize>(first: &Vector<D>, shape: &FaceShape<D>) -> Vector<D> {
    first + Vector::from(shape.apart) * 0.5 + Vector::from(shape.skew)
}

/// A vector turned by a quarter to the left.
pub fn turned<const D: usize>(vector: &Vector<D>) -> Vector<D> {
    let mut turned = Vector::zeros();
    turned[0] = -vector[1 % D];
    turned[1 % D] = vector[0];
    turned
}
