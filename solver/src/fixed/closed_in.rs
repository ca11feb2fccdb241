//! Gas that nothing lets in or out, on its way to a steady flow.
//!
//! Cells go there by steps of their own, whose changes do not add up to nothing over all cells: the gas would come to rest with another mass than it
//! began with, and at another pressure.

use super::FixedSimulation;
use super::state::Conserved;
use crate::Failure;
use crate::problem::Side;

impl<const D: usize> FixedSimulation<D> {
    /// Looks what mass closed-in gas begins with.
    pub(super) fn remember_mass(&mut self) {
        if self.settling.mass.is_none() && self.is_closed_in() {
            self.settling.mass = Some(self.mass_and_centre().0);
        }
    }

    /// Gives closed-in gas the mass that it began with: each cell as much more of all that it holds, so that speeds and temperatures stay.
    ///
    /// # Errors
    /// A [`Failure`] where a cell's state makes no sense any more.
    pub(super) fn keep_mass(&mut self) -> Result<(), Failure> {
        let Some(first) = self.settling.mass else {
            return Ok(());
        };
        let (mass, _) = self.mass_and_centre();
        for held in &mut self.columns.held {
            *held = Conserved::ZERO.plus(first / mass, held);
        }
        self.find_states().map_err(|bad| self.failure(bad[0]))
    }

    /// True where no side lets gas in or out and no source adds any.
    fn is_closed_in(&self) -> bool {
        let source = self.problem.source.as_ref();
        let is_sealed = source.is_none_or(|source| source.keeps_mass());
        is_sealed && !self.problem.domain.has(Side::is_open)
    }
}
