//! Outlets: what crosses keeps its state, drifts on at its own velocity and is removed past the buffer [Federico et al. 2012].

use super::model::OpenModel;
use crate::problem::{Problem, State};

/// A side that gas leaves through, with its state frozen.
#[derive(Clone, Copy, Debug)]
pub struct Outlet;

impl<const D: usize> OpenModel<D> for Outlet {
    fn inflow(&self, _problem: &Problem<D>) -> Option<State<D>> {
        None
    }
}
