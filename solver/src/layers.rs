//! How deep the domain is lined with particles that do not move by the equations.

/// Layers of ghosts behind a wall, a spacing apart: the support at `h = 1.5 dx`, rounded up [Villodi & Ramachandran 2024,
/// section 4].
pub const GHOSTS: usize = 5;

/// Layers in the buffer of an open side: the support at `h = 1.5 dx` and what a step moves, rounded up.
pub const BUFFER: usize = 6;
