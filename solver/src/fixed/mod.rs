//! Points that stay in place, and the cells that are derived from them.

pub mod build;
pub mod carry;
pub mod cells;
pub mod cloud;
mod cut;
pub mod levels;
mod merge;
mod nearby;
mod polytope;
pub mod refine;
mod section;
pub mod solids;
#[cfg(test)]
mod tests;
mod voronoi;
