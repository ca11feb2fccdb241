//! Pieces of the outline of a cell, and what of each lies between two lines, in space two planes, through a place.

use aero_geometry::Vector;

use super::bend::turned;
use super::polytope::cross;
use super::state::dot;

/// A piece that is no farther from a plane than this, in parts of its size, lies in it: on neither side.
const ROUNDING: f64 = 1e-9;

/// No piece has more corners than this, those included that two planes make of it.
pub const CORNERS: usize = 24;

/// A straight piece of the outline of a cell, in space a plane one of its surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece<const D: usize> {
    /// Unit normal, out of the cell.
    pub normal: [f64; D],
    /// Both ends; in space all corners, counter-clockwise as seen from outside.
    pub corners: Box<[[f64; D]]>,
    /// Its length, in space its area.
    pub size: f64,
}

/// The part of the plane between a shock and the wall behind it: what lies on one side of both of two lines through the root; in space of two planes.
#[derive(Clone, Copy, Debug)]
pub struct Sector<const D: usize> {
    /// Normals of both, into it. Twice the same where it is all that one of them bounds.
    pub sides: [[f64; D]; 2],
}

impl<const D: usize> Piece<D> {
    /// Of this `length` around a `middle`, in the plane.
    pub fn new(middle: &Vector<D>, normal: &Vector<D>, length: f64) -> Self {
        let half = turned(normal) * (0.5 * length);
        let ends = [middle - half, middle + half];
        Self {
            normal: (*normal).into(),
            size: (ends[1] - ends[0]).norm(),
            corners: ends.map(Into::into).into(),
        }
    }

    /// A polygon across a `normal` through these corners, in space.
    pub fn polygon(normal: &Vector<D>, corners: &[Vector<D>]) -> Self {
        let corners: Box<[[f64; D]]> = corners.iter().map(|&corner| corner.into()).collect();
        let normal = (*normal).into();
        Self {
            size: area(&corners, &normal),
            normal,
            corners,
        }
    }

    /// The part of it that is in a `sector`, where its corners are seen `from` there.
    pub fn part(&self, sector: &Sector<D>, from: &[f64; D]) -> f64 {
        if D > 2 {
            return self.part_in_space(sector, from);
        }
        let ends = [0, 1].map(|k| sum(&self.corners[k], from));
        let least = ROUNDING * self.size;
        let (mut from, mut to) = (0.0_f64, 1.0_f64);
        for normal in sector.sides {
            let [start, end] = ends.map(|end| dot(&end, &normal));
            match (start > least, end > least) {
                (true, true) => {}
                (false, false) => return 0.0,
                (true, false) => to = to.min(start / (start - end)),
                (false, true) => from = from.max(start / (start - end)),
            }
        }
        (to - from).max(0.0)
    }

    fn part_in_space(&self, sector: &Sector<D>, from: &[f64; D]) -> f64 {
        let heights = sector.sides.map(|normal| {
            let heights = self.corners.iter().map(|corner| dot(corner, &normal));
            let ends = heights.fold([f64::INFINITY, -f64::INFINITY], |[low, high], height| {
                [low.min(height), high.max(height)]
            });
            ends.map(|end| end + dot(from, &normal))
        });
        let rounding = ROUNDING * self.size.sqrt();
        if heights.iter().any(|[_, high]| *high <= rounding) {
            return 0.0;
        }
        if heights.iter().all(|[low, _]| *low >= 0.0) {
            return 1.0;
        }
        let (mut corners, mut count) = ([[0.0; D]; CORNERS], self.corners.len());
        for (place, corner) in corners.iter_mut().zip(&*self.corners) {
            *place = sum(corner, from);
        }
        for normal in &sector.sides {
            (corners, count) = clipped(&corners[..count], normal);
        }
        (area(&corners[..count], &self.normal) / self.size).clamp(0.0, 1.0)
    }

    /// Area between the root and the piece, whose corners are seen `from` there, in space the volume: more where it looks away from the root and less
    /// where it looks there.
    pub fn reach(&self, from: &[f64; D]) -> f64 {
        let away = dot(&sum(&self.corners[0], from), &self.normal);
        away * self.size / D as f64
    }
}

fn sum<const D: usize>(a: &[f64; D], b: &[f64; D]) -> [f64; D] {
    std::array::from_fn(|k| a[k] + b[k])
}

/// What of a convex polygon lies on that side of a plane through the root to which its `normal` points, and how many corners that has
/// [Sutherland & Hodgman 1974, doi:10.1145/360767.360802].
fn clipped<const D: usize>(
    corners: &[[f64; D]],
    normal: &[f64; D],
) -> ([[f64; D]; CORNERS], usize) {
    let (mut kept, mut count) = ([[0.0; D]; CORNERS], 0);
    for (k, start) in corners.iter().enumerate() {
        let end = &corners[(k + 1) % corners.len()];
        let [a, b] = [start, end].map(|corner| dot(corner, normal));
        if a > 0.0 {
            kept[count] = *start;
            count += 1;
        }
        if (a > 0.0) != (b > 0.0) {
            let part = a / (a - b);
            kept[count] = std::array::from_fn(|k| start[k] + part * (end[k] - start[k]));
            count += 1;
        }
    }
    (kept, count)
}

/// Area of a polygon across this `normal`.
fn area<const D: usize>(corners: &[[f64; D]], normal: &[f64; D]) -> f64 {
    let Some((first, rest)) = corners.split_first() else {
        return 0.0;
    };
    let arm = |corner: &[f64; D]| Vector::from(*corner) - Vector::from(*first);
    let doubled = rest.windows(2).fold(Vector::<D>::zeros(), |sum, pair| {
        sum + cross(&arm(&pair[0]), &arm(&pair[1]))
    });
    0.5 * doubled.dot(&Vector::from(*normal))
}
