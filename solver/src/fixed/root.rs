//! Where shocks are rooted, at a sharp concave bend of a wall or a tip that parts the stream, in space at a piece of a hollow or of a leading edge, and
//! the cells around it.

use std::sync::Arc;

use aero_geometry::Vector;

use super::bend::Bend;
use super::outline_piece::{Piece, Sector};
use super::state::dot;

/// The outline of a cell.
#[derive(Clone, Debug)]
pub struct Plan<const D: usize> {
    /// The cell's number.
    pub cell: u32,
    /// Its point as seen from the root.
    pub point: [f64; D],
    /// No corner is farther from the point.
    pub radius: f64,
    /// What of it gas fills.
    pub volume: f64,
    /// All around it, in any order: as seen from the root in the plane, from its point in space, where many cells look alike.
    pub pieces: Arc<[Piece<D>]>,
}

/// A face around the root.
#[derive(Clone, Copy, Debug)]
pub struct RootFace {
    /// Its number in its block.
    pub number: u32,
    /// Numbers of both cells among those around the root.
    pub cells: [u32; 2],
    /// Which of the first cell's pieces it is.
    pub facet: u32,
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

/// What of a block lies around a sharp concave bend that is met from one side, or around a tip.
#[derive(Clone, Debug)]
pub struct Root<const D: usize> {
    /// The same for what of other blocks lies around this place.
    pub number: u32,
    /// The bend; the two that gas meets at a tip, which parts it.
    pub bends: Vec<Bend<D>>,
    /// Of the tip of a cone about an axis, how far its wall goes on straight, in spacings.
    pub apex: Option<f64>,
    /// Cells.
    pub cells: Vec<Plan<D>>,
    /// Where they are, and no corner of one is farther from there.
    pub whereabouts: ([f64; D], f64),
    /// Faces between them.
    pub faces: Vec<RootFace>,
    /// Their walls.
    pub walls: Vec<RootWall>,
    /// Their mirrors.
    pub mirrors: Vec<RootWall>,
}

impl<const D: usize> Root<D> {
    /// The same, knowing where its cells are.
    #[must_use]
    pub fn located(mut self) -> Self {
        let points = || self.cells.iter().map(|cell| Vector::from(cell.point));
        let count = self.cells.len().max(1) as f64;
        let middle = points().fold(Vector::zeros(), |sum, point| sum + point) / count;
        let away = |cell: &Plan<D>| (Vector::from(cell.point) - middle).norm() + cell.radius;
        let radius = self.cells.iter().map(away).fold(0.0, f64::max);
        self.whereabouts = (middle.into(), radius);
        self
    }

    /// True where none of its cells is nearer than this to the plane across a unit vector through the root.
    pub fn is_off(&self, normal: &[f64; D], distance: f64) -> bool {
        let (middle, radius) = &self.whereabouts;
        dot(middle, normal).abs() > radius + distance
    }

    /// True where none of its cells is nearer than this.
    pub fn is_beyond(&self, distance: f64) -> bool {
        let (middle, radius) = &self.whereabouts;
        dot(middle, middle).sqrt() > radius + distance
    }

    /// True of a tip.
    pub fn is_tip(&self) -> bool {
        self.bends.len() > 1
    }
}

impl<const D: usize> Plan<D> {
    /// Of a `cell` with its point and `pieces`, all as seen from the root, where these close; in the plane.
    pub fn new(cell: u32, point: Vector<D>, pieces: Vec<Piece<D>>) -> Option<Self> {
        /// What is left open, in parts of all around.
        const OPEN: f64 = 1e-6;
        let (mut open, mut around, mut radius) = (Vector::zeros(), 0.0, 0.0_f64);
        for piece in &pieces {
            open += Vector::from(piece.normal) * piece.size;
            around += piece.size;
            for end in &piece.corners {
                radius = radius.max((Vector::from(*end) - point).norm());
            }
        }
        let from = [0.0; D];
        (open.norm() < OPEN * around).then(|| Self {
            cell,
            point: point.into(),
            radius,
            volume: pieces
                .iter()
                .fold(0.0, |sum, piece| sum + piece.reach(&from)),
            pieces: pieces.into(),
        })
    }

    /// Number of a piece among its own.
    pub fn number(&self, piece: &Piece<D>) -> Option<u32> {
        let number = self.pieces.iter().position(|own| own == piece)?;
        Some(number as u32)
    }

    /// Where the corners of its pieces are seen from, as seen from the root.
    pub fn from(&self) -> [f64; D] {
        if D > 2 { self.point } else { [0.0; D] }
    }

    /// How far its point is from the root.
    pub fn away(&self) -> f64 {
        dot(&self.point, &self.point).sqrt()
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
        let from = self.from();
        let within = self.pieces.iter().fold(0.0, |within, piece| {
            within + piece.part(sector, &from) * piece.reach(&from)
        });
        let part = within / self.volume;
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

    /// A cube a unit wide around a point, as seen from the root.
    fn cube(point: [f64; 3]) -> Plan<3> {
        let corners: [Vector<3>; 4] =
            [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]].map(|[a, b]| [a, b, 0.5].into());
        let turned = |k: usize, sign: f64| {
            let place = |corner: &Vector<3>| {
                let mut place = Vector::<3>::zeros();
                place[k] = sign * corner[2];
                place[(k + 1) % 3] = corner[0];
                place[(k + 2) % 3] = sign * corner[1];
                place
            };
            let mut normal = Vector::<3>::zeros();
            normal[k] = sign;
            Piece::polygon(&normal, &corners.each_ref().map(place))
        };
        let pieces: Vec<Piece<3>> = (0..3)
            .flat_map(|k| [turned(k, 1.0), turned(k, -1.0)])
            .collect();
        Plan {
            cell: 0,
            point,
            radius: 0.75_f64.sqrt(),
            volume: 1.0,
            pieces: pieces.into(),
        }
    }

    /// Planes through an edge along the third axis part a cube as lines part its section, wherever it is along the edge.
    #[test]
    fn planes_through_an_edge_part_cells_by_volume() {
        let half = 0.5_f64.sqrt();
        let [rising, falling] = [[-half, half, 0.0], [half, half, 0.0]];
        let over = [0.0, 1.0, 0.0];
        for (point, sides, part) in [
            ([1.5, 1.5], [rising; 2], 0.5),
            ([1.5, 1.0], [rising; 2], 0.125),
            ([1.5, 3.0], [rising; 2], 1.0),
            ([3.5, 1.5], [rising; 2], 0.0),
            ([0.0, 0.0], [rising, falling], 0.25),
            ([0.25, 0.25], [rising, over], 0.468_75),
        ] {
            for along in [-4.0, 0.0, 0.3] {
                let [x, y] = point;
                let cube = cube([x, y, along]);
                assert_relative_eq!(cube.part(&Sector { sides }), part, epsilon = 1e-12);
            }
        }
    }

    #[test]
    fn an_outline_with_a_gap_is_none() {
        let mut pieces = rectangle([1.0, 1.0], [2.0, 2.0]).pieces.to_vec();
        pieces.pop();
        assert!(Plan::new(0, Vector::<2>::from([1.5, 1.5]), pieces).is_none());
    }
}
