//! Gaps between bodies, and slots in one, that are too narrow for gas to flow through.

use aero_geometry::Vector;
use aero_geometry::parallel::prelude::*;
use aero_packer::{About, Warning};
use aero_solver::panels::{Panel, Panels};
use aero_solver::problem::Problem;

use super::sides::NARROW;
use super::{Check, place, shortened};

/// Narrower than this, in spacings, is no gap: the bodies touch.
const TOUCHES: f64 = 0.02;

/// So far over a surface, in spacings, is looked for what faces it: near by, for it may be thin, and as far as counts.
const HEIGHTS: [f64; 3] = [0.25, 0.5, 0.5 * NARROW];

/// Two surfaces face one another where the cosine of the angle between their normals is below this.
const FACING: f64 = -0.5;

/// Spacings across a gap from which on gas flows as it should.
const ACROSS: f64 = 4.0;

/// A gap: its width in spacings, and the panel that it is seen from.
type Gap<'a, const D: usize> = (f64, &'a Panel<D>);

/// Looks over the panels of each body for another body, or another part of it, that faces them.
pub(super) fn look<const D: usize>(problem: &Problem<D>, panels: &Panels<D>, found: &mut Check) {
    let bodies = &problem.bodies;
    for (number, body) in bodies.iter().enumerate() {
        for (before, other) in bodies[..=number].iter().enumerate() {
            let Some((width, panel)) = narrowest(problem, panels, [number, before]) else {
                continue;
            };
            let what = if before == number {
                format!("body `{}`: a slot in it is", body.name)
            } else {
                format!(
                    "bodies `{}` and `{}`: the gap between them is",
                    other.name, body.name
                )
            };
            let spacing = shortened(width * problem.resolution.at(&panel.centre) / ACROSS);
            found.warnings.push(Warning::new(
                About::Scene,
                format!(
                    "{what} {width:.2} spacings wide near {}: too narrow for gas to flow through as it should; close it, or choose a spacing of \
                     {spacing:.2e}, {ACROSS} to its width",
                    place(&panel.centre)
                ),
            ));
        }
    }
}

/// The narrowest gap over the panels of the first body of a pair to the second, which may be the same.
fn narrowest<'a, const D: usize>(
    problem: &Problem<D>,
    panels: &'a Panels<D>,
    [first, second]: [usize; 2],
) -> Option<Gap<'a, D>> {
    let other = &problem.bodies[second].shape;
    let reach = NARROW * problem.resolution.lattice();
    let bounds = other.bounds().grown(reach);
    let is_seen = |panel: &&Panel<D>| {
        panel.owner as usize == first
            && problem.domain.bounds.contains(&panel.centre)
            && bounds.contains(&panel.centre)
    };
    let seen: Vec<&Panel<D>> = panels.all().iter().filter(is_seen).collect();
    let widths: Vec<f64> = seen
        .par_iter()
        .map(|panel| width(problem, second, &panel.centre, &panel.normal))
        .collect();
    let gaps = widths.into_iter().zip(seen);
    gaps.filter(|(width, _)| *width < NARROW)
        .min_by(|a, b| a.0.total_cmp(&b.0))
}

/// How far, in spacings, what of body `other` faces a `place` on a surface with this `normal` is from it; infinite where nothing does.
fn width<const D: usize>(
    problem: &Problem<D>,
    other: usize,
    place: &Vector<D>,
    normal: &Vector<D>,
) -> f64 {
    let spacing = problem.resolution.at(place);
    let widths = HEIGHTS.map(|height| {
        let over = place + normal * (height * spacing);
        let seen = problem.bodies[other].shape.closest(&over);
        let width = height + seen.distance / spacing;
        if seen.normal.dot(normal) < FACING && width > TOUCHES {
            width
        } else {
            f64::INFINITY
        }
    });
    widths.into_iter().fold(f64::INFINITY, f64::min)
}
