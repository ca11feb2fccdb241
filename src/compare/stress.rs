//! Flows on which particle methods and finite volumes are known to fail, each against an exact or
//! agreed answer.
//!
//! A run that stops is a row that fails, not the end of the comparison: the table is there to show
//! where the method ends.

mod base;
mod bodies;
mod edge;
mod fins;
mod line;
mod plate;
mod radial;
mod schemes;
mod slab;
mod smooth;
mod trial;
mod tubes;

use aero_validation::table::Check;

use super::comparison::Compare;
use super::context::{CompareError, Context};

/// One family of flows of the suite.
pub struct Family(fn(&Context<'_>) -> Result<Vec<Check>, CompareError>);

impl Compare for Family {
    fn compare(&self, context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
        (self.0)(context)
    }
}

/// The flows along a line.
pub const TUBES: Family = Family(|context| {
    let mut checks = line::compare(context)?;
    checks.extend(line::convergence(context)?);
    Ok(checks)
});

/// The implosions and explosions.
pub const BALLS: Family = Family(radial::compare);

/// The flows without shocks.
pub const SMOOTH: Family = Family(smooth::compare);

/// The flows around bodies.
pub const BODIES: Family = Family(bodies::compare);

/// Thin plates in space.
pub const SLABS: Family = Family(slab::compare);

/// Thin fins on a body in space.
pub const FINS: Family = Family(fins::compare);
