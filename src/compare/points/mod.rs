//! Points and what is read off them, shared by what is compared in schemes of its own: nothing of it is in the solver.

pub mod cloud;
pub mod weights;
