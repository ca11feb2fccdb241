//! Outlets that gas does not just leave through, at the end of a run: what is upstream of them depends on the side then.

use aero_packer::{About, Warning};
use aero_solver::frame::Frame;
use aero_solver::problem::{Problem, Side, side_name};

use super::beside::beside;
use super::held;
use crate::check::against::is_against;

/// Parts of an outlet beyond which gas that comes back, and gas that leaves slower than sound, are worth a word.
const BACK: f64 = 0.005;
const SLOW: f64 = 0.03;

/// Mach number below which gas is at rest, and nothing passes.
const AT_REST: f64 = 0.01;

/// What there is to say of the outlets of a flow as it stands in `frame`.
pub(super) fn warnings<const D: usize>(problem: &Problem<D>, frame: &Frame) -> Vec<Warning> {
    let outlets = problem.domain.each_side();
    // Those that the stream comes in by were told before the run began.
    let outlets = outlets.filter(|(axis, end, side, _)| {
        *side == Side::Outlet && !is_against(problem, *axis, *end, *side)
    });
    let lines = outlets.filter_map(|(axis, end, _, plane)| {
        let [back, slow] = shares(problem.resolution.lattice(), frame, axis, end, plane);
        let name = side_name(axis, end);
        if back > BACK {
            Some(format!(
                "gas comes back through {:.1} % of the outlet `{name}`: a wake reaches it, and what is upstream depends on where the side \
                 is; move it away from the body",
                100.0 * back
            ))
        } else if slow > SLOW {
            Some(format!(
                "gas leaves slower than sound through {:.0} % of the outlet `{name}`, which sends waves back; move it away, or hold a pressure \
                 there: `{name} = {{ outlet = {{ pressure = .. }} }}`",
                100.0 * slow
            ))
        } else {
            None
        }
    });
    let told = lines.map(|text| Warning::new(About::Scene, text));
    told.chain(held::warnings(problem, frame)).collect()
}

/// Parts of the gas at a side, by the area that it takes there: what comes in, and what goes out slower than sound.
fn shares(spacing: f64, frame: &Frame, axis: usize, end: usize, plane: f64) -> [f64; 2] {
    let outwards = [-1.0, 1.0][end];
    let (mut all, mut back, mut slow) = (0.0, 0.0, 0.0);
    for (i, area) in beside(spacing, frame, (axis, end, plane)) {
        let velocity = &frame.velocity[i];
        let speed = velocity.iter().map(|u| u * u).sum::<f64>().sqrt();
        let out = outwards * velocity[axis];
        all += area;
        if frame.mach[i] < AT_REST {
            continue;
        }
        if out < 0.0 {
            back += area;
        } else if out * frame.mach[i] < speed {
            slow += area;
        }
    }
    if all > 0.0 {
        [back / all, slow / all]
    } else {
        [0.0; 2]
    }
}

#[cfg(test)]
mod tests {
    use aero_solver::frame::Kind;

    use super::*;

    /// Four points at the far end of a row, one of which comes back and one of which is slow.
    #[test]
    fn shares_are_those_of_the_area_at_the_side() {
        let velocities = [2.0, 2.0, 0.5, -0.5, -3.0];
        let frame = Frame {
            position: vec![[0.95, 0.0, 0.0]; 4]
                .into_iter()
                .chain([[0.5, 0.0, 0.0]])
                .collect(),
            velocity: velocities.map(|u| [u, 0.0, 0.0]).to_vec(),
            mach: velocities.map(f64::abs).to_vec(),
            volume: vec![0.01; 5],
            kind: vec![Kind::Fluid as u8; 5],
            ..Frame::default()
        };
        assert_eq!(shares(0.1, &frame, 0, 1, 1.0), [0.25, 0.25]);
        assert_eq!(shares(0.1, &frame, 0, 0, 0.0), [0.0, 0.0]);
    }
}
