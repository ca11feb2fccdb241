//! Flows with known answers on cells made by hand.

pub(crate) mod lattice;
mod tubes;
