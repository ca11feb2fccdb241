//! Compressible flow around real bodies without a mesh.

pub mod case;
pub mod frame;
pub mod solver;
