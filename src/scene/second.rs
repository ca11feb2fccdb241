//! `[gas.second]`.

use serde::Deserialize;

use super::formula::Formula;
use super::number::{Gamma, Positive};

/// `[gas.second]`
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SecondGasEntry {
    /// Ratio of specific heats.
    pub gamma: Gamma,
    /// Specific gas constant in J/(kg K); needed where the first gas has one.
    pub gas_constant: Option<Positive>,
    /// Where it is at the start: where this is above zero. Comparisons are one or zero.
    pub inside: Formula,
    /// Density at the start; what the flow has there unless given.
    pub density: Option<Positive>,
}
