//! Ghosts go on as the gas does.

use crate::mms_walls::arrangement::{Ghost, Manner};
use crate::mms_walls::solution::Condition;
use crate::mms_walls::treatment::{Rule, Treatment};
use crate::points::cloud::Cloud;
use crate::points::weights::linear;

/// Esmaili Sikarudi & Nikseresht 2016, doi:10.1016/j.cpc.2015.07.004, as Negi & Ramachandran 2022 have it for the velocity: a first-order
/// extrapolation to the ghost. It goes on linearly through the wall, whose own velocity it never asks for; the sign of Adami's would turn the
/// shear round. Ghosts too far from the gas for a slope take
/// no part.
pub struct Esmaili;

impl Treatment for Esmaili {
    fn name(&self) -> &'static str {
        "Esmaili 2016"
    }

    fn keeps(&self, condition: Condition) -> bool {
        condition == Condition::NoSlip
    }

    fn order(&self, _: Condition, _: Manner) -> Option<f64> {
        None
    }

    fn rule(&self, _: Condition, gas: &Cloud, ghost: &Ghost) -> Option<Rule> {
        Some(Rule::Reads {
            weights: linear(gas, &ghost.position)?,
            rise: 0.0,
            factor: -1.0,
        })
    }
}
