//! Inlets that a shock stands on, at the end of a run: a stream faster than sound knows nothing of what is behind it, and a shock that has come to the side
//! goes no farther, wherever it would stand.

use aero_packer::{About, Warning};
use aero_solver::frame::Frame;
use aero_solver::problem::{Problem, side_name};

use super::beside::beside;

/// Part of the stream's pressure by which gas at the side is over it where a shock stands there.
const SHOCKED: f64 = 0.2;

/// Part of a side beyond which that is worth a word.
const PART: f64 = 0.04;

/// What there is to say of the inlets of a flow as it stands in `frame`.
pub(super) fn warnings<const D: usize>(problem: &Problem<D>, frame: &Frame) -> Vec<Warning> {
    let stream = &problem.free_stream;
    let sound = problem.gas.sound_speed_at(stream.density, stream.pressure);
    let domain = &problem.domain;
    let inlets = domain.each_side().filter(|(axis, end, side, _)| {
        let inwards = [1.0, -1.0][*end] * stream.velocity[*axis];
        let is_own = domain
            .openings
            .iter()
            .any(|opening| (opening.axis, opening.end) == (*axis, *end));
        side.keeps_free_stream() && inwards > sound && !is_own
    });
    let lines = inlets.filter_map(|(axis, end, _, plane)| {
        let part = shocked(problem.resolution.lattice(), frame, (axis, end, plane), stream.pressure);
        (part > PART).then(|| {
            let name = side_name(axis, end);
            let text = format!(
                "a shock stands on {:.0} % of the inlet `{name}`, which keeps it from going to its place: forces and pressures behind it are wrong; \
                 move the side away from the body",
                100.0 * part
            );
            Warning::new(About::Scene, text).beside((axis, end))
        })
    });
    lines.collect()
}

/// Part of the gas at a side, by the area that it takes there, whose pressure is above that of the stream by more than no shock makes.
fn shocked(spacing: f64, frame: &Frame, side: (usize, usize, f64), pressure: f64) -> f64 {
    let (mut all, mut over) = (0.0, 0.0);
    for (i, area) in beside(spacing, frame, side) {
        all += area;
        if frame.pressure[i] > (1.0 + SHOCKED) * pressure {
            over += area;
        }
    }
    if all > 0.0 { over / all } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use aero_solver::frame::Kind;

    use super::*;

    /// Five points beside the near end of a row, two of them behind a shock, and one that is far from there.
    #[test]
    fn the_part_of_an_inlet_behind_a_shock_is_that_of_its_area() {
        let frame = Frame {
            position: vec![[0.05, 0.0, 0.0]; 5]
                .into_iter()
                .chain([[0.5, 0.0, 0.0]])
                .collect(),
            pressure: vec![1.0, 1.1, 1.0, 2.6, 2.6, 2.6],
            volume: vec![0.01; 6],
            kind: vec![Kind::Fluid as u8; 6],
            ..Frame::default()
        };
        let at = |end: usize, plane: f64| shocked(0.1, &frame, (0, end, plane), 1.0);
        assert!((at(0, 0.0) - 0.4).abs() < 1e-12);
        assert_eq!(at(1, 1.0), 0.0);
    }
}
