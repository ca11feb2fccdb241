//! Liquids: waves by the exact Riemann problem, and flows that are all but incompressible by each scheme.

mod cavity;
mod shear;
mod tube;
mod vortices;

use aero_validation::table::Check;

use super::comparison::Compare;
use super::context::{CompareError, Context, Level};

const NAME: &str = "weakly-compressible";

/// The schemes of liquids.
const SCHEMES: [&str; 5] = ["L-IPST-C", "PE-IPST-C", "TV-C", "E-C", "EDAC"];

/// Liquids by particles.
pub struct WeaklyCompressible;

impl Compare for WeaklyCompressible {
    fn compare(&self, context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
        let mut checks = tube::compare(context)?;
        checks.extend(vortices::compare(context)?);
        checks.extend(shear::compare(context)?);
        if context.level == Level::Full {
            checks.extend(cavity::compare(context)?);
        }
        Ok(checks)
    }
}
