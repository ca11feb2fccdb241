//! Viscous flows with exact solutions: heated shear, a channel, the inside of a shock, vortices that decay, the boundary layer of a plate, wakes; and flows that were
//! measured: gas behind a step, heat into a nose.

mod channel;
mod cylinder;
mod nose;
mod particles;
mod plate;
mod reattachment;
mod shear;
mod shock;
mod vortices;
mod wake;

use aero_validation::table::Check;

use super::comparison::Compare;
use super::context::{CompareError, Context, Level};

const NAME: &str = "viscous";
const GAMMA: f64 = 1.4;
/// J/(kg K), as in the scenes.
const GAS_CONSTANT: f64 = 287.05;

/// Flows of points that stay, and of particles.
pub struct Viscous;

impl Compare for Viscous {
    fn compare(&self, context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
        let mut checks = shear::compare(context)?;
        checks.extend(shock::compare(context)?);
        checks.extend(vortices::compare(context)?);
        checks.extend(particles::compare(context)?);
        checks.extend(channel::compare(context)?);
        checks.extend(cylinder::compare(context)?);
        if context.level == Level::Full {
            checks.extend(plate::compare(context)?);
            checks.extend(reattachment::compare(context)?);
            checks.extend(nose::compare(context)?);
            checks.extend(wake::compare(context)?);
        }
        Ok(checks)
    }
}
