//! `frame-NNNNNN.vtp`: the gas at one time; `ghosts-NNNNNN.vtp`: what else the solver carries.

use std::path::Path;

use super::error::OutputError;
use super::reference::Reference;
use super::vtk_xml::Told;
use super::vtp::Cloud;
use aero_solver::frame::Frame;

/// Writes a snapshot of particles, with what follows from their state by `reference` and with the `gradients` of the density unless there are
/// none, compressed if so wished. Nobody needs the `frame` afterwards: what is in the file is given up, so that a frame takes its own memory once.
pub fn write_frame(
    path: &Path,
    mut frame: Frame,
    gradients: &[[f64; 3]],
    reference: Option<&Reference>,
    is_compressed: bool,
) -> Result<(), OutputError> {
    let told = reference.map_or_else(
        || Told {
            is_compressed,
            ..Told::default()
        },
        |reference| reference.told(frame.time, is_compressed),
    );
    let mut cloud = Cloud::new(&frame.position, &told);
    frame.position = Vec::new();
    cloud = cloud.vectors("velocity", &frame.velocity);
    frame.velocity = Vec::new();
    cloud = cloud
        .scalars("density", &frame.density[..])
        .scalars("pressure", &frame.pressure[..])
        .scalars("energy", &frame.energy[..])
        .scalars("mach", &frame.mach[..])
        .scalars("smoothing_length", &frame.smoothing_length[..])
        .scalars("volume", &frame.volume[..]);
    for given_up in [
        &mut frame.energy,
        &mut frame.mach,
        &mut frame.smoothing_length,
    ] {
        *given_up = Vec::new();
    }
    let masses = frame.density.iter().zip(&frame.volume);
    let masses: Vec<f64> = masses.map(|(density, volume)| density * volume).collect();
    cloud = cloud.scalars("mass", &masses[..]);
    drop(masses);
    frame.volume = Vec::new();
    if let Some(reference) = reference {
        cloud = cloud.scalars("entropy", &reference.entropies(&frame)[..]);
        if let Some(temperatures) = reference.temperatures(&frame) {
            cloud = cloud.scalars("temperature", &temperatures[..]);
        }
    }
    (frame.density, frame.pressure) = (Vec::new(), Vec::new());
    if !gradients.is_empty() {
        cloud = cloud.vectors("density_gradient", gradients);
    }
    if !frame.extra.second.is_empty() {
        cloud = cloud.scalars("second_gas", &frame.extra.second[..]);
    }
    if !frame.extra.spacing.is_empty() {
        cloud = cloud.scalars("spacing", &frame.extra.spacing[..]);
    }
    let ids: Vec<i64> = frame.id.iter().map(|&id| id as i64).collect();
    cloud
        .scalars("kind", &frame.kind[..])
        .scalars("id", &ids[..])
        .write(path)
}
