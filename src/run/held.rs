//! Outlets that have not come to the pressure that they hold, at the end of a run. They go back to it slowly, so as to let sound out, and the slower
//! the slower the gas is where a reservoir feeds it: about at the rate `sigma M (1 - M) c / L`, for its speed has to follow at one total pressure.

use aero_packer::{About, Warning};
use aero_solver::frame::Frame;
use aero_solver::problem::{Problem, Side, side_name};

use super::beside::beside;

/// What pressures may be off on the mean, in parts of the largest dynamic pressure of the gas.
const WORTH: f64 = 0.05;

/// Mach numbers out of the domain of gas that nothing holds the pressure of: choked, or faster than sound.
const CHOKED: f64 = 0.9;

/// What there is to say of the outlets of a flow as it stands in `frame`.
pub(super) fn warnings<const D: usize>(problem: &Problem<D>, frame: &Frame) -> Vec<Warning> {
    let domain = &problem.domain;
    let own = |axis, end| {
        let mut openings = domain.openings.iter();
        openings.any(|opening| (opening.axis, opening.end) == (axis, end))
    };
    let largest = (0..frame.density.len()).map(|i| dynamic_pressure(frame, i));
    let largest = largest.fold(f64::MIN_POSITIVE, f64::max);
    let lines = domain.each_side().filter_map(|(axis, end, side, plane)| {
        let Side::HeldOutlet {
            pressure,
            relaxation,
        } = side
        else {
            return None;
        };
        let mean = mean_pressure(problem.resolution.lattice(), frame, (axis, end, plane))?;
        let off = (mean - pressure).abs() / largest;
        let is_worth = off > WORTH && !own(axis, end);
        let name = side_name(axis, end);
        is_worth.then(|| {
            format!(
                "the pressure at the outlet `{name}` is {mean:.5e} on the mean, {:.0} % of the dynamic pressure off the {pressure:.5e} that it \
                 holds: the flow has not come to it; run longer, or take more `relaxation` than {relaxation}",
                100.0 * off
            )
        })
    });
    lines.map(|text| Warning::new(About::Scene, text)).collect()
}

/// Mean over the area of what leaves by a side slower than sound; none where nothing does, or where it is choked.
fn mean_pressure(spacing: f64, frame: &Frame, side: (usize, usize, f64)) -> Option<f64> {
    let (mut area, mut sum, mut mach) = (0.0, 0.0, 0.0);
    for (i, own) in beside(spacing, frame, side) {
        let speed = frame.velocity[i].iter().map(|u| u * u).sum::<f64>().sqrt();
        let out = [-1.0, 1.0][side.1] * frame.velocity[i][side.0];
        if out > 0.0 {
            area += own;
            sum += own * frame.pressure[i];
            mach += own * frame.mach[i] * out / speed;
        }
    }
    (area > 0.0 && mach < CHOKED * area).then(|| sum / area)
}

fn dynamic_pressure(frame: &Frame, i: usize) -> f64 {
    0.5 * frame.density[i] * frame.velocity[i].iter().map(|u| u * u).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use aero_solver::frame::Kind;

    use super::*;

    /// Points at the far end of a row, the last of which comes back.
    fn frame(mach: f64) -> Frame {
        let velocities = [mach, mach, -mach];
        Frame {
            position: vec![[0.95, 0.0, 0.0]; 3],
            velocity: velocities.map(|u| [u, 0.0, 0.0]).to_vec(),
            mach: velocities.map(f64::abs).to_vec(),
            density: vec![1.0; 3],
            pressure: vec![0.8, 0.9, 5.0],
            volume: vec![0.01; 3],
            kind: vec![Kind::Fluid as u8; 3],
            ..Frame::default()
        }
    }

    #[test]
    fn the_mean_is_that_of_gas_that_leaves_and_is_not_choked() {
        let mean = |mach| mean_pressure(0.1, &frame(mach), (0, 1, 1.0));
        assert!((mean(0.4).unwrap() - 0.85).abs() < 1e-12);
        assert_eq!(mean(0.95), None);
        assert_eq!(mean_pressure(0.1, &frame(0.4), (0, 0, 0.0)), None);
    }
}
