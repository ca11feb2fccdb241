//! `frame-NNNNNN.vtp`: all particles at one time.

use std::path::Path;

use super::error::OutputError;
use super::reference::Reference;
use super::vtp::Cloud;
use aero_solver::frame::Frame;

/// Writes a snapshot of all particles, with what follows from their state by `reference`, compressed if so wished.
pub fn write_frame(
    path: &Path,
    frame: &Frame,
    reference: Option<&Reference>,
    is_compressed: bool,
) -> Result<(), OutputError> {
    let Frame {
        density, pressure, ..
    } = frame;
    let mut cloud = Cloud::new(&frame.position)
        .vectors("velocity", &frame.velocity)
        .scalars("density", &frame.density[..])
        .scalars("pressure", &frame.pressure[..])
        .scalars("energy", &frame.energy[..])
        .scalars("mach", &frame.mach[..])
        .scalars("smoothing_length", &frame.smoothing_length[..])
        .scalars("volume", &frame.volume[..]);
    let masses = density.iter().zip(&frame.volume);
    let masses: Vec<f64> = masses.map(|(density, volume)| density * volume).collect();
    cloud = cloud.scalars("mass", &masses[..]);
    if let Some(reference) = reference {
        cloud = cloud.scalars("entropy", &reference.entropies(pressure, density)[..]);
        if let Some(temperatures) = reference.temperatures(pressure, density) {
            cloud = cloud.scalars("temperature", &temperatures[..]);
        }
    }
    if !frame.spacing.is_empty() {
        cloud = cloud.scalars("spacing", &frame.spacing[..]);
    }
    cloud
        .scalars("kind", &frame.kind[..])
        .scalars("id", &frame.id[..])
        .compressed(is_compressed)
        .write(path)
}
