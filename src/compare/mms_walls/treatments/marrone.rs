//! Ghosts take what lies at their mirror points.

use crate::mms_walls::arrangement::{Ghost, Manner};
use crate::mms_walls::solution::Condition;
use crate::mms_walls::treatment::{Rule, Treatment};
use crate::points::cloud::Cloud;
use crate::points::weights::linear;

/// Marrone et al. 2011, doi:10.1016/j.cma.2010.12.016, the `wm` of the solver: a fit that is right for what is linear at the ghost's mirror
/// point, the pressure with the rise over twice its depth, the velocity reversed.
pub struct Marrone;

impl Treatment for Marrone {
    fn name(&self) -> &'static str {
        "Marrone 2011"
    }

    fn keeps(&self, _: Condition) -> bool {
        true
    }

    fn order(&self, condition: Condition, manner: Manner) -> Option<f64> {
        (condition != Condition::Slip || manner != Manner::Steps).then_some(2.0)
    }

    fn rule(&self, _: Condition, gas: &Cloud, ghost: &Ghost) -> Option<Rule> {
        let mirror = ghost.foot + ghost.depth * ghost.normal;
        Some(Rule::Reads {
            weights: linear(gas, &mirror)?,
            rise: -2.0 * ghost.depth,
            factor: 1.0,
        })
    }
}
