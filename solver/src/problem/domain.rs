//! The box of the flow and what bounds it, as a problem states it.

use aero_geometry::Bounds;

use super::side::Side;

/// Box of the flow and its sides.
#[derive(Clone, Debug)]
pub struct Domain<const D: usize> {
    /// The box in which particles are fluid.
    pub bounds: Bounds<D>,
    /// `[lower, upper]` side per axis.
    pub sides: [[Side; 2]; D],
}

impl<const D: usize> Domain<D> {
    /// True where one side is the axis of an axisymmetric flow.
    pub fn is_axisymmetric(&self) -> bool {
        self.has(|side| side == Side::Axis)
    }

    /// True where any side is as `is_sought` says.
    pub fn has(&self, is_sought: impl Fn(Side) -> bool) -> bool {
        self.sides.iter().flatten().any(|side| is_sought(*side))
    }

    /// The face of side `end`, 0 the lower and 1 the upper one, of `axis`.
    pub fn face(&self, axis: usize, end: usize) -> f64 {
        let corner = if end == 0 {
            &self.bounds.min
        } else {
            &self.bounds.max
        };
        corner[axis]
    }

    /// Axis, end, kind and face of every side.
    pub fn each_side(&self) -> impl Iterator<Item = (usize, usize, Side, f64)> {
        let ends = (0..D).flat_map(|axis| [(axis, 0), (axis, 1)]);
        ends.map(|(axis, end)| (axis, end, self.sides[axis][end], self.face(axis, end)))
    }
}
