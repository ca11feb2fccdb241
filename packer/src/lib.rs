//! Shape in, packed layers of ghost particles with normals out. No gas dynamics.

mod ghosts;
mod options;
mod report;

pub use ghosts::Ghosts;
pub use options::PackOptions;
pub use report::PackReport;
