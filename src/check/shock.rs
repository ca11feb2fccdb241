//! Shocks that may reach an inlet: how far ahead of a blunt front they stand.

use aero_solver::panels::{Panel, Panels};
use aero_solver::problem::Problem;

/// Stand-off over radius, `a exp(b / M^2)`, of spheres [Billig 1967].
const ROUND: [f64; 2] = [0.143, 3.24];

/// Of cylinders across the stream [Billig 1967].
const PLANE: [f64; 2] = [0.386, 4.67];

/// The shock wants so much more room than theory says: it swings out on its way.
const ROOM: f64 = 1.3;

/// Below this part of the widest front a blunt spot is a rounded edge.
const SPOT: f64 = 1.5;

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
        let blunt: Vec<&Panel<D>> = panels
            .all()
            .iter()
            .filter(|panel| {
                panel.owner as usize == number
                    && problem.domain.bounds.contains(&panel.centre)
                    && -panel.normal.dot(&along) > steepest
            })
            .collect();
        let Some(first) = blunt.iter().map(|p| p.centre.dot(&along)).reduce(f64::min) else {
            continue;
        };
        // What faces the stream of the front.
        let area: f64 = blunt.iter().map(|p| -p.normal.dot(&along) * p.size).sum();
        let is_round = D == 3 || problem.domain.is_axisymmetric();
        let mirrors = problem.domain.each_side();
        let cut = mirrors.filter(|(axis, _, side, plane)| {
            let extent = body.shape.bounds();
            side.is_mirror() && extent.min[*axis] < *plane && *plane < extent.max[*axis]
        });
        let whole = area * 2_f64.powi(cut.count() as i32);
        let (radius, [a, b]) = match (is_round, D) {
            (true, 3) => ((whole / std::f64::consts::PI).sqrt(), ROUND),
            (true, _) => (0.5 * whole, ROUND),
            _ => (0.5 * whole, PLANE),
        };
        if radius < SPOT * problem.resolution.lattice() {
            continue;
        }
        let stand_off = radius * a * (b / (mach * mach)).exp();
        for &(axis, end, _, face) in &inlets {
            let room = blunt
                .iter()
                .filter(|panel| panel.centre.dot(&along) < first + radius)
                .map(|panel| [1.0, -1.0][end] * (panel.centre[axis] - face))
                .fold(f64::INFINITY, f64::min);
            if room < ROOM * stand_off {
                lines.push(format!(
                    "body `{}`: its shock may reach the inlet `{}`: it stands about {stand_off:.3e} ahead of the front, and \
                     there is room for {room:.3e}; move the side to {:.4}",
                    body.name,
                    super::side_name(axis, end),
                    face - [1.0, -1.0][end] * (2.0 * ROOM * stand_off - room)
                ));
            }
        }
    }
    lines
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

    #[test]
    fn the_largest_turn_is_that_of_the_tables() {
        for (mach, degrees) in [(2.0, 22.97), (3.0, 34.07)] {
            let found = largest_turn(mach).to_degrees();
            assert!((found - degrees).abs() < 0.02, "{mach}: {found}");
        }
    }
}
