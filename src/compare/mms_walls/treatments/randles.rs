//! Ghosts have the wall's velocity, and the row of gas at the wall what that makes of it.

use crate::mms_walls::arrangement::{Ghost, Manner};
use crate::mms_walls::solution::Condition;
use crate::mms_walls::treatment::{Rule, Treatment};
use crate::points::cloud::Cloud;

/// Randles & Libersky 1996, doi:10.1016/S0045-7825(96)01090-0: ghosts have the prescribed value, gas in the row at the wall
/// `q = q_w + sum_gas (q_j - q_w) W omega_j / (1 - sum_ghosts W omega_j)` [Negi & Ramachandran 2022, eq 14].
pub struct RandlesLibersky;

impl Treatment for RandlesLibersky {
    fn name(&self) -> &'static str {
        "Randles 1996"
    }

    fn keeps(&self, condition: Condition) -> bool {
        condition == Condition::NoSlip
    }

    fn order(&self, _: Condition, _: Manner) -> Option<f64> {
        Some(1.0)
    }

    /// It moves the gas at the wall.
    fn is_small(&self) -> bool {
        false
    }

    fn rule(&self, _: Condition, _: &Cloud, _: &Ghost) -> Option<Rule> {
        Some(Rule::Wall(1.0))
    }

    fn overrides_gas(&self) -> bool {
        true
    }
}
