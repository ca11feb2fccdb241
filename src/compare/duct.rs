//! Subsonic flow through a duct, from a reservoir to a held pressure, against isentropic theory.

use aero::run::Keep;

use super::comparison::{Comparison, Flow};
use super::context::CompareError;
use super::row::Row;
use super::scenes::scene;
use super::variant::Variant;

const THEORY: &str = "isentropic flow (NACA 1135, 1953, eqs 43-45)";
/// As in the scene: what is held, and the Mach number that it makes.
const PRESSURE: f64 = 0.657_817;
const MACH: f64 = 0.4;

/// The mean of the last tenth before the outlet.
pub const DUCT: Comparison = Comparison {
    case: "duct",
    scene: scene!("duct"),
    length: 1.0,
    keep: Keep::End,
    variants: || {
        let variant = Variant::new(40, ()).both();
        vec![variant, variant.marched(), variant.settled()]
    },
    label: |v| format!("dx 1/{}, {}", v.cells, v.scheme.laws()),
    settings: |_, _| Vec::new(),
    rows,
    pictures: |_| Ok(()),
    together: None,
};

#[allow(clippy::unnecessary_wraps)] // a comparison's rows may fail
fn rows(flow: &Flow<'_>) -> Result<Vec<Row>, CompareError> {
    let gas = &flow.outcome.gas;
    let end = (0..gas.kind.len()).filter(|i| gas.position[*i][0] > 0.9);
    let (mut pressure, mut mach, mut count) = (0.0, 0.0, 0.0);
    for i in end {
        pressure += gas.pressure[i];
        mach += gas.mach[i];
        count += 1.0;
    }
    Ok(vec![
        Row::relative(
            "pressure before the outlet",
            "what is held",
            pressure / count,
            PRESSURE,
            [0.004, 0.1],
        ),
        Row::relative(
            "Mach number before the outlet",
            THEORY,
            mach / count,
            MACH,
            [0.15, 1.0],
        ),
        flow.no_leaks(),
    ])
}
