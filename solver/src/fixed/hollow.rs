//! A sharp concave bend of a wall in the plane, and the cells around it.

use aero_geometry::Vector;

use super::bend::{Bend, turned};

/// A straight piece of the outline of a cell, as seen from the bend.
#[derive(Clone, Copy, Debug)]
pub struct Piece<const D: usize> {
    /// Unit normal, out of the cell.
    pub normal: [f64; D],
    /// Both ends.
    pub ends: [[f64; D]; 2],
}

/// The outline of a cell, as seen from the bend.
#[derive(Clone, Debug)]
pub struct Plan<const D: usize> {
    /// Its point.
    pub point: [f64; D],
    /// No end of a piece is farther from the point.
    pub radius: f64,
    /// All around it, in any order.
    pub pieces: Vec<Piece<D>>,
}

/// A face around the bend.
#[derive(Clone, Copy, Debug)]
pub struct HollowFace<const D: usize> {
    /// Its number in its block.
    pub number: u32,
    /// Numbers of both cells among those around the bend.
    pub cells: [u32; 2],
    /// The face as seen from the bend.
    pub piece: Piece<D>,
    /// How far its middle is from the bend, in spacings.
    pub away: f64,
}

/// A wall or a mirror around the bend.
#[derive(Clone, Copy, Debug)]
pub struct HollowWall {
    /// Its number in its block.
    pub number: u32,
    /// Number of its cell among those around the bend.
    pub cell: u32,
    /// How far it is from the bend, in spacings.
    pub away: f64,
    /// True where it goes on as the wall behind the bend rather than as that before.
    pub is_behind: bool,
}

/// What of a block lies around a sharp concave bend that is met from one side.
#[derive(Clone, Debug)]
pub struct Hollow<const D: usize> {
    /// The bend.
    pub bend: Bend<D>,
    /// Cells.
    pub cells: Vec<Plan<D>>,
    /// Faces between them.
    pub faces: Vec<HollowFace<D>>,
    /// Their walls.
    pub walls: Vec<HollowWall>,
    /// Their mirrors.
    pub mirrors: Vec<HollowWall>,
}

impl<const D: usize> Piece<D> {
    /// Of this `length` around a `middle`.
    pub fn new(middle: &Vector<D>, normal: &Vector<D>, length: f64) -> Self {
        let half = turned(normal) * (0.5 * length);
        Self {
            normal: (*normal).into(),
            ends: [(middle - half).into(), (middle + half).into()],
        }
    }

    /// Its length.
    pub fn length(&self) -> f64 {
        let [start, end] = self.ends.map(Vector::from);
        (end - start).norm()
    }

    /// The part of it that is on that side of a line through the bend to which its `normal` points.
    pub fn part(&self, normal: &[f64; D]) -> f64 {
        let normal = Vector::from(*normal);
        let [start, end] = self.ends.map(|end| Vector::from(end).dot(&normal));
        match (start > 0.0, end > 0.0) {
            (true, true) => 1.0,
            (false, false) => 0.0,
            (true, false) => start / (start - end),
            (false, true) => end / (end - start),
        }
    }

    /// Area between the bend and the piece, more where it looks away from the bend and less where it looks there.
    fn area(&self) -> f64 {
        let away = Vector::from(self.ends[0]).dot(&Vector::from(self.normal));
        0.5 * away * self.length()
    }
}

impl<const D: usize> Plan<D> {
    /// Of a cell with its point and `pieces`, where these close.
    pub fn new(point: Vector<D>, pieces: Vec<Piece<D>>) -> Option<Self> {
        /// What is left open, in parts of all around.
        const OPEN: f64 = 1e-6;
        let (mut open, mut around, mut radius) = (Vector::zeros(), 0.0, 0.0_f64);
        for piece in &pieces {
            let length = piece.length();
            open += Vector::from(piece.normal) * length;
            around += length;
            for end in piece.ends {
                radius = radius.max((Vector::from(end) - point).norm());
            }
        }
        (open.norm() < OPEN * around).then(|| Self {
            point: point.into(),
            radius,
            pieces,
        })
    }

    /// How far its point is on that side of a line through the bend to which its unit `normal` points.
    pub fn height(&self, normal: &[f64; D]) -> f64 {
        Vector::from(self.point).dot(&Vector::from(*normal))
    }

    /// The part of its area that is on that side. What is between a piece and the bend has no side on a line through the bend.
    pub fn part(&self, normal: &[f64; D]) -> f64 {
        let height = self.height(normal);
        if height.abs() >= self.radius {
            return if height > 0.0 { 1.0 } else { 0.0 };
        }
        let (mut above, mut all) = (0.0, 0.0);
        for piece in &self.pieces {
            let area = piece.area();
            above += piece.part(normal) * area;
            all += area;
        }
        (above / all).clamp(0.0, 1.0)
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    /// A rectangle from one corner to the other.
    fn rectangle(low: [f64; 2], high: [f64; 2]) -> Plan<2> {
        let [low, high] = [low, high].map(Vector::<2>::from);
        let middle = (low + high) * 0.5;
        let half = (high - low) * 0.5;
        let pieces = [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]].map(|normal| {
            let normal = Vector::<2>::from(normal);
            let length = 2.0 * (half[0] * normal[1].abs() + half[1] * normal[0].abs());
            Piece::new(&(middle + normal.component_mul(&half)), &normal, length)
        });
        Plan::new(middle, pieces.to_vec()).unwrap()
    }

    /// A line of 45 degrees through the bend cuts a half, an eighth, or nothing off squares that lie before it.
    #[test]
    fn a_line_through_the_bend_parts_cells_by_area() {
        let normal = [-0.5_f64.sqrt(), 0.5_f64.sqrt()];
        for (low, high, part) in [
            ([1.0, 1.0], [2.0, 2.0], 0.5),
            ([1.0, 0.5], [2.0, 1.5], 0.125),
            ([1.0, 1.5], [2.0, 2.5], 0.875),
            ([1.0, 3.0], [2.0, 4.0], 1.0),
            ([3.0, 1.0], [4.0, 2.0], 0.0),
            ([0.0, 0.0], [2.0, 1.0], 0.25),
        ] {
            assert_relative_eq!(rectangle(low, high).part(&normal), part, epsilon = 1e-12);
        }
    }

    #[test]
    fn an_outline_with_a_gap_is_none() {
        let mut pieces = rectangle([1.0, 1.0], [2.0, 2.0]).pieces;
        pieces.pop();
        assert!(Plan::new(Vector::<2>::from([1.5, 1.5]), pieces).is_none());
    }
}
