//! Shocks that may reach an inlet: how far ahead of a blunt front they stand.

use aero_geometry::Vector;
use aero_solver::panels::{Panel, Panels};
use aero_solver::problem::{Body, Problem, Side};

/// Stand-off over radius, `a exp(b / M^2)`, of spheres [Billig 1967].
const ROUND: [f64; 2] = [0.143, 3.24];

/// Of cylinders across the stream [Billig 1967].
const PLANE: [f64; 2] = [0.386, 4.67];

/// The shock wants so much more room than theory says: it swings out on its way.
const ROOM: f64 = 1.3;

/// Below this part of the widest front a blunt spot is a rounded edge.
const SPOT: f64 = 1.5;

/// A body's own surface is left by so many spacings before one looks for what stands before it, in strides of at least so many.
const OFF: f64 = 0.5;
const STRIDE: f64 = 0.25;

/// A warning where a detached shock may come to an inlet.
pub(super) fn look<const D: usize>(problem: &Problem<D>, panels: &Panels<D>) -> Vec<String> {
    let stream = &problem.free_stream;
    let speed = stream.velocity.norm();
    let mach = speed / problem.gas.sound_speed_at(stream.density, stream.pressure);
    let inlets = problem.domain.each_side().filter(|(axis, end, side, _)| {
        side.keeps_free_stream() && [1.0, -1.0][*end] * stream.velocity[*axis] > 0.1 * speed
    });
    let inlets: Vec<_> = inlets.collect();
    if speed == 0.0 || inlets.is_empty() {
        return Vec::new();
    }
    if mach <= 1.0 {
        return Vec::new();
    }
    let along = stream.velocity / speed;
    let steepest = largest_turn(mach).sin();
    let mut lines = Vec::new();
    for (number, body) in problem.bodies.iter().enumerate() {
        let blunt = panels.all().iter().filter(|panel| {
            panel.owner as usize == number
                && problem.domain.bounds.contains(&panel.centre)
                && -panel.normal.dot(&along) > steepest
        });
        let mut front = Front {
            panels: blunt.collect(),
            along,
        };
        if front.lines(problem, body, mach, &inlets).is_empty() {
            continue;
        }
        front.panels.retain(|panel| meets(problem, panel, &along));
        lines.extend(front.lines(problem, body, mach, &inlets));
    }
    lines
}

/// What of a body turns the stream by more than a shock that is attached can.
struct Front<'a, const D: usize> {
    panels: Vec<&'a Panel<D>>,
    /// Direction of the stream.
    along: Vector<D>,
}

impl<const D: usize> Front<'_, D> {
    /// A line for each of the `inlets` that the shock may come to.
    fn lines(
        &self,
        problem: &Problem<D>,
        body: &Body<D>,
        mach: f64,
        inlets: &[(usize, usize, Side, f64)],
    ) -> Vec<String> {
        let along = &self.along;
        let depth = |panel: &&Panel<D>| panel.centre.dot(along);
        let Some(first) = self.panels.iter().map(depth).reduce(f64::min) else {
            return Vec::new();
        };
        let radius = self.radius(problem, body);
        if radius < SPOT * problem.resolution.lattice() {
            return Vec::new();
        }
        let is_round = D == 3 || problem.domain.is_axisymmetric();
        let [a, b] = if is_round { ROUND } else { PLANE };
        let stand_off = radius * a * (b / (mach * mach)).exp();
        let near = inlets.iter().filter_map(|&(axis, end, _, face)| {
            let leading = self.panels.iter().filter(|p| depth(p) < first + radius);
            let room = leading
                .map(|panel| [1.0, -1.0][end] * (panel.centre[axis] - face))
                .fold(f64::INFINITY, f64::min);
            (room < ROOM * stand_off).then(|| {
                format!(
                    "body `{}`: its shock may reach the inlet `{}`: it stands about {stand_off:.3e} ahead of the front, and \
                     there is room for {room:.3e}; move the side to {:.4}",
                    body.name,
                    super::side_name(axis, end),
                    face - [1.0, -1.0][end] * (2.0 * ROOM * stand_off - room)
                )
            })
        });
        near.collect()
    }

    /// Of the sphere or cylinder that faces as much of the stream.
    fn radius(&self, problem: &Problem<D>, body: &Body<D>) -> f64 {
        let faced = self
            .panels
            .iter()
            .map(|p| -p.normal.dot(&self.along) * p.size);
        let extent = body.shape.bounds();
        let mirrors = problem.domain.each_side().filter(|(axis, _, side, plane)| {
            side.is_mirror() && extent.min[*axis] < *plane && *plane < extent.max[*axis]
        });
        let whole = faced.sum::<f64>() * 2_f64.powi(mirrors.count() as i32);
        if D == 3 {
            (whole / std::f64::consts::PI).sqrt()
        } else {
            0.5 * whole
        }
    }
}

/// True of a panel that the stream comes to without a body before it.
fn meets<const D: usize>(problem: &Problem<D>, panel: &Panel<D>, along: &Vector<D>) -> bool {
    let spacing = problem.resolution.lattice();
    let mut ahead = OFF * spacing;
    loop {
        let point = panel.centre - along * ahead;
        if !problem.domain.bounds.contains(&point) {
            return true;
        }
        let shapes = problem.bodies.iter().map(|body| &body.shape);
        let nearest = shapes
            .map(|shape| shape.signed_distance(&point))
            .fold(f64::INFINITY, f64::min);
        if nearest < 0.0 {
            return false;
        }
        ahead += nearest.max(STRIDE * spacing);
    }
}

/// The largest angle (radians) by which a shock at `mach` turns a diatomic stream: beyond it the shock is detached [NACA 1135,
/// eq. 139a].
fn largest_turn(mach: f64) -> f64 {
    let square = mach * mach;
    let turn = |wave: f64| {
        let normal = square * wave.sin().powi(2) - 1.0;
        (2.0 / wave.tan() * normal / (square * (1.4 + (2.0 * wave).cos()) + 2.0)).atan()
    };
    let first = (1.0 / mach).asin();
    let waves = (0..=400).map(|n| first + (1.55 - first) * f64::from(n) / 400.0);
    waves.map(turn).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::told;

    /// A plate 0.6 wide across the stream, a third of its width behind the inlet, maybe a larger one before it.
    #[test]
    fn a_front_in_the_lee_of_another_body_throws_no_shock_at_the_inlet() {
        let plate = |name: &str, x: f64, half: f64| {
            format!(
                "[[body]]\nname = \"{name}\"\nshape = {{ rectangle = {{ width = 0.1, height = {} }} }}\n\
                 place = {{ translate = [{x}, 0.0] }}\n",
                2.0 * half
            )
        };
        let scene = |bodies: &str| {
            format!(
                "dimension = 2\nspacing = 0.05\nend_time = 1.0\n[free_stream]\nmach = 2.0\ndensity = 1.4\npressure = 1.0\n\
                 [domain]\nmin = [-0.25, -1.0]\nmax = [1.0, 1.0]\n[domain.sides]\nx_min = \"inlet\"\nx_max = \"outlet\"\n\
                 y_min = \"free-stream\"\ny_max = \"free-stream\"\n{bodies}"
            )
        };
        let warned = |bodies: &str| {
            let lines = told(&scene(bodies), &[]);
            let about = |name: &str| {
                let words = format!("`{name}`: its shock may reach the inlet");
                lines.iter().any(|line| line.contains(&words))
            };
            ["back", "front"].map(about)
        };
        let back = plate("back", 0.0, 0.3);
        assert_eq!(warned(&back), [true, false]);
        let front = plate("front", -0.15, 0.35);
        assert_eq!(warned(&(back.clone() + &front)), [false, true]);
        // What a smaller one lets by is met; itself it is no front, a spacing across.
        let small = plate("front", -0.15, 0.05);
        assert_eq!(warned(&(back + &small)), [true, false]);
    }

    #[test]
    fn the_largest_turn_is_that_of_the_tables() {
        for (mach, degrees) in [(2.0, 22.97), (3.0, 34.07)] {
            let found = largest_turn(mach).to_degrees();
            assert!((found - degrees).abs() < 0.02, "{mach}: {found}");
        }
    }
}
