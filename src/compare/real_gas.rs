//! Air as it gets hot: a shock that a wall sends into it, a wedge, and the nose of what returns to Earth, against the shocks of air whose
//! properties come from spectra.

mod hemisphere;
mod tube;
mod wedge;

use aero_solver::gas::Air;
use aero_validation::exact::hot_air::{Hot, HotAir};
use aero_validation::table::Check;

use super::comparison::Compare;
use super::context::{CompareError, Context};

const NAME: &str = "real-gas";

const THEORY: &str = "partition functions (Vincenti & Kruger 1965), Rankine-Hugoniot";

/// All of them.
pub struct RealGas;

impl Compare for RealGas {
    fn compare(&self, context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
        let mut checks = tube::compare(context)?;
        checks.extend(wedge::compare(context)?);
        checks.extend(hemisphere::compare(context)?);
        Ok(checks)
    }
}

/// Air at 60 km [U.S. Standard Atmosphere 1976].
fn at_60_km() -> Result<Hot, CompareError> {
    Ok(HotAir::Reacting.at(21.9587, 247.021)?)
}

/// Density, pressure and temperature of gas, in the order in which they are compared.
fn values(air: Air, density: f64, pressure: f64) -> [(&'static str, f64); 3] {
    [
        ("density", density),
        ("pressure", pressure),
        ("temperature", air.temperature(density, pressure)),
    ]
}

/// What they should be.
fn exact(hot: &Hot) -> [f64; 3] {
    [hot.density, hot.pressure, hot.temperature]
}
