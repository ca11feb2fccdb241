//! Inlets and free-stream sides: gas enters in the undisturbed state, whatever the flow inside [Lastiwka et al.
//! 2009]; a free-stream side is one that the flow inside does not reach.

use super::model::OpenModel;
use crate::problem::{Problem, State};

/// A side that the free stream is beyond.
#[derive(Clone, Copy, Debug)]
pub struct Inlet;

impl<const D: usize> OpenModel<D> for Inlet {
    fn inflow(&self, problem: &Problem<D>) -> Option<State<D>> {
        Some(problem.free_stream)
    }
}
