//! How the state changes across a cell.

use super::state::Primitive;

/// Gradients in a cell, and what else its faces ask.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct Slopes<const D: usize> {
    /// Derivative of each variable along each axis.
    pub along: [Primitive<D>; D],
    /// Least ratio of the pressures of the cell and a neighbour, the lower one over the higher; [`Slopes::CAREFUL`] where the cell is
    /// to be flown in first order.
    pub calmness: f64,
}

impl<const D: usize> Slopes<D> {
    /// In place of a ratio of pressures: no slopes on any face of this cell, and the most dissipative flux.
    pub const CAREFUL: f64 = -1.0;

    /// Of gas that is the same all around.
    pub const LEVEL: Self = Self {
        along: [Primitive::ZERO; D],
        calmness: 1.0,
    };
}

/// States and slopes of all cells.
#[derive(Clone, Copy, Debug)]
pub struct Flow<'a, const D: usize> {
    /// State of each cell.
    pub states: &'a [Primitive<D>],
    /// Slopes of each cell.
    pub slopes: &'a [Slopes<D>],
}
