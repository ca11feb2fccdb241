//! Air as it gets hot: a shock that a wall sends into it, a wedge, and the nose of what returns to Earth, against the shocks of air whose
//! properties come from spectra.

mod hemisphere;
mod tube;
mod wedge;

use aero_solver::gas::Air;
use aero_validation::exact::hot_air::{Hot, HotAir};
use aero_validation::table::{Check, Subject};

use super::context::CompareError;
use super::suite::Suite;
use super::variant::Levels;

const NAME: &str = "real-gas";

const THEORY: &str = "partition functions (Vincenti & Kruger 1965), Rankine-Hugoniot";

/// All of them.
pub const REAL_GAS: Suite = Suite::of(&[
    (Levels::Both, tube::compare),
    (Levels::Both, wedge::compare),
    (Levels::Both, hemisphere::compare),
]);

/// Air at 60 km [U.S. Standard Atmosphere 1976].
pub(super) fn at_60_km() -> Result<Hot, CompareError> {
    Ok(HotAir::Reacting.at(21.9587, 247.021)?)
}

/// Density, pressure and temperature that gas of `air` was `found` to have `place`, beside those `behind` a shock; `allowed` is in per cent.
fn state(
    label: &str,
    place: &str,
    air: Air,
    found: Option<[f64; 2]>,
    behind: &Hot,
    allowed: f64,
) -> [Check; 3] {
    let found =
        found.map(|[density, pressure]| [density, pressure, air.temperature(density, pressure)]);
    let exact = [
        ("density", behind.density),
        ("pressure", behind.pressure),
        ("temperature", behind.temperature),
    ];
    std::array::from_fn(|k| {
        let (name, expected) = exact[k];
        let what = format!("{label}: {name} {place}");
        let subject = Subject::new(NAME, &what, THEORY);
        match found {
            Some(found) => subject.relative(found[k], expected, allowed),
            None => subject.unmeasured(expected),
        }
    })
}
