//! What a wall treatment is: how a ghost follows from the gas.

use super::arrangement::{Ghost, Layers, Manner};
use super::solution::Condition;
use crate::points::cloud::Cloud;
use crate::points::weights::Weights;

/// How ghosts of a wall get their state.
pub trait Treatment: Sync {
    /// Author and year.
    fn name(&self) -> &'static str;

    /// Which ghosts it asks for.
    fn layers(&self) -> Layers {
        Layers::Several
    }

    /// How a ghost keeps a condition of the wall; none where it has nothing to go by, and takes no part.
    fn rule(&self, condition: Condition, gas: &Cloud, ghost: &Ghost) -> Option<Rule>;

    /// The conditions that it keeps.
    fn keeps(&self, condition: Condition) -> bool;

    /// Order of what it ought to add to the error; none where it is not known, or where it does not converge.
    fn order(&self, condition: Condition, manner: Manner) -> Option<f64>;

    /// True if beside a straight wall it ought to add less than the scheme's own error.
    fn is_small(&self) -> bool {
        true
    }

    /// False where noise grows by a factor in so many spacings of sound's way, however short the steps: then it is judged at wide spacings
    /// alone, where there is no time for it.
    fn lasts(&self) -> bool {
        true
    }

    /// The mistakes in it that must show. First order cannot tell one distance from another.
    fn mistakes(&self, condition: Condition) -> &'static [Mistake] {
        if self.order(condition, Manner::Along) == Some(2.0) {
            &[Mistake::Sign, Mistake::Arm]
        } else {
            &[Mistake::Sign]
        }
    }

    /// True if the velocity of the gas in the row at the wall is not its own but what its neighbours and the wall make it.
    fn overrides_gas(&self) -> bool {
        false
    }
}

/// How the state of one ghost follows from that of the gas.
#[derive(Clone, Debug)]
pub enum Rule {
    /// `q = sum w_j q_j` is read off the gas. Pressure: `q + rise dp/dn`; velocity: `u_w - factor (q - u_w)`, of slip walls in the part
    /// along the normal alone.
    Reads {
        weights: Weights,
        /// m.
        rise: f64,
        factor: f64,
    },
    /// The velocity of the wall times this.
    Wall(f64),
    /// The pressure is one of its own: `dp/dt = c (dp/dn - dp/dn|wall) - rho c^2 du_n/dn` with `dq/dn = sum w_j q_j + own q`.
    Evolves {
        weights: Weights,
        /// 1/m.
        own: f64,
    },
}

/// A mistake in a rule.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mistake {
    /// What depends on the wall has the wrong sign.
    Sign,
    /// What depends on the distance from the wall is half too large.
    Arm,
}

impl Rule {
    /// The same with a mistake.
    #[must_use]
    pub fn mistaken(self, mistake: Mistake) -> Self {
        let wrong = match mistake {
            Mistake::Sign => -1.0,
            Mistake::Arm => 1.5,
        };
        match self {
            Self::Reads {
                weights,
                rise,
                factor,
            } => Self::Reads {
                weights,
                rise: rise * wrong,
                factor: factor * wrong,
            },
            Self::Wall(factor) => Self::Wall(factor * wrong),
            Self::Evolves { weights, own } => Self::Evolves {
                weights: weights.into_iter().map(|(j, w)| (j, w * wrong)).collect(),
                own: own * wrong,
            },
        }
    }
}
