//! `surface-NNNNNN.vtp`: the surfaces and the pressure on them at one time.

use std::path::Path;

use super::error::OutputError;
use super::reference::Reference;
use super::vtp::Cloud;
use aero_solver::frame::PanelFrame;

/// Writes the surfaces; the force on each body is the sum of `(friction - pressure normal) area` over its cells.
pub fn write_surface(
    path: &Path,
    surface: &PanelFrame,
    reference: &Reference,
    is_compressed: bool,
) -> Result<(), OutputError> {
    let told = reference.told(surface.time, is_compressed);
    let mut cloud = Cloud::of_cells(surface.corners, &surface.points, &told)
        .vectors("normal", &surface.normal)
        .scalars("pressure", &surface.pressure[..])
        .scalars("pressure_coefficient", &surface.pressure_coefficient[..])
        .vectors("friction", &surface.friction)
        .scalars("mach", &surface.mach[..])
        .scalars("area", &surface.area[..])
        .scalars("body", &surface.body[..]);
    if !surface.heat.flux.is_empty() {
        cloud = cloud.scalars("heat_flux", &surface.heat.flux[..]);
        if reference.gas_constant.is_some() {
            cloud = cloud.scalars("temperature", &surface.heat.temperature[..]);
        }
    }
    cloud.write(path)
}
