//! `frame-NNNNNN.vtp`: all particles at one time.

use std::path::Path;

use super::error::OutputError;
use super::vtp::Cloud;
use aero_solver::frame::Frame;

/// Writes a snapshot of all particles, compressed if so wished.
pub fn write_frame(path: &Path, frame: &Frame, is_compressed: bool) -> Result<(), OutputError> {
    let mut cloud = Cloud::new(&frame.position)
        .vectors("velocity", &frame.velocity)
        .scalars("density", &frame.density[..])
        .scalars("pressure", &frame.pressure[..])
        .scalars("energy", &frame.energy[..])
        .scalars("mach", &frame.mach[..])
        .scalars("smoothing_length", &frame.smoothing_length[..])
        .scalars("volume", &frame.volume[..]);
    if !frame.spacing.is_empty() {
        cloud = cloud.scalars("spacing", &frame.spacing[..]);
    }
    cloud
        .scalars("kind", &frame.kind[..])
        .scalars("id", &frame.id[..])
        .compressed(is_compressed)
        .write(path)
}
