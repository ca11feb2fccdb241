//! Faces and walls as seen from a sharp bend.

use aero_geometry::Vector;

use super::bend::{Bend, BentFace, BentWall, turned};
use super::face_list::Join;
use super::net::FaceShape;
use super::polytope::cross;

/// Cosine between an edge and the normal of a face up to which it lies in the face.
const LYING: f64 = 1e-3;

impl<const D: usize> Bend<D> {
    /// The `face` of this shape, whose first cell is at `point`.
    pub fn face(&self, points: &[Vector<D>], face: &Join, shape: &FaceShape<D>) -> BentFace<D> {
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
            unit: self.unit,
        }
    }

    /// True of a face that looks along the edge, in space. Nothing changes that way: what presses on one such face of a cell presses on the next, be
    /// that a plane of symmetry, of which the fan says nothing.
    pub fn faces_along(&self, shape: &FaceShape<D>) -> bool {
        let normal = Vector::from(shape.area) / shape.size;
        D == 3 && self.across(&normal).norm() <= LYING
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

/// The middle of a face of this shape between a cell at `first` and another.
pub fn middle<const D: usize>(first: &Vector<D>, shape: &FaceShape<D>) -> Vector<D> {
    first + Vector::from(shape.apart) * 0.5 + Vector::from(shape.skew)
}
