//! How much finer thin and bent parts of a body are resolved than the flow.

use std::path::Path;

use aero::fly::Flight;
use aero::run::burst;
use aero::scene::Scene;

use super::super::CommandError;
use super::super::scene::checked;

/// Gives the body as many halvings of its own as make no more points, at the spacing of the look, than all of the box would hold if it had the
/// flow's finest `cells` everywhere: its share shrinks as spacings do.
///
/// # Errors
/// A scene that makes no sense; a flow that fails at once has the halvings that went before.
pub(super) fn resolve(flight: &mut Flight, look: f64, cells: f64) -> Result<(), CommandError> {
    let each = f64::from(1_u32 << flight.halvings()).powi(flight.dimension() as i32);
    while flight.come_closer() {
        let text = flight.scene(look, None).map_err(CommandError::wrong)?;
        let scene = Scene::parse(&text, &flight.name, Path::new(".")).map_err(CommandError::wrong)?;
        let points = burst(checked(&scene)?, 0.0).map(|seen| seen.gas as f64);
        if !points.is_ok_and(|points| points <= each * cells) {
            flight.stand_back();
            break;
        }
    }
    Ok(())
}
