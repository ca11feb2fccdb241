//! `frame-NNNNNN.vtp`: all particles at one time.

use std::path::Path;

use super::OutputError;
use super::vtp::Cloud;
use crate::frame::Frame;

/// Writes a snapshot of all particles.
pub fn write_frame(path: &Path, frame: &Frame) -> Result<(), OutputError> {
    Cloud::new(&frame.position)
        .vectors("velocity", &frame.velocity)
        .scalars("density", frame.density.clone())
        .scalars("pressure", frame.pressure.clone())
        .scalars("energy", frame.energy.clone())
        .scalars("mach", frame.mach.clone())
        .scalars("smoothing_length", frame.smoothing_length.clone())
        .scalars("kind", frame.kind.clone())
        .scalars("id", frame.id.clone())
        .write(path)
}
