//! `surface-NNNNNN.vtp`: pressure on the bodies at one time.

use std::path::Path;

use super::error::OutputError;
use super::vtp::Cloud;
use aero_solver::frame::SurfaceFrame;

/// Writes the state on the surfaces.
pub fn write_surface(path: &Path, surface: &SurfaceFrame) -> Result<(), OutputError> {
    Cloud::new(&surface.position)
        .vectors("normal", &surface.normal)
        .scalars("pressure", &surface.pressure[..])
        .scalars("pressure_coefficient", &surface.pressure_coefficient[..])
        .scalars("body", &surface.body[..])
        .write(path)
}
