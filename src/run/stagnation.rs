//! Gas that comes to rest before a body with less pressure than a bow shock leaves it: cells that the shock stands in are too large.

use aero_geometry::Vector;
use aero_packer::{About, Warning};
use aero_solver::frame::{Frame, Kind};
use aero_solver::gas::Gas;
use aero_solver::method::{Method, Time};
use aero_solver::problem::{Problem, Side};

/// Part of the pressure that may be missing without a word.
const WORTH: f64 = 0.05;

/// Mach number below which gas has come to rest, and above which a stream has a bow shock.
const AT_REST: f64 = 0.3;
const FAST: f64 = 1.2;

/// Gas at rest with less than this part of the pressure circles behind a body.
const BEFORE: f64 = 0.5;

/// Least step upstream in search of a body, spacings.
const STEP: f64 = 0.1;

/// What there is to say of the stagnation pressure of a steady flow as it stands in `frame`.
pub(super) fn warnings<const D: usize>(problem: &Problem<D>, frame: &Frame) -> Vec<Warning> {
    let Gas::Ideal(gas) = problem.gas else {
        return Vec::new();
    };
    let stream = &problem.free_stream;
    let mach = problem.stream_mach();
    let is_one_stream =
        problem.domain.openings.is_empty() && !problem.domain.has(Side::is_reservoir);
    let settles = matches!(problem.method, Method::Fixed(points) if points.time == Time::Settle);
    let is_asked = settles && !problem.bodies.is_empty() && is_one_stream;
    if !is_asked || gas.transport.is_some() || mach < FAST {
        return Vec::new();
    }
    // No steady shocks cost a stream more than a normal one: whatever comes to rest has at least what is left behind that.
    let pressure = stream.pressure * pitot(mach, gas.gamma);
    let is_before = |&i: &usize| {
        frame.kind[i] == Kind::Fluid as u8
            && frame.mach[i] < AT_REST
            && frame.pressure[i] > BEFORE * pressure
    };
    let left = |i: usize| frame.pressure[i] * at_rest(frame.mach[i], gas.gamma) / pressure;
    let lacks = |&i: &usize| is_before(&i) && left(i) <= 1.0 - WORTH;
    let mut lacking: Vec<usize> = (0..frame.kind.len()).filter(lacks).collect();
    lacking.sort_by(|&a, &b| left(a).total_cmp(&left(b)));
    let place = |i: usize| Vector::from_fn(|k, _| frame.position[i][k]);
    let first = lacking.into_iter().find(|&i| !is_behind(problem, place(i)));
    let Some(least) = first else {
        return Vec::new();
    };
    let left = left(least);
    let place: Vec<String> = frame.position[least][..D]
        .iter()
        .map(|x| format!("{x:.4}"))
        .collect();
    let text = format!(
        "gas that comes to rest at ({}) has {:.1} % less pressure than a normal shock leaves it: the bow shock stands in cells too large for \
         it, and pressures behind it are too low; add points, `scheme.refine`, or halve the spacing",
        place.join(", "),
        100.0 * (1.0 - left)
    );
    vec![Warning::new(About::Scene, text)]
}

/// True of a place that the stream gets to through a body: a wake that closes has gas at rest too.
fn is_behind<const D: usize>(problem: &Problem<D>, mut place: Vector<D>) -> bool {
    let Some(against) = (-problem.free_stream.velocity).try_normalize(0.0) else {
        return false;
    };
    let shapes = || problem.bodies.iter().map(|body| &body.shape);
    while problem.domain.bounds.contains(&place) {
        let distances = shapes().map(|shape| shape.signed_distance(&place));
        let free = distances.fold(f64::INFINITY, f64::min);
        if free < 0.0 {
            return true;
        }
        place += against * free.max(STEP * problem.resolution.lattice());
    }
    false
}

/// Pressure of gas brought to rest over that at Mach number `mach`, `(1 + (gamma - 1) / 2 M^2)^(gamma / (gamma - 1))` [NACA Report 1135 (1953), eq. 44].
fn at_rest(mach: f64, gamma: f64) -> f64 {
    (1.0 + 0.5 * (gamma - 1.0) * mach * mach).powf(gamma / (gamma - 1.0))
}

/// Pressure of gas that comes to rest behind a normal shock over that in front, at Mach number `mach` above one,
/// `((gamma + 1) / 2 M^2)^(gamma / (gamma - 1)) ((gamma + 1) / (2 gamma M^2 - (gamma - 1)))^(1 / (gamma - 1))` [Rayleigh 1910; NACA Report 1135 (1953), eq. 100].
fn pitot(mach: f64, gamma: f64) -> f64 {
    let square = mach * mach;
    let behind = (gamma + 1.0) / (2.0 * gamma * square - (gamma - 1.0));
    (0.5 * (gamma + 1.0) * square).powf(gamma / (gamma - 1.0)) * behind.powf(1.0 / (gamma - 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;

    const SCENE: &str = r#"
dimension = 2
spacing = 0.1
end_time = 1.0
stop = "steady"
[scheme]
motion = "fixed"
[free_stream]
mach = 3.0
density = 1.4
pressure = 1.0
[domain]
min = [-2.0, 0.0]
max = [0.0, 3.0]
[domain.sides]
x_min = "inlet"
x_max = "outlet"
y_min = "axis"
y_max = "free-stream"
[[body]]
name = "sphere"
shape = { sphere = { radius = 1.0 } }
"#;

    fn told(scene: &str, mach: f64, pressure: f64) -> Vec<Warning> {
        told_at(-1.05, scene, mach, pressure)
    }

    fn told_at(x: f64, scene: &str, mach: f64, pressure: f64) -> Vec<Warning> {
        let scene = Scene::parse(scene, "sphere", std::path::Path::new("")).unwrap();
        let problem = scene.build::<2>().unwrap().problem;
        let frame = Frame {
            position: vec![[-1.5, 0.05, 0.0], [x, 0.05, 0.0]],
            pressure: vec![9.0, pressure],
            mach: vec![0.5, mach],
            kind: vec![Kind::Fluid as u8; 2],
            ..Frame::default()
        };
        warnings(&problem, &frame)
    }

    /// NACA Report 1135 (1953), table II: 12.061 at Mach 3.
    #[test]
    fn pressure_that_is_missing_before_a_nose_is_told_with_its_place() {
        assert!((pitot(3.0, 1.4) - 12.061).abs() < 1e-3);
        let line = told(SCENE, 0.0, 11.0)[0].to_string();
        assert!(line.contains("(-1.0500, 0.0500) has 8.8 % less"), "{line}");
        // What the gas still has in speed counts.
        let moving = 11.9 / at_rest(0.25, 1.4);
        assert!(told(SCENE, 0.25, moving).is_empty());
        // Gas that slides along a cone has not come to rest.
        assert!(told(SCENE, 0.5, 11.0).is_empty());
        // Nor has what closes a wake come from before the body.
        let whole = SCENE.replace("max = [0.0, 3.0]", "max = [3.0, 3.0]");
        assert!(!told(&whole, 0.0, 9.0).is_empty());
        assert!(told_at(1.5, &whole, 0.0, 9.0).is_empty());
        let marched = SCENE.replace("stop = \"steady\"\n", "");
        assert!(told(&marched, 0.0, 11.0).is_empty());
        let slow = SCENE.replace("mach = 3.0", "mach = 1.1");
        assert!(told(&slow, 0.0, 1.0).is_empty());
    }
}
