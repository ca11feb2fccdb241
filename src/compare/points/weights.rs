//! Values at a place, read off the points about it.

use aero_geometry::Vector;
use aero_geometry::kernel::QuinticSpline;
use nalgebra::{Matrix3, Vector3};

use super::cloud::Cloud;

/// Numbers of points, and their shares.
pub type Weights = Vec<(u32, f64)>;

/// Weights `W / sum W` of the gas at `place` [Shepard 1968]: right for what is constant.
pub fn shepard(gas: &Cloud, place: &Vector<2>) -> Option<Weights> {
    let mut weights = Vec::new();
    let mut sum = 0.0;
    gas.near(place, |j, arm| {
        let weight = QuinticSpline::<2>::value(arm.norm(), gas.smoothing);
        sum += weight;
        weights.push((j as u32, weight));
    });
    for (_, weight) in &mut weights {
        *weight /= sum;
    }
    (sum > 0.0).then_some(weights)
}

/// Weights `W (b . (1, r))` of the gas at `place`, right for what is linear [Liu & Liu 2006]; none where neighbours are too few or too much
/// in line for it.
pub fn linear(gas: &Cloud, place: &Vector<2>) -> Option<Weights> {
    let h = gas.smoothing;
    let mut terms: Vec<(u32, f64, Vector3<f64>)> = Vec::new();
    let mut moment = Matrix3::zeros();
    gas.near(place, |j, arm| {
        let weight = QuinticSpline::<2>::value(arm.norm(), h);
        let basis = Vector3::new(1.0, arm.x / h, arm.y / h);
        moment += weight * basis * basis.transpose();
        terms.push((j as u32, weight, basis));
    });
    let all = moment[(0, 0)];
    let spread = (moment / all).determinant();
    if spread.is_nan() || spread < LEAST_SPREAD {
        return None;
    }
    let share = moment.try_inverse()? * Vector3::x();
    Some(
        terms
            .into_iter()
            .map(|(j, weight, basis)| (j, weight * basis.dot(&share)))
            .collect(),
    )
}

/// Determinant of the moments of neighbours over their weight, in smoothing lengths, below which no slope is taken from them: that of a
/// particle with neighbours all around is 0.2.
const LEAST_SPREAD: f64 = 1e-3;
