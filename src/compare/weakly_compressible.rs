//! Liquids: waves by the exact Riemann problem, and flows that are all but incompressible by each scheme.

mod cavity;
mod shear;
mod tube;
mod vortices;

use super::suite::Suite;
use super::variant::Levels;

const NAME: &str = "weakly-compressible";

/// The schemes of liquids.
const SCHEMES: [&str; 5] = ["L-IPST-C", "PE-IPST-C", "TV-C", "E-C", "EDAC"];

/// Liquids by particles.
pub const WEAKLY_COMPRESSIBLE: Suite = Suite::of(&[
    (Levels::Both, tube::compare),
    (Levels::Both, vortices::compare),
    (Levels::Both, shear::compare),
    (Levels::Full, cavity::compare),
]);
