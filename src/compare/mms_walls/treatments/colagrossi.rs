//! Ghosts are images of the gas.

use crate::mms_walls::arrangement::{Ghost, Layers, Manner};
use crate::mms_walls::solution::Condition;
use crate::mms_walls::treatment::{Mistake, Rule, Treatment};
use crate::points::cloud::Cloud;

/// Colagrossi & Landrini 2003, doi:10.1016/S0021-9991(03)00324-3: each particle of the gas near the wall has an image behind it, with its
/// pressure and the reversed velocity. The published pressure has no rise towards the image.
pub struct Colagrossi;

impl Treatment for Colagrossi {
    fn name(&self) -> &'static str {
        "Colagrossi 2003"
    }

    fn layers(&self) -> Layers {
        Layers::Images
    }

    fn keeps(&self, _: Condition) -> bool {
        true
    }

    fn order(&self, condition: Condition, manner: Manner) -> Option<f64> {
        match (condition, manner) {
            (_, Manner::Steps) => None,
            (Condition::Neumann, _) => Some(1.0),
            _ => Some(2.0),
        }
    }

    /// Its pressure knows neither slope nor distance.
    fn mistakes(&self, condition: Condition) -> &'static [Mistake] {
        if condition == Condition::Neumann {
            &[]
        } else {
            &[Mistake::Sign, Mistake::Arm]
        }
    }

    fn rule(&self, _: Condition, _: &Cloud, ghost: &Ghost) -> Option<Rule> {
        Some(Rule::Reads {
            weights: vec![(ghost.image_of? as u32, 1.0)],
            rise: 0.0,
            factor: 1.0,
        })
    }
}
