//! Loads that are not the integral of what surfaces show: where cells are larger than the edges of a body, they are pressed on walls that
//! are none of its own.

use aero_packer::{About, Warning};
use aero_solver::Flow;
use aero_solver::frame::PanelFrame;

use super::coefficients::Coefficients;

/// Part of a force, or of its part along the stream, that may lack without a word.
const WORTH: f64 = 0.02;

/// The part along the stream counts as no less than this part of the force.
const LEAST_DRAG: f64 = 0.1;

/// A force counts as no less than this part of all that the body is pressed with over the stream's pressure.
const LEAST: f64 = 0.05;

/// About points that stay and of particles: what differs from the stream's pressure by this part of it, on the mean over a body, is not told from
/// gas at rest, in whose corners panels of particles pull a little.
const AT_REST: [f64; 2] = [1e-9, 0.01];

/// What there is to say of the loads of `flow` as it stands, which its `panels` show.
pub(super) fn warnings<const D: usize>(
    flow: &Flow<D>,
    panels: &PanelFrame,
    coefficients: &Coefficients,
) -> Vec<Warning> {
    let problem = flow.problem();
    if problem.bodies.is_empty() {
        return Vec::new();
    }
    let loads = flow.loads();
    let stream = problem.free_stream.velocity.try_normalize(0.0);
    let along = stream.map(|way| std::array::from_fn(|k| way.get(k).copied().unwrap_or(0.0)));
    let each = flow.shown_forces(panels).into_iter().enumerate();
    let told = each.filter_map(|(number, shown)| {
        let load = coefficients.gauge(number, &loads[number]).force;
        let (pressed, at_rest) = pressed(panels, number, problem.free_stream.pressure);
        let part = lacking(&load, &shown, along, pressed);
        let moves = AT_REST[usize::from(problem.method.fixed().is_none())];
        (pressed > moves * at_rest && part.abs() > WORTH).then(|| {
            let (part, word) = (100.0 * part.abs(), if part > 0.0 { "more" } else { "less" });
            let spread = if panels.spread.is_empty() {
                ""
            } else {
                ", without what is spread there as friction"
            };
            let text = format!(
                "its force is {part:.1} % {word} than the integral of what its surface shows{spread}: edges, thin parts, corners with other solids or what \
                 a side cuts off are no more than a few cells or particles large; use a smaller `spacing`, or halve it near the body",
            );
            Warning::new(About::Scene, text).of(&problem.bodies[number].name)
        })
    });
    told.collect()
}

/// All that a body is pressed with over the stream's pressure, whatever its direction, and what that itself presses it with.
fn pressed(panels: &PanelFrame, body: usize, calm: f64) -> (f64, f64) {
    let own = (0..panels.body.len()).filter(|&n| panels.body[n] as usize == body);
    own.fold((0.0, 0.0), |(over, at_rest), n| {
        let area = panels.area[n];
        let apart = (panels.pressure[n] - calm).abs();
        (over + apart * area, at_rest + calm.abs() * area)
    })
}

/// What a `load` has over what is `shown`, in parts of it: the larger of that of the whole and that of its part `along` the stream.
fn lacking(load: &[f64; 3], shown: &[f64; 3], along: Option<[f64; 3]>, pressed: f64) -> f64 {
    let dot = |a: &[f64; 3], b: &[f64; 3]| -> f64 { a.iter().zip(b).map(|(a, b)| a * b).sum() };
    let apart: [f64; 3] = std::array::from_fn(|k| load[k] - shown[k]);
    let size = dot(load, load).sqrt().max(LEAST * pressed);
    if size <= 0.0 {
        return 0.0;
    }
    let whole = dot(&apart, &apart).sqrt().copysign(dot(&apart, load)) / size;
    let drag = along.map_or(0.0, |along| {
        let drag = dot(load, &along);
        (dot(&apart, &along) * drag.signum()) / drag.abs().max(LEAST_DRAG * size)
    });
    if drag.abs() > whole.abs() {
        drag
    } else {
        whole
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_lacks_is_told_of_the_whole_and_of_the_drag() {
        let along = Some([1.0, 0.0, 0.0]);
        let of =
            |load: [f64; 3], shown: [f64; 3], pressed: f64| lacking(&load, &shown, along, pressed);
        assert!((of([1.0, 0.0, 0.0], [0.9, 0.0, 0.0], 1.0) - 0.1).abs() < 1e-12);
        // Drag beside a large lift.
        assert!((of([0.2, 1.0, 0.0], [0.21, 1.0, 0.0], 1.0) + 0.05).abs() < 1e-12);
        assert!((of([0.2, 1.0, 0.0], [0.2, 0.9, 0.0], 1.0) - 0.1 / 1.04_f64.sqrt()).abs() < 1e-12);
        // No drag of a lifting body in slow gas, and no force of one that is pressed alike from all sides, is a measure.
        assert!(of([1e-4, 1.0, 0.0], [2e-4, 1.0, 0.0], 1.0).abs() < 2e-3);
        assert!(of([1e-5, 0.0, 0.0], [2e-5, 0.0, 0.0], 1.0).abs() < 3e-3);
    }
}
