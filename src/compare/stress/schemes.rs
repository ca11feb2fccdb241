//! What the flows of the suite share: the gas past bodies, and which schemes are compared.

use crate::context::Level;
use crate::variant::{Motion, Scheme};

pub const GAMMA: f64 = 1.4;
/// Pressure of the stream past bodies where lengths, densities and speeds are of order one, `1 / gamma`.
pub const PRESSURE: f64 = 1.0 / GAMMA;

/// The schemes that are compared at a level, points that stay last: the published one at the full level alone.
pub fn schemes(level: Level) -> Vec<Scheme> {
    let usual = Scheme::USUAL;
    let published = usual.paper();
    let points = usual.by_points(Motion::Marched);
    match level {
        Level::Quick => vec![usual, usual.wm(), points],
        Level::Full => vec![usual, usual.wm(), published, published.wm(), points],
    }
}

/// The same for flows without walls, in which extrapolations play no part.
pub fn equations(level: Level) -> Vec<Scheme> {
    let mut schemes = schemes(level);
    schemes.retain(|scheme| scheme.extrapolation == "wom");
    schemes
}
