//! Compressible flow around real bodies without a mesh.

pub mod case;
pub mod chart;
pub mod output;
pub mod pack;
pub mod run;
pub mod scene;
pub mod validate;
