//! Free-stream sides that throw waves of a body back onto one, at the end of a run.
//!
//! What leaves a side along Mach lines about points that stay, in the plane and about an axis, does not come back. Beside particles it does; and where gas
//! is hardly faster than sound, or slower.

use aero_packer::{About, Warning};
use aero_solver::frame::{Frame, PanelFrame};
use aero_solver::problem::{Problem, Side, side_name};

use super::beside::beside;

/// Part of what the gas presses bodies with over the stream's pressure that is worth a word where it is thrown back.
const WORTH: f64 = 0.1;

/// Part of the surface of all bodies that has to feel it.
const PART: f64 = 0.05;

/// Mach number above which waves leave about points that stay.
const LEAVES: f64 = 1.1;

/// Most places at a side, and most panels, that are looked at.
const MOST: usize = 2000;

/// Gas at a side.
struct Place {
    at: [f64; 3],
    way: [f64; 3],
    mach: f64,
}

/// What there is to say of the sides of a flow as it stands in `frame` around bodies with these `panels`.
pub(super) fn warnings<const D: usize>(
    problem: &Problem<D>,
    frame: &Frame,
    panels: &PanelFrame,
) -> Vec<Warning> {
    let own: Vec<usize> = (0..panels.body.len())
        .filter(|&n| (panels.body[n] as usize) < problem.bodies.len())
        .collect();
    let calm = problem.free_stream.pressure;
    let pressed = pressed(panels, &own, calm);
    if own.is_empty() || pressed <= 0.0 {
        return Vec::new();
    }
    let sides = problem.domain.each_side();
    let sides = sides.filter(|(axis, end, side, _)| {
        *side == Side::FreeStream && runs_along(problem, *axis, *end)
    });
    let lines = sides.filter_map(|(axis, end, _, plane)| {
        let gas = beside(problem.resolution.lattice(), frame, (axis, end, plane));
        let over = |i: usize| (frame.pressure[i] - calm).abs() / pressed;
        let places: Vec<(f64, Place)> = gas
            .filter(|(i, _)| over(*i) > WORTH && !leaves(problem, frame.mach[*i]))
            .map(|(i, _)| (over(i), Place::of(frame, i)))
            .collect();
        let most = places.iter().fold(0.0_f64, |most, (over, _)| most.max(*over));
        (felt(&places, panels, &own) > PART).then(|| {
            let name = side_name(axis, end);
            let text = format!(
                "the free-stream side `{name}` throws waves back onto a body: gas beside it is off the stream's pressure by up to {:.0} % of what \
                 bodies are pressed with, and forces are wrong by a part of that; move the side away{}",
                100.0 * most,
                if problem.method.fixed().is_none() && problem.stream_mach() > LEAVES {
                    ", or take points that stay (`scheme.motion = \"fixed\"`), beside which waves leave"
                } else {
                    ""
                }
            );
            Warning::new(About::Scene, text).beside((axis, end))
        })
    });
    lines.collect()
}

/// True of a side that the stream goes along more than across, and does not cross faster than sound.
fn runs_along<const D: usize>(problem: &Problem<D>, axis: usize, end: usize) -> bool {
    let stream = &problem.free_stream;
    let sound = problem.gas.sound_speed_at(stream.density, stream.pressure);
    let own = (axis, end);
    let mut openings = problem.domain.openings.iter();
    let across = stream.velocity[axis].abs();
    across < sound
        && 2.0 * across * across < stream.velocity.norm_squared()
        && !openings.any(|opening| (opening.axis, opening.end) == own)
}

/// True of gas at this Mach number beside a side that its waves leave by.
fn leaves<const D: usize>(problem: &Problem<D>, mach: f64) -> bool {
    D == 2 && problem.method.fixed().is_some() && mach.min(problem.stream_mach()) > LEAVES
}

/// Mean over the surface of what presses bodies over the stream's pressure, whatever its direction.
fn pressed(panels: &PanelFrame, own: &[usize], calm: f64) -> f64 {
    let sum = |of: &dyn Fn(usize) -> f64| own.iter().map(|&n| of(n) * panels.area[n]).sum::<f64>();
    sum(&|n| (panels.pressure[n] - calm).abs()) / sum(&|_| 1.0)
}

/// Part of the surface of bodies that some of the `places` send Mach lines to, or sound where the gas is slower.
fn felt(places: &[(f64, Place)], panels: &PanelFrame, own: &[usize]) -> f64 {
    let chosen = |count: usize| count.div_ceil(MOST).max(1);
    let places = || places.iter().step_by(chosen(places.len()));
    let (mut all, mut felt) = (0.0, 0.0);
    for &n in own.iter().step_by(chosen(own.len())) {
        all += panels.area[n];
        let middle = panels.middle(n);
        if places().any(|(_, place)| place.reaches(&middle)) {
            felt += panels.area[n];
        }
    }
    if all > 0.0 { felt / all } else { 0.0 }
}

impl Place {
    fn of(frame: &Frame, i: usize) -> Self {
        let velocity = frame.velocity[i];
        let speed = velocity.iter().map(|u| u * u).sum::<f64>().sqrt();
        Self {
            at: frame.position[i],
            way: velocity.map(|u| u / speed.max(f64::MIN_POSITIVE)),
            mach: frame.mach[i],
        }
    }

    /// True of a point within the Mach cone from here.
    fn reaches(&self, point: &[f64; 3]) -> bool {
        if self.mach <= 1.0 {
            return true;
        }
        let apart: [f64; 3] = std::array::from_fn(|k| point[k] - self.at[k]);
        let along: f64 = (0..3).map(|k| apart[k] * self.way[k]).sum();
        let square: f64 = apart.iter().map(|d| d * d).sum();
        // `tan² μ = 1 / (M² - 1)`.
        along > 0.0 && (square - along * along) * (self.mach * self.mach - 1.0) < along * along
    }
}

#[cfg(test)]
mod tests {
    use aero_solver::frame::Kind;

    use super::*;

    fn place(mach: f64) -> Place {
        let frame = Frame {
            position: vec![[0.0, 1.0, 0.0]],
            velocity: vec![[mach, 0.0, 0.0]],
            mach: vec![mach],
            kind: vec![Kind::Fluid as u8],
            ..Frame::default()
        };
        Place::of(&frame, 0)
    }

    /// At a Mach number of `sqrt 2` Mach lines go at 45 degrees.
    #[test]
    fn waves_go_back_within_mach_lines() {
        let fast = place(std::f64::consts::SQRT_2);
        assert!(fast.reaches(&[1.01, 0.0, 0.0]));
        assert!(!fast.reaches(&[0.99, 0.0, 0.0]) && !fast.reaches(&[-2.0, 0.9, 0.0]));
        assert!(place(0.8).reaches(&[-2.0, 0.0, 0.0]));
    }

    /// Four panels on a line below, of which the last two are reached.
    #[test]
    fn the_part_that_feels_it_is_that_of_the_area() {
        let panels = PanelFrame {
            corners: 2,
            points: (0..4)
                .flat_map(|n| [0.0, 0.5].map(|x| [0.5 * f64::from(n) + x, 0.0, 0.0]))
                .collect(),
            area: vec![0.5; 4],
            pressure: vec![1.0, 1.2, 0.8, 1.0],
            body: vec![0; 4],
            ..PanelFrame::default()
        };
        let own: Vec<usize> = (0..4).collect();
        let places = [(1.0, place(std::f64::consts::SQRT_2))];
        assert!((felt(&places, &panels, &own) - 0.5).abs() < 1e-12);
        assert!((pressed(&panels, &own, 1.0) - 0.1).abs() < 1e-12);
    }
}
