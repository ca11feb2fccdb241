//! A sharp convex bend of a wall in the plane, and what lies around it.

use aero_geometry::Vector;

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
    /// Its number in its block.
    pub face: usize,
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
    /// How far that is from the bend, in spacings.
    pub away: f64,
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
    /// How far that is from the bend, in spacings.
    pub away: f64,
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

/// A vector turned by a quarter to the left.
pub fn turned<const D: usize>(vector: &Vector<D>) -> Vector<D> {
    let mut turned = Vector::zeros();
    turned[0] = -vector[1 % D];
    turned[1 % D] = vector[0];
    turned
}
