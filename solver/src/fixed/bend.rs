//! A sharp bend of a wall, and what lies around a convex one.

use aero_geometry::Vector;

use super::state::Primitive;
use super::walls::Wall;

/// A bend in the plane, or a piece of an edge in space, met from one side.
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

/// A tip in the plane, which parts the gas that meets it.
#[derive(Clone, Debug)]
pub struct Tip<const D: usize> {
    /// Its two walls as one convex bend.
    pub around: Bend<D>,
    /// What gas meets on either side: each goes up to a wall, from the middle between both on.
    pub bends: [Bend<D>; 2],
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
    /// Spacing of the points at the bend.
    pub unit: f64,
}

/// A wall that gas slides along towards a bend or an edge, in the cell that holds it; towards an edge in the one before, too.
#[derive(Clone, Copy, Debug)]
pub struct Kink<const D: usize> {
    /// Its number in its block.
    pub wall: usize,
    /// A cell on the wall before, which does not hold the bend.
    pub donor: u32,
    /// The wall of that cell whose pressure goes on up to an edge; none before a bend, where its gas tells.
    pub pressed: Option<Wall<D>>,
    /// Direction of the wall, towards the bend.
    pub before: [f64; D],
    /// Direction of the edge in space; zero in the plane.
    pub edge: [f64; D],
    /// Direction of the wall behind a concave bend, away from it; none of an edge that no gas follows.
    pub along: Option<[f64; D]>,
}

impl<const D: usize> Bend<D> {
    /// An arm from the bend less what of it goes along the edge.
    pub fn across(&self, arm: &Vector<D>) -> Vector<D> {
        let edge = Vector::from(self.edge);
        arm - edge * edge.dot(arm)
    }

    /// True of a place, as seen from the bend, in front of the one wall or the other that meet there, or hardly behind either: what lies behind both is
    /// beyond the body. At a concave bend what lies behind either is.
    pub fn opens_to(&self, arm: &Vector<D>) -> bool {
        /// So far behind, in spacings, faces that the walls cut may lie.
        const BEHIND: f64 = 0.5;
        let [along, up, behind] = [self.along, self.up, self.up_behind()].map(Vector::from);
        let least = -BEHIND * self.unit;
        let (is_before, is_behind) = (arm.dot(&up) > least, arm.dot(&behind) > least);
        if along.dot(&up) > 0.0 {
            is_before && is_behind
        } else {
            is_before || is_behind
        }
    }

    /// Normal of the wall behind it, into the gas, where it is none of a tip.
    pub fn up_behind(&self) -> [f64; D] {
        let [along, before, up] = [self.along, self.before, self.up].map(Vector::from);
        (up * along.dot(&before) - before * along.dot(&up)).into()
    }

    /// Unit normal, into its gas, of the line, in space the plane, that goes on from it as the gas comes: at a tip the middle of the body.
    pub fn over(&self) -> [f64; D] {
        let [before, up] = [self.before, self.up].map(Vector::from);
        (up - before * before.dot(&up)).normalize().into()
    }

    /// The gas before it.
    pub fn front(&self, states: &[Primitive<D>]) -> Primitive<D> {
        let donors = self.donors.iter();
        donors.fold(Primitive::ZERO, |sum, &(i, part)| {
            sum.plus(part, &states[i as usize])
        })
    }
}

/// How far `b` lies to the left of `a`, times the length of both.
pub fn cross<const D: usize>(a: &Vector<D>, b: &Vector<D>) -> f64 {
    turned(a).dot(b)
}

/// A vector turned by a quarter to the left.
pub fn turned<const D: usize>(vector: &Vector<D>) -> Vector<D> {
    let mut turned = Vector::zeros();
    turned[0] = -vector[1 % D];
    turned[1 % D] = vector[0];
    turned
}

#[cfg(test)]
impl Bend<2> {
    /// Where a wall along the first axis bends up by so much at the origin, in gas of this spacing.
    pub fn ramp(degrees: f64, unit: f64) -> Self {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        Self {
            at: [0.0; 2],
            edge: [0.0; 2],
            donors: Vec::new(),
            along: [cosine, sine],
            before: [1.0, 0.0],
            up: [0.0, 1.0],
            unit,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Behind a convex bend gas may lie behind the one wall or the other, at a concave one behind neither.
    #[test]
    fn gas_lies_in_front_of_its_walls() {
        let opens =
            |degrees: f64, place: [f64; 2]| Bend::ramp(degrees, 0.1).opens_to(&place.into());
        for degrees in [-30.0, 30.0] {
            assert!(opens(degrees, [1.0, 1.0]) && opens(degrees, [-1.0, 0.5]));
            assert!(!opens(degrees, [-1.0, -2.0]));
        }
        assert!(opens(-30.0, [1.0, -0.4]) && !opens(30.0, [1.0, 0.4]));
    }
}
