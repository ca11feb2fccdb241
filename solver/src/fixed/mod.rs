//! Points that stay in place, and the cells that are derived from them.

pub mod build;
pub mod cells;
pub mod cloud;
mod cut;
pub mod levels;
mod merge;
mod nearby;
mod polytope;
mod section;
pub mod solids;
#[cfg(test)]
mod tests;
mod voronoi;
