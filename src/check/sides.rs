//! Bodies and the sides of the domain: ends in buffers, free-stream sides that are crossed, sides that are near.

use aero_geometry::Vector;
use aero_packer::{About, Warning};
use aero_solver::layers::BUFFER;
use aero_solver::panels::{Panel, Panels};
use aero_solver::problem::{AXES, Problem, Side};

use super::{Check, place, side_name};

/// A wall that faces out of the domain by this cosine ends there.
const OUTWARD: f64 = 0.7;

/// Beyond a side by less than this, in spacings, is on it.
const ON_IT: f64 = 0.25;

/// Corners of panels that a side has cut lie this near to it, in spacings.
const CUT: f64 = 1e-6;

/// A free stream that crosses a side by less than this part of its speed goes along it.
const ALONG: f64 = 0.1;

/// A body nearer to an open side than the kernel reaches, in spacings, has less gas beside it than it feels.
const NEAR: f64 = 5.0;

/// A gap to a closed side that is narrower than this, in spacings, holds too few particles to flow.
pub(super) const NARROW: f64 = 2.0;

/// Looks at each body and each side.
pub(super) fn look<const D: usize>(problem: &Problem<D>, panels: &Panels<D>, found: &mut Check) {
    let domain = &problem.domain;
    let spacing = problem.resolution.lattice();
    let speed = problem.free_stream.velocity.norm();
    let reach = (BUFFER as f64 + 1.0) * spacing;
    for (number, body) in problem.bodies.iter().enumerate() {
        let own: Vec<&Panel<D>> = panels
            .all()
            .iter()
            .filter(|panel| panel.owner as usize == number)
            .collect();
        if body.motion.is_moving() {
            continue;
        }
        for (axis, end, side, face) in domain.each_side() {
            let name = side_name(axis, end);
            let depth = |point: &Vector<D>| [face - point[axis], point[axis] - face][end];
            let meets_gas = |panel: &Panel<D>| {
                let others = domain.each_side().filter(|(k, ..)| *k != axis);
                // Beyond a side that gas comes in by there is some as far as its buffer goes; what is beyond an outlet has left.
                let mut beyond = others.map(|(k, e, side, face)| {
                    let x = panel.centre[k];
                    ([face - x, x - face][e], side)
                });
                beyond.all(|(depth, side)| depth <= 0.0 || side.lets_in() && depth < reach)
            };
            let past = own
                .iter()
                .filter(|panel| depth(&panel.centre) > ON_IT * spacing && meets_gas(panel));
            let past: Vec<_> = past.collect();
            let crosses_along = side == Side::FreeStream
                && problem.free_stream.velocity[axis].abs() < ALONG * speed;
            if let (true, Some(panel)) = (crosses_along, past.first()) {
                found.refusals.push(format!(
                    "body `{}`: passes through the free-stream side `{name}`, near {}: the stream beyond \
                     would flow through it; move the side away from the body, or make it symmetry, wall or body",
                    body.name,
                    place(&panel.centre)
                ));
                continue;
            }
            let ends = past.iter().find(|panel| {
                side.is_open()
                    && problem.method.fixed().is_none()
                    && [-1.0, 1.0][end] * panel.normal[axis] > OUTWARD
                    && depth(&panel.centre) < reach
            });
            if let Some(panel) = ends {
                let clear = face + [-1.0, 1.0][end] * reach;
                found.refusals.push(format!(
                    "body `{}`: ends inside the buffer of side `{name}`, near {}: gas would leak around its end; \
                     carry it on past {} = {clear:.4}, or let it end inside the domain",
                    body.name,
                    place(&panel.centre),
                    AXES[axis],
                ));
                continue;
            }
            if !past.is_empty() || (side == Side::Body) || side.is_periodic() {
                continue;
            }
            let inside = || {
                let own = own.iter();
                own.filter(|panel| domain.bounds.contains(&panel.centre))
            };
            // Panels end at closed sides, the body that runs through them does not.
            let extent = body.shape.bounds();
            let goes_on = [face - extent.min[axis], extent.max[axis] - face][end] > 0.0;
            let meets = |panel: &&Panel<D>| {
                let mut corners = panel.corners.iter();
                corners.any(|corner| depth(corner).abs() < CUT * spacing)
            };
            if goes_on && inside().any(meets) {
                continue;
            }
            let nearest = inside()
                .filter(|panel| [-1.0, 1.0][end] * panel.normal[axis] > 0.0)
                .map(|panel| -depth(&panel.centre))
                .fold(f64::INFINITY, f64::min);
            let said = near(problem, side, nearest);
            found.warnings.extend(said.map(|(what, mend)| {
                let text = format!("body `{}`: {what} the side `{name}`, {mend}", body.name);
                Warning::new(About::Scene, text)
            }));
        }
    }
}

/// What there is to say of a body whose `nearest` end stands so far before a side: where it is, and why that is worth a word, with the mend.
fn near<const D: usize>(
    problem: &Problem<D>,
    side: Side,
    nearest: f64,
) -> Option<(String, String)> {
    let stays = problem.method.fixed().is_some();
    let gap = nearest / problem.resolution.lattice();
    let (least, why) = if stays {
        (NARROW, "too near for gas to flow between them")
    } else {
        (NEAR, "nearer than a particle feels")
    };
    if side.is_open() && gap.abs() < CUT {
        // To points it is a body that the side cuts.
        let mend = "behind which gas presses its end; carry it on beyond, or move the side away";
        (!stays).then(|| ("ends on".into(), mend.into()))
    } else if side.is_open() && gap < least {
        let mend = format!("{why}; move the side away");
        Some((format!("is {gap:.1} spacings from"), mend))
    } else if side == Side::Symmetry && gap.abs() <= ON_IT {
        let mend = "and its forces are its own, without those of its image; let it go through, and they are those of the whole";
        Some(("stands on".into(), mend.into()))
    } else if !side.is_open() && ON_IT < gap && gap < NARROW {
        let finer = nearest / (2.0 * NARROW);
        let mend = format!("too narrow for gas to flow; close it or take a spacing of {finer:.3e}");
        Some((format!("leaves a gap of {gap:.1} spacings to"), mend))
    } else {
        None
    }
}
