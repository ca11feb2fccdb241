//! One row of ghosts on the wall, whose pressure follows the waves that arrive.

use crate::mms_walls::arrangement::{Ghost, Layers, Manner};
use crate::mms_walls::solution::Condition;
use crate::mms_walls::treatment::{Rule, Treatment};
use crate::points::cloud::Cloud;
use crate::points::weights::shepard;

/// Marongiu, Leboeuf & Parkinson 2007, doi:10.1243/09576509JPE465: `dp/dt = c dp/dn - rho c^2 du_n/dn - rho c g.n` on the wall [Negi &
/// Ramachandran 2022, eq 9, corrected]; slopes by finite differences of fourth order of the ghost and four points in the gas, a spacing apart,
/// where values are means of the gas.
pub struct Marongiu;

/// One-sided first derivative of fourth order, times the spacing.
const DIFFERENCES: [f64; 5] = [-25.0 / 12.0, 4.0, -3.0, 4.0 / 3.0, -0.25];

impl Treatment for Marongiu {
    fn name(&self) -> &'static str {
        "Marongiu 2007"
    }

    fn layers(&self) -> Layers {
        Layers::Surface
    }

    fn keeps(&self, condition: Condition) -> bool {
        condition == Condition::Neumann
    }

    fn order(&self, _: Condition, _: Manner) -> Option<f64> {
        None
    }

    fn lasts(&self) -> bool {
        false
    }

    fn rule(&self, _: Condition, gas: &Cloud, ghost: &Ghost) -> Option<Rule> {
        let spacing = gas.spacing;
        let mut weights = Vec::new();
        for (k, difference) in DIFFERENCES.into_iter().enumerate().skip(1) {
            let place = ghost.position + k as f64 * spacing * ghost.normal;
            let mean = shepard(gas, &place)?;
            weights.extend(mean.into_iter().map(|(j, w)| (j, w * difference / spacing)));
        }
        Some(Rule::Evolves {
            weights,
            own: DIFFERENCES[0] / spacing,
        })
    }
}
