//! Places of a lattice that fills a box.

use aero_geometry::{Bounds, Vector};

/// Points of a lattice, on the faces of its box too.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lattice<const D: usize> {
    /// Lowest corner.
    pub origin: Vector<D>,
    /// Distance between points along each axis.
    pub spacing: Vector<D>,
    /// Cells along each axis: one less than points.
    pub cells: [usize; D],
}

impl<const D: usize> Lattice<D> {
    /// The lattice that fills `region` with about `spacing` between points, as many as fit evenly.
    pub fn new(region: &Bounds<D>, spacing: f64) -> Self {
        let size = region.size();
        let cells: [usize; D] =
            std::array::from_fn(|k| ((size[k] / spacing).round() as usize).max(1));
        Self {
            origin: region.min,
            spacing: Vector::from_fn(|k, _| size[k] / cells[k] as f64),
            cells,
        }
    }

    /// The middles of equal parts of `region`, each about `spacing` wide; one part along an axis without width.
    pub fn middles(region: &Bounds<D>, spacing: f64) -> Self {
        let size = region.size();
        let parts: [usize; D] =
            std::array::from_fn(|k| ((size[k] / spacing).round() as usize).max(1));
        let spacing = Vector::from_fn(|k, _| size[k] / parts[k] as f64);
        Self {
            origin: region.min + spacing * 0.5,
            spacing,
            cells: parts.map(|n| n - 1),
        }
    }

    /// Number of points.
    pub fn count(&self) -> usize {
        self.cells.iter().map(|n| n + 1).product()
    }

    /// Place of a point, counted along the first axis first.
    pub fn place(&self, mut number: usize) -> Vector<D> {
        Vector::from_fn(|k, _| {
            let points = self.cells[k] + 1;
            let along = number % points;
            number /= points;
            self.origin[k] + along as f64 * self.spacing[k]
        })
    }
}
