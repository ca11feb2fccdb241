//! What is counted on the way.

use super::state::Conserved;

/// Time, steps and what they came to so far.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tally<const D: usize> {
    /// Time reached.
    pub time: f64,
    /// Steps, or iterations.
    pub steps: u64,
    /// Cells that were awake, step by step.
    pub updates: u64,
    /// What came in through walls and sides.
    pub received: Conserved<D>,
    /// Least density of all cells and steps.
    pub min_density: f64,
    /// Least specific internal energy.
    pub min_energy: f64,
}

impl<const D: usize> Default for Tally<D> {
    fn default() -> Self {
        Self {
            time: 0.0,
            steps: 0,
            updates: 0,
            received: Conserved::ZERO,
            min_density: f64::INFINITY,
            min_energy: f64::INFINITY,
        }
    }
}
