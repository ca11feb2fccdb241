//! Ghosts lie on the line from a particle of gas through the wall.

use crate::mms_walls::arrangement::{Ghost, Manner};
use crate::mms_walls::solution::Condition;
use crate::mms_walls::treatment::{Rule, Treatment};
use crate::points::cloud::Cloud;

/// Takeda, Miyama & Sekiya 1994, doi:10.1143/ptp/92.5.939: `u_g = u_w - (depth / height) (u - u_w)` with the velocity and the height above
/// the wall of the nearest particle of gas along the normal [Negi & Ramachandran 2022, eq 13]. Where the wall has steps the height may vanish.
pub struct Takeda;

impl Treatment for Takeda {
    fn name(&self) -> &'static str {
        "Takeda 1994"
    }

    fn keeps(&self, condition: Condition) -> bool {
        condition == Condition::NoSlip
    }

    /// Beside a lattice that goes with the wall it is of second order, from a hundred spacings on; elsewhere the nearest particle lies aside of
    /// the normal.
    fn order(&self, _: Condition, manner: Manner) -> Option<f64> {
        (manner != Manner::Steps).then_some(1.0)
    }

    fn rule(&self, _: Condition, gas: &Cloud, ghost: &Ghost) -> Option<Rule> {
        let mut nearest: Option<(f64, usize, f64)> = None;
        gas.near(&ghost.foot, |j, arm| {
            let height = arm.dot(&ghost.normal);
            let distance = arm.norm();
            if nearest.is_none_or(|(least, other, _)| (distance, j) < (least, other)) {
                nearest = Some((distance, j, height));
            }
        });
        let (_, j, height) = nearest?;
        Some(Rule::Reads {
            weights: vec![(j as u32, 1.0)],
            rise: 0.0,
            factor: ghost.depth / height,
        })
    }
}
