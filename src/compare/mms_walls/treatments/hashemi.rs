//! One row of ghosts on the wall, in balance with the gas.

use aero_geometry::Vector;
use aero_geometry::kernel::QuinticSpline;
use nalgebra::Matrix2;

use crate::mms_walls::arrangement::{Ghost, Layers, Manner};
use crate::mms_walls::solution::Condition;
use crate::mms_walls::treatment::{Rule, Treatment};
use crate::points::cloud::Cloud;
use crate::points::weights::Weights;

/// Hashemi, Fatehi & Manzari 2012, doi:10.1016/j.ijnonlinmec.2011.10.007: the pressure for which the corrected gradient at the ghost has the
/// slope that the wall asks for, `p = (sum_j p_j n.L grad W omega_j - dp/dn) / sum_j n.L grad W omega_j` [Negi & Ramachandran 2022, eq 11, which
/// lacks the sums]; the velocity of the wall.
pub struct Hashemi;

impl Treatment for Hashemi {
    fn name(&self) -> &'static str {
        "Hashemi 2012"
    }

    fn layers(&self) -> Layers {
        Layers::Surface
    }

    fn keeps(&self, condition: Condition) -> bool {
        condition != Condition::Slip
    }

    /// One row is too few for the Laplacian.
    fn order(&self, condition: Condition, manner: Manner) -> Option<f64> {
        let is_known = condition == Condition::Neumann || manner == Manner::Along;
        is_known.then_some(1.0)
    }

    fn lasts(&self) -> bool {
        false
    }

    fn rule(&self, condition: Condition, gas: &Cloud, ghost: &Ghost) -> Option<Rule> {
        if condition == Condition::NoSlip {
            return Some(Rule::Wall(1.0));
        }
        let mut slopes: Vec<(u32, Vector<2>)> = Vec::new();
        let mut moment = Matrix2::zeros();
        gas.near(&ghost.position, |j, arm| {
            let slope = -arm * QuinticSpline::<2>::gradient_factor(arm.norm(), gas.smoothing);
            moment += slope * arm.transpose();
            slopes.push((j as u32, slope));
        });
        let correction = moment.try_inverse()?;
        let mut weights: Weights = slopes
            .into_iter()
            .map(|(j, slope)| (j, ghost.normal.dot(&(correction * slope))))
            .collect();
        let sum: f64 = weights.iter().map(|(_, weight)| weight).sum();
        for (_, weight) in &mut weights {
            *weight /= sum;
        }
        Some(Rule::Reads {
            weights,
            rise: -1.0 / sum,
            factor: 1.0,
        })
    }
}
