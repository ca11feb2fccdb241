//! What the ways to name a side have in common: its words, where a part of one is, and the gas beyond it.

use serde::Deserialize;
use serde::de::Error;

use aero_solver::problem::Side;

use super::formula::TimedFormula;
use super::number::Finite;

/// `patch`: a box on the side.
#[derive(Clone, Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct PatchEntry {
    /// Lowest corner.
    pub min: Vec<Finite>,
    /// Highest corner, the same along the axis across the side.
    pub max: Vec<Finite>,
}

/// The state of the gas beyond a side: formulas of position and time; what is left out is the free stream's.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct GivenEntry {
    /// Density.
    pub density: Option<TimedFormula>,
    /// Pressure.
    pub pressure: Option<TimedFormula>,
    /// Velocity, one formula per axis.
    pub velocity: Option<Vec<TimedFormula>>,
}

impl GivenEntry {
    /// None where nothing is given.
    pub(super) fn of(
        density: Option<TimedFormula>,
        pressure: Option<TimedFormula>,
        velocity: Option<Vec<TimedFormula>>,
    ) -> Option<Self> {
        let given = Self {
            density,
            pressure,
            velocity,
        };
        (given != Self::default()).then_some(given)
    }
}

/// The tables that a side may be.
pub(super) const TABLES: &str = "`{ wall = { .. } }`, `{ inlet = { reflecting = false } }`, `{ outlet = { pressure = .. } }`, \
    `{ reservoir = { relaxation = .. } }`, `{ free-stream = { .. } }`";

/// The side that a word names.
pub(super) fn named<E: Error>(word: &str) -> Result<Side, E> {
    Side::named(word).ok_or_else(|| {
        E::custom(format!(
            "unknown variant `{word}`, expected one of {}",
            words()
        ))
    })
}

/// All words, for a message.
pub(super) fn words() -> String {
    Side::WORDS.map(|(word, _)| format!("`{word}`")).join(", ")
}
