//! Where shocks are rooted in the plane, at a sharp concave bend of a wall or a tip that parts the stream, and the cells around it.

use aero_geometry::Vector;

use super::bend::{Bend, turned};
use super::state::dot;

/// A straight piece of the outline of a cell, as seen from the root.
#[derive(Clone, Copy, Debug)]
pub struct Piece<const D: usize> {
    /// Unit normal, out of the cell.
    pub normal: [f64; D],
    /// Both ends.
    pub ends: [[f64; D]; 2],
}

/// The outline of a cell, as seen from the root.
#[derive(Clone, Debug)]
pub struct Plan<const D: usize> {
    /// The cell's number.
    pub cell: u32,
    /// Its point.
    pub point: [f64; D],
    /// No end of a piece is farther from the point.
    pub radius: f64,
    /// All around it, in any order.
    pub pieces: Vec<Piece<D>>,
}

/// A face around the root.
#[derive(Clone, Copy, Debug)]
pub struct RootFace<const D: usize> {
    /// Its number in its block.
    pub number: u32,
    /// Numbers of both cells among those around the root.
    pub cells: [u32; 2],
    /// The face as seen from the root.
    pub piece: Piece<D>,
    /// How far its middle is from the root, in spacings.
    pub away: f64,
}

/// A wall or a mirror around the root.
#[derive(Clone, Copy, Debug)]
pub struct RootWall {
    /// Its number in its block.
    pub number: u32,
    /// Number of its cell among those around the root.
    pub cell: u32,
    /// How far it is from the root, in spacings.
    pub away: f64,
    /// Number of the wall that it goes on as, of those that lead away from the root; none where it goes on as that before a bend.
    pub behind: Option<u8>,
}

/// The part of the plane between a shock and the wall behind it: what lies on one side of both of two lines through the root.
#[derive(Clone, Copy, Debug)]
pub struct Sector<const D: usize> {
    /// Normals of the lines, into it. Twice the same where it is all that one of them bounds.
    pub sides: [[f64; D]; 2],
}

/// What of a block lies around a sharp concave bend that is met from one side, or around a tip.
#[derive(Clone, Debug)]
pub struct Root<const D: usize> {
    /// The same for what of other blocks lies around this place.
    pub number: u32,
    /// The bend; the two that gas meets at a tip, which parts it.
    pub bends: Vec<Bend<D>>,
    /// Cells.
    pub cells: Vec<Plan<D>>,
    /// Faces between them.
    pub faces: Vec<RootFace<D>>,
    /// Their walls.
    pub walls: Vec<RootWall>,
    /// Their mirrors.
    pub mirrors: Vec<RootWall>,
}

impl<const D: usize> Root<D> {
    /// True of a tip.
    pub fn is_tip(&self) -> bool {
        self.bends.len() > 1
    }
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

    /// The part of it that is in a `sector`.
    pub fn part(&self, sector: &Sector<D>) -> f64 {
        let (mut from, mut to) = (0.0_f64, 1.0_f64);
        for normal in sector.sides {
            let [start, end] = self.ends.map(|end| dot(&end, &normal));
            match (start > 0.0, end > 0.0) {
                (true, true) => {}
                (false, false) => return 0.0,
                (true, false) => to = to.min(start / (start - end)),
                (false, true) => from = from.max(start / (start - end)),
            }
        }
        (to - from).max(0.0)
    }

    /// Area between the root and the piece, more where it looks away from the root and less where it looks there.
    fn area(&self) -> f64 {
        let away = Vector::from(self.ends[0]).dot(&Vector::from(self.normal));
        0.5 * away * self.length()
    }
}

impl<const D: usize> Plan<D> {
    /// Of a `cell` with its point and `pieces`, where these close.
    pub fn new(cell: u32, point: Vector<D>, pieces: Vec<Piece<D>>) -> Option<Self> {
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
            cell,
            point: point.into(),
            radius,
            pieces,
        })
    }

    /// How far its point is on that side of a line through the root to which its unit `normal` points.
    pub fn height(&self, normal: &[f64; D]) -> f64 {
        dot(&self.point, normal)
    }

    /// The part of its area that is in a `sector`. What is between a piece and the root has no part in a line through the root.
    pub fn part(&self, sector: &Sector<D>) -> f64 {
        /// Less than this is rounding.
        const LEAST: f64 = 1e-9;
        let height = sector.sides.map(|normal| self.height(&normal));
        if height.iter().any(|height| *height <= -self.radius) {
            return 0.0;
        }
        if height.iter().all(|height| *height >= self.radius) {
            return 1.0;
        }
        let (mut within, mut all) = (0.0, 0.0);
        for piece in &self.pieces {
            let area = piece.area();
            within += piece.part(sector) * area;
            all += area;
        }
        let part = within / all;
        if part < LEAST {
            0.0
        } else if part > 1.0 - LEAST {
            1.0
        } else {
            part
        }
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
        Plan::new(0, middle, pieces.to_vec()).unwrap()
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
            let sector = Sector { sides: [normal; 2] };
            assert_relative_eq!(rectangle(low, high).part(&sector), part, epsilon = 1e-12);
        }
    }

    #[test]
    fn an_outline_with_a_gap_is_none() {
        let mut pieces = rectangle([1.0, 1.0], [2.0, 2.0]).pieces;
        pieces.pop();
        assert!(Plan::new(0, Vector::<2>::from([1.5, 1.5]), pieces).is_none());
    }
}
