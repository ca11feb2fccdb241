//! The narrow band: square cells near the surface, found by descending from one big cell.

use aero_geometry::parallel::prelude::*;
use aero_geometry::{Bounds, Shape, Vector};

use crate::PackError;
use crate::options::MAX_PARTICLES;
use crate::room::{Probe, Room, Side};
use crate::room_across::room_across;
use crate::room_inside::room_inside;

/// A distance that differs from the expected one by this part of the cell's edge tells of a ridge.
const RIDGE: f64 = 0.05;

/// A lattice of cubes; cell `i` spans `origin + i step ..= origin + (i + 1) step`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Grid<const D: usize> {
    /// Lowest corner of cell zero.
    pub origin: Vector<D>,
    /// Edge length of a cell.
    pub step: f64,
}

/// One cell of the band.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cell<const D: usize> {
    /// Place in the grid; that of the whole cell if this is a part of one.
    pub index: [i64; D],
    /// Centre.
    pub centre: Vector<D>,
    /// Edge length.
    pub step: f64,
    /// Signed distance at the centre.
    pub distance: f64,
    /// Gradient of the signed distance at the centre.
    pub normal: Vector<D>,
    /// How much room the layer at the centre has here.
    pub room: Room,
    /// Number of layers that have room here; deeper parts of the cell are too thin.
    pub full: usize,
    /// True where the cell straddles the face between two layers and a ridge of the distance, so
    /// that the face is not a plane in it.
    pub on_ridge: bool,
}

impl<const D: usize> Grid<D> {
    /// Centre of a cell.
    pub fn centre(&self, index: &[i64; D]) -> Vector<D> {
        Vector::from_fn(|k, _| self.origin[k] + (index[k] as f64 + 0.5) * self.step)
    }

    /// The cell that a place lies in.
    pub fn index(&self, place: &Vector<D>) -> [i64; D] {
        std::array::from_fn(|k| cell_number(place[k] - self.origin[k], self.step))
    }

    /// Lowest corner of a cell.
    pub fn corner(&self, index: &[i64; D]) -> Vector<D> {
        Vector::from_fn(|k, _| self.origin[k] + index[k] as f64 * self.step)
    }

    /// All cells with centres in `bounds` that a signed distance in `low..=high` may cross, in a
    /// fixed order, and the volume of the cells in `bounds` that are below. A block is dropped once its centre is too far for any point in it, for the
    /// distance changes by no more than the way travelled.
    pub fn band(
        &self,
        shape: &dyn Shape<D>,
        bounds: &Bounds<D>,
        (low, high): (f64, f64),
        spacing: f64,
    ) -> Result<(Vec<Cell<D>>, f64), PackError> {
        let first: [i64; D] =
            std::array::from_fn(|k| cell_number(bounds.min[k] - self.origin[k], self.step));
        let end: [i64; D] = std::array::from_fn(|k| {
            -cell_number(self.origin[k] - bounds.max[k], self.step).min(-first[k] - 1)
        });
        let longest = (0..D).map(|k| end[k] - first[k]).max().unwrap_or(1);
        let mut size = u64::try_from(longest).unwrap_or(1).next_power_of_two() as i64;
        let mut blocks = vec![first];
        let reach = |size: i64| 0.5 * size as f64 * self.step * (D as f64).sqrt() + 1e-9 * spacing;
        let near = |distance: f64, reach: f64| distance > low - reach && distance < high + reach;
        let mut below = 0.0;
        while size > 2 {
            size /= 2;
            let parts: Vec<([i64; D], f64)> = blocks
                .par_iter()
                .flat_map_iter(|block| children(block, size, &end))
                .map(|block| {
                    let half = 0.5 * size as f64;
                    let centre = Vector::from_fn(|k, _| {
                        self.origin[k] + (block[k] as f64 + half) * self.step
                    });
                    (block, shape.signed_distance(&centre))
                })
                .collect();
            let width = size as f64 * self.step;
            let dropped = parts.iter().filter(|part| part.1 <= low - reach(size));
            below += dropped
                .map(|(block, _)| volume_in(bounds, &self.corner(block), width))
                .sum::<f64>();
            blocks = parts
                .into_iter()
                .filter(|part| near(part.1, reach(size)))
                .map(|part| part.0)
                .collect();
            let width = size as f64 * self.step / spacing;
            let deep = width.min((high - low) / spacing);
            let estimate = 0.5 * blocks.len() as f64 * width.powi(D as i32 - 1) * deep;
            if estimate > MAX_PARTICLES {
                return Err(PackError::TooMany {
                    spacing,
                    estimate,
                    limit: MAX_PARTICLES,
                });
            }
        }
        let cells: Vec<Cell<D>> = blocks
            .par_iter()
            .flat_map_iter(|block| {
                children(block, 1, &end).take(if size == 1 { 1 } else { 1 << D })
            })
            .map(|index| Cell::new(shape, index, self.centre(&index), self.step))
            .collect();
        let dropped = cells.iter().filter(|cell| cell.distance <= low - reach(1));
        below += dropped
            .map(|cell| volume_in(bounds, &self.corner(&cell.index), self.step))
            .sum::<f64>();
        let kept = cells
            .into_iter()
            .filter(|cell| near(cell.distance, reach(1)));
        Ok((kept.collect(), below))
    }
}

/// Volume of the part of a cube in a box.
pub(crate) fn volume_in<const D: usize>(bounds: &Bounds<D>, corner: &Vector<D>, width: f64) -> f64 {
    let cube = Bounds::new(*corner, corner.add_scalar(width)).intersection(bounds);
    cube.size().iter().map(|edge| edge.max(0.0)).product()
}

/// Number of the cell that a length reaches, forgiving round-off at cell faces.
fn cell_number(length: f64, step: f64) -> i64 {
    (length / step + 1e-6).floor() as i64
}

/// The halves per axis of a block that begin before `end`.
fn children<const D: usize>(
    block: &[i64; D],
    size: i64,
    end: &[i64; D],
) -> impl Iterator<Item = [i64; D]> + use<D> {
    let (block, end) = (*block, *end);
    (0..1_usize << D)
        .map(move |n| std::array::from_fn(|k| block[k] + size * ((n >> k) & 1) as i64))
        .filter(move |child: &[i64; D]| (0..D).all(|k| child[k] < end[k]))
}

impl<const D: usize> Cell<D> {
    /// A cell whose room has not been looked at.
    fn new(shape: &dyn Shape<D>, index: [i64; D], centre: Vector<D>, step: f64) -> Self {
        let closest = shape.closest(&centre);
        Self {
            index,
            centre,
            step,
            distance: closest.distance,
            normal: closest.normal,
            room: Room::Clear,
            full: usize::MAX,
            on_ridge: false,
        }
    }

    /// Looks at the room for layers in the cell and at ridges.
    pub fn survey(&mut self, shape: &dyn Shape<D>, spacing: f64, side: Side) {
        let probe = Probe {
            centre: self.centre,
            step: self.step,
            distance: self.distance,
            normal: self.normal,
        };
        (self.room, self.full) = if side == Side::Ghosts {
            room_inside(shape, &probe, spacing)
        } else {
            room_across(shape, &probe, spacing)
        };
        self.on_ridge = self.room != Room::Clear && self.crosses_ridge(shape, spacing);
    }

    /// The cell cut into halves per axis, each surveyed by itself.
    pub fn halves(
        &self,
        shape: &dyn Shape<D>,
        spacing: f64,
        side: Side,
    ) -> impl Iterator<Item = Self> {
        self.parts(shape, spacing).map(move |mut half| {
            half.survey(shape, spacing, side);
            half
        })
    }

    /// The cell cut into halves per axis that have room for as many layers.
    pub fn parts(&self, shape: &dyn Shape<D>, spacing: f64) -> impl Iterator<Item = Self> {
        (0..1_usize << D).map(move |n| {
            let quarter = 0.25 * self.step;
            let centre = Vector::from_fn(|k, _| {
                self.centre[k] + if n >> k & 1 == 1 { quarter } else { -quarter }
            });
            let part = Self::new(shape, self.index, centre, 0.5 * self.step);
            let layer = (-part.distance / spacing).max(0.0) as usize;
            Self {
                room: if layer >= self.full {
                    Room::Thin
                } else {
                    Room::Ridge
                },
                full: self.full,
                ..part
            }
        })
    }

    /// True where the surface, or the face between two layers, that the cell straddles is not a plane as far as the cell sees it.
    pub fn is_bent(&self, shape: &dyn Shape<D>) -> bool {
        let reach = 0.5 * self.step * self.normal.abs().sum();
        self.distance.abs() < reach && {
            let end = self.distance - reach;
            let there = shape.signed_distance(&(self.centre - reach * self.normal));
            (there - end).abs() > RIDGE * self.step
        }
    }

    /// True where the cell straddles the face between two layers and a ridge of the distance.
    fn crosses_ridge(&self, shape: &dyn Shape<D>, spacing: f64) -> bool {
        let face = (self.distance / spacing).round() * spacing;
        let reach = 0.5 * self.step * self.normal.abs().sum();
        let away = reach.copysign(self.distance);
        face != 0.0 && (face - self.distance).abs() < reach && {
            let end = shape.signed_distance(&(self.centre + away * self.normal));
            (end - self.distance - away).abs() > RIDGE * self.step
        }
    }

    /// Part of the cell where the signed distance is below `level`; exact where the surface is
    /// flat.
    pub fn fraction_below(&self, level: f64) -> f64 {
        if self.on_ridge {
            return if self.distance < level { 1.0 } else { 0.0 };
        }
        let slopes: [f64; D] = std::array::from_fn(|k| self.normal[k].abs().max(1e-3));
        let total: f64 = slopes.iter().sum();
        let reach = (level - self.distance) / self.step + 0.5 * total;
        if reach <= 0.0 {
            return 0.0;
        }
        if reach >= total {
            return 1.0;
        }
        // Volume of the unit cube below a plane: inclusion and exclusion over its corners
        // (Scardovelli & Zaleski 2000, J. Comput. Phys. 164, eq. 4).
        let mut sum = 0.0;
        for corner in 0..1_usize << D {
            let cut: f64 = (0..D)
                .filter(|k| corner >> k & 1 == 1)
                .map(|k| slopes[k])
                .sum();
            let sign = if corner.count_ones() % 2 == 0 {
                1.0
            } else {
                -1.0
            };
            sum += sign * (reach - cut).max(0.0).powi(D as i32);
        }
        let factorial = if D == 2 { 2.0 } else { 6.0 };
        (sum / (factorial * slopes.iter().product::<f64>())).clamp(0.0, 1.0)
    }
}
