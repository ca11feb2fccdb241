//! Flows with known answers on cells made by hand.

mod lattice;
mod tubes;
