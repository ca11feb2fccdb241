//! The cavity with a sliding lid, along its middle lines.

use aero_solver::frame::Frame;
use aero_validation::table::{Check, Subject};

use super::NAME;
use crate::context::{CompareError, Context};
use crate::scenes::{Source, scene};

const SCENE: Source = scene!("cavity");
const THEORY: &str = "Ghia, Ghia & Shin 1982, J. Comput. Phys. 48, 387-411, tables I and II";
/// `u` along `x = 1/2` at Re 100, by `y` [table I].
const ACROSS: [[f64; 2]; 15] = [
    [0.0547, -0.03717],
    [0.0625, -0.04192],
    [0.0703, -0.04775],
    [0.1016, -0.06434],
    [0.1719, -0.10150],
    [0.2813, -0.15662],
    [0.4531, -0.21090],
    [0.5000, -0.20581],
    [0.6172, -0.13641],
    [0.7344, 0.00332],
    [0.8516, 0.23151],
    [0.9531, 0.68717],
    [0.9609, 0.73722],
    [0.9688, 0.78871],
    [0.9766, 0.84123],
];
pub(super) fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let what = "PE-IPST-C, cavity, 50 cells: largest error of the velocity across its middle, per cent of the lid's";
    let subject = Subject::new(NAME, what, THEORY);
    let attempt = SCENE.attempt(&[], context)?;
    Ok(vec![match attempt.outcome() {
        None => subject.unmeasured(0.0),
        Some(outcome) => {
            let errors = ACROSS.map(|[y, exact]| (at(&outcome.gas, [0.5, y]) - exact).abs());
            let worst = errors.into_iter().fold(0.0, f64::max);
            subject.informs(100.0 * worst, 0.0)
        }
    }])
}

/// Velocity along x at a place of the gas with this spacing: a plane through the particles around it, the nearer the heavier.
fn at(gas: &Frame, place: [f64; 2]) -> f64 {
    /// Of the scene.
    const SPACING: f64 = 0.02;
    let mut sums = nalgebra::Matrix3::zeros();
    let mut right = nalgebra::Vector3::zeros();
    for (position, velocity) in gas.position.iter().zip(&gas.velocity) {
        let [x, y] = [0, 1].map(|k| (position[k] - place[k]) / SPACING);
        let weight = (-x * x - y * y).exp();
        let row = nalgebra::Vector3::new(1.0, x, y);
        sums += row * row.transpose() * weight;
        right += row * (weight * velocity[0]);
    }
    sums.lu().solve(&right).map_or(f64::NAN, |plane| plane[0])
}
