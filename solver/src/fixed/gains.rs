//! What cells gain.

use super::state::Conserved;

/// What the cells of a block gain per time.
#[derive(Clone, Debug)]
pub struct Gains<const D: usize> {
    /// Cell by cell.
    pub cells: Vec<Conserved<D>>,
    /// Through walls and sides, all cells.
    pub boundary: Conserved<D>,
}

impl<const D: usize> Gains<D> {
    /// Nothing, of so many cells.
    pub fn nothing(cells: usize) -> Self {
        Self {
            cells: vec![Conserved::ZERO; cells],
            boundary: Conserved::ZERO,
        }
    }
}
