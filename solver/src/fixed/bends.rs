//! Sharp convex bends of walls in the plane, and the cells around each.

use aero_geometry::Vector;

use super::cells::Cells;
use super::chain::Chain;
use super::net::{Face, Net};

/// Up to here from a bend, in spacings, a fan is too narrow for cells to see.
const NEAR: f64 = 6.0;

/// From here on they do see it.
const FAR: f64 = 8.0;

/// A convex bend, met from one side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bend<const D: usize> {
    /// Where it is.
    pub at: [f64; D],
    /// A cell on the wall before it.
    pub donor: u32,
    /// Direction of the wall behind it, away from it.
    pub along: [f64; D],
    /// Direction of the wall before it, towards it.
    pub before: [f64; D],
    /// Normal of that wall, into the gas.
    pub up: [f64; D],
    /// Spacing of the points there.
    pub unit: f64,
}

/// A face near a bend; all places as seen from there.
#[derive(Clone, Copy, Debug)]
pub struct BentFace<const D: usize> {
    /// Which it is.
    pub face: Face,
    /// Points of both cells.
    pub points: [[f64; D]; 2],
    /// Middle of the face.
    pub middle: [f64; D],
    /// From there to its end.
    pub half: [f64; D],
    /// Unit normal from the first to the second cell.
    pub normal: [f64; D],
    /// Area.
    pub size: f64,
    /// From one next to the bend to zero.
    pub weight: f64,
}

/// A wall near a bend; all places as seen from there.
#[derive(Clone, Copy, Debug)]
pub struct BentWall<const D: usize> {
    /// Its number in its block.
    pub wall: usize,
    /// Point of its cell.
    pub point: [f64; D],
    /// Middle of the wall.
    pub middle: [f64; D],
    /// From one next to the bend to zero.
    pub weight: f64,
}

/// What of a block lies around a bend.
#[derive(Clone, Debug)]
pub struct Surroundings<const D: usize> {
    /// The bend.
    pub bend: Bend<D>,
    /// Faces.
    pub faces: Vec<BentFace<D>>,
    /// Walls.
    pub walls: Vec<BentWall<D>>,
}

impl<const D: usize> Net<D> {
    /// Finds the sharp bends of the walls of `cells`, in the plane, and what lies around them.
    pub(super) fn add_bends(&mut self, cells: &Cells<D>) {
        if D != 2 {
            return;
        }
        let bends = Chain::new(self, cells).bends();
        if bends.is_empty() {
            return;
        }
        let places: Vec<Vector<D>> = bends.iter().map(|bend| bend.at.into()).collect();
        let is_nearest = |at: &Vector<D>, place: &Vector<D>, unit: f64| {
            let away = (place - at).norm() - 1e-6 * unit;
            places.iter().all(|other| (place - other).norm() > away)
        };
        for number in 0..self.blocks.len() {
            for (bend, at) in bends.iter().zip(&places) {
                let weight = |middle: &Vector<D>| {
                    let away = middle.norm() / bend.unit;
                    let is_own = || is_nearest(at, &(middle + at), bend.unit);
                    if away < FAR && is_own() {
                        ((FAR - away) / (FAR - NEAR)).min(1.0)
                    } else {
                        0.0
                    }
                };
                let block = &self.blocks[number];
                let faces = block.faces.iter();
                let faces = faces.filter_map(|face| self.bent_face(cells, at, face, weight));
                let walls = block.walls.iter().enumerate().filter_map(|(wall, known)| {
                    let middle = known.foot - at;
                    let weight = weight(&middle);
                    (weight > 0.0).then(|| BentWall {
                        wall,
                        point: (cells.points[known.i as usize] - at).into(),
                        middle: middle.into(),
                        weight,
                    })
                });
                let around = Surroundings {
                    bend: *bend,
                    faces: faces.collect(),
                    walls: walls.collect(),
                };
                if !around.faces.is_empty() || !around.walls.is_empty() {
                    self.blocks[number].bends.push(around);
                }
            }
        }
    }

    /// A face as seen from the bend `at`, where it counts.
    fn bent_face(
        &self,
        cells: &Cells<D>,
        at: &Vector<D>,
        face: &Face,
        weight: impl Fn(&Vector<D>) -> f64,
    ) -> Option<BentFace<D>> {
        let shape = &self.face_shapes[face.shape as usize];
        let apart = Vector::<D>::from(shape.apart);
        let [first, second] = [face.i, face.j].map(|i| cells.points[i as usize] - at);
        let middle = first + apart * 0.5 + Vector::from(shape.skew);
        let weight = weight(&middle);
        // Faces to periodic images lie elsewhere.
        let is_there = (second - first - apart).norm() < 1e-6 * apart.norm();
        if weight <= 0.0 || !is_there {
            return None;
        }
        let normal = shape.area.map(|part| part / shape.size);
        let length = shape.weight * apart.norm();
        let half = turned(&normal.into()) * (0.5 * length);
        Some(BentFace {
            face: *face,
            points: [first.into(), second.into()],
            middle: middle.into(),
            half: half.into(),
            normal,
            size: shape.size,
            weight,
        })
    }
}

/// A vector turned by a quarter to the left.
pub fn turned<const D: usize>(vector: &Vector<D>) -> Vector<D> {
    let mut turned = Vector::zeros();
    turned[0] = -vector[1 % D];
    turned[1 % D] = vector[0];
    turned
}
