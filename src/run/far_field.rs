//! Sides that hold down the lift of what flies slower than sound between them.

use aero_packer::{About, Warning};
use aero_solver::frame::Load;
use aero_solver::method::{Method, Time};
use aero_solver::problem::Problem;

/// Parts of the lift that are worth a word, and of what a body of its length has at the stream's dynamic pressure, below which there is none.
const WORTH: f64 = 0.02;
const LIFT: f64 = 0.01;

/// What there is to say of the sides of a flow that presses its bodies with `loads`.
pub(super) fn warnings<const D: usize>(problem: &Problem<D>, loads: &[Load]) -> Vec<Warning> {
    // The stream beyond the sides of a flow that settles turns with the lift.
    let settles = matches!(problem.method, Method::Fixed(points) if points.time == Time::Settle);
    if settles || !problem.feels_lift_far_away() {
        return Vec::new();
    }
    let stream = &problem.free_stream;
    let sound = problem.gas.sound_speed_at(stream.density, stream.pressure);
    let speed = stream.velocity.norm();
    let along = stream.velocity / speed;
    let force = |k: usize| -> f64 { loads.iter().map(|load| load.force[k]).sum() };
    let lift = force(1) * along[0] - force(0) * along[1];
    let (mut length, mut away) = (0.0_f64, f64::INFINITY);
    for body in &problem.bodies {
        let extent = body.shape.bounds();
        length = length.max(extent.size().norm());
        let bounds = &problem.domain.bounds;
        away = away
            .min((extent.min - bounds.min).min())
            .min((bounds.max - extent.max).min());
    }
    let pressure = 0.5 * stream.density * speed * speed;
    let part = lost(speed / sound, length, away);
    if lift.abs() < LIFT * pressure * length || part < WORTH {
        return Vec::new();
    }
    let text = format!(
        "the stream is slower than sound, and what lift does to it is felt on its sides: held straight {away:.3} from a body {length:.3} \
         long they take up to about {:.0} % of the lift; move them away, or settle about points that stay (`stop = \"steady\"`, \
         `scheme.motion = \"fixed\"`), where the stream beyond them turns with the lift",
        100.0 * part
    );
    vec![Warning::new(About::Scene, text)]
}

/// Part of the lift that sides `away` take at most of a thin body of this `length`, which they do near the speed of sound: the vortex that is missing beyond them would have turned the
/// stream up by `Gamma / (4 pi h U sqrt(1 - M^2))`, and thin bodies have `2 pi / sqrt(1 - M^2)` per radian.
fn lost(mach: f64, length: f64, away: f64) -> f64 {
    length / (2.0 * away * (1.0 - mach * mach))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An aerofoil at Mach 0.8: 0.308 between sides 10 chords away, 0.342 between such 40 away.
    #[test]
    fn what_sides_take_is_what_larger_boxes_give_back() {
        let whole =
            [(10.0, 0.308), (40.0, 0.342)].map(|(away, lift)| lift / (1.0 - lost(0.8, 1.0, away)));
        assert!((whole[0] / whole[1] - 1.0).abs() < 0.02, "{whole:?}");
    }
}
