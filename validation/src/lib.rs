//! Exact solutions, metrics, tables and charts. Takes plain arrays and shares no code with the
//! solver, which keeps the check independent.
//!
//! - [`exact`]: solutions of the Euler equations to compare with, one file each.
//! - [`metrics`]: numbers read off particles, one file each.
//! - [`pictures`]: particles, curves and charts as PNG or SVG.
//! - [`reference`]: the small tables that lie in the case folders beside this crate.
//! - [`table`]: comparisons with a verdict, as text, Markdown and JSON.

pub mod exact;
pub mod metrics;
pub mod pictures;
pub mod reference;
pub mod table;
