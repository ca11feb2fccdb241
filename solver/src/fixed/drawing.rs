//! How states are drawn out from the cells to the faces.

use crate::problem::Problem;

/// The ways.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Drawing {
    /// By slopes of second order that come to rest: of flows that settle.
    Rest,
    /// The same, and of third order where gas is smooth and cells are even, over crests and troughs too: waves go far.
    Waves,
    /// Layers as finely as they can be: gas meets in the middle of each face, also where that is not halfway between the cells, temperatures are
    /// straight across a cell rather than densities, and slopes are of third order.
    Layers,
}

/// That of a problem, whose flow may have begun to settle though it was to march.
pub fn drawing<const D: usize>(problem: &Problem<D>, has_begun_to_settle: bool) -> Drawing {
    if problem.gas.is_viscous() {
        Drawing::Layers
    } else if has_begun_to_settle || problem.method.settles() {
        Drawing::Rest
    } else {
        Drawing::Waves
    }
}
