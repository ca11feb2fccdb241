//! Ghosts take the mean of the gas about them.

use crate::mms_walls::arrangement::{Ghost, Manner};
use crate::mms_walls::solution::Condition;
use crate::mms_walls::treatment::{Rule, Treatment};
use crate::points::cloud::Cloud;
use crate::points::weights::shepard;

/// Adami, Hu & Adams 2012, doi:10.1016/j.jcp.2012.05.005: `q = sum_j q_j W / sum_j W` at the ghost (eq 22), the pressure with the rise from
/// the gas to the ghost, `dp/dn sum_j n.r_gj W / sum_j W` (eq 27), the velocity `2 u_w - q` (eq 23).
pub struct Adami;

impl Treatment for Adami {
    fn name(&self) -> &'static str {
        "Adami 2012"
    }

    fn keeps(&self, _: Condition) -> bool {
        true
    }

    /// Its mean is that of the gas about a point nearer to the wall than the mirror point, so that all but the pressure, whose rise it knows, is
    /// of first order, and of less where walls are round.
    fn order(&self, condition: Condition, manner: Manner) -> Option<f64> {
        match (condition, manner) {
            (Condition::Neumann, Manner::Along | Manner::Packed) => Some(2.0),
            (_, Manner::Along) => Some(1.0),
            _ => None,
        }
    }

    fn rule(&self, _: Condition, gas: &Cloud, ghost: &Ghost) -> Option<Rule> {
        let weights = shepard(gas, &ghost.position)?;
        let rise = |&(j, weight): &(u32, f64)| {
            weight * ghost.normal.dot(&(ghost.position - gas.points[j as usize]))
        };
        Some(Rule::Reads {
            rise: weights.iter().map(rise).sum(),
            factor: 1.0,
            weights,
        })
    }
}
