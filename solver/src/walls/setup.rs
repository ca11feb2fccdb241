//! Ghosts as a run begins: those of the bodies and wall sides, and how the faces of thin parts see them.

use aero_geometry::Vector;
use aero_geometry::kernel::SMOOTHING_RATIO;
use aero_geometry::parallel::prelude::*;

use super::super::faces::{Faces, Sight, ThinParts, View, is_edge, thin_parts};
use super::super::records::Matrix;
use super::curvature::shape_operator;
use super::joints::join;
use super::plane::SideWall;
use super::{Ghost, Origin, Shown, WallAbove};
use crate::problem::Problem;

/// A foot that lies farther from the nearest point of the surface, as a part of the depth, is another one.
const ASIDE: f64 = 0.1;

/// So high over its foot, in spacings, a ghost's own face is the nearest.
const ABOVE: f64 = 0.1;

/// All ghosts of `problem` and its wall `sides`, views at the end; and the faces of thin parts.
pub fn ghosts<const D: usize>(
    problem: &Problem<D>,
    sides: &[SideWall<D>],
) -> (Vec<Ghost<D>>, Option<Faces<D>>) {
    let follows_the_bend = problem.scheme.wall.follows_the_bend;
    let mut ghosts = Vec::new();
    for (number, body) in problem.bodies.iter().enumerate() {
        for (g, &position) in body.ghosts.position.iter().enumerate() {
            let depth = -body.ghosts.distance[g];
            let mut ghost = blank(problem, position, body.ghosts.normal[g], depth);
            ghost.volume = body.ghosts.volume[g] * modelled_share(problem, &position);
            ghost.reference_mass = ghost.shown.density * ghost.volume;
            ghost.body = number as u32;
            ghost.layer = body.ghosts.layer[g];
            let reached = body.shape.signed_distance(&ghost.mirror());
            ghost.has_mirror = (reached - depth).abs() < 0.1 * depth;
            ghosts.push(ghost);
        }
        if follows_the_bend {
            let first = ghosts.len() - body.ghosts.position.len();
            ghosts[first..]
                .par_iter_mut()
                .zip(&body.ghosts.face)
                .for_each(|(ghost, &face)| {
                    // On a ridge another face is as near, or another place of the same one.
                    let seen = body.shape.closest(&ghost.position);
                    let aside = (seen.point - ghost.foot()).norm();
                    let is_own = seen.face == face && aside < ASIDE * ghost.depth;
                    let lift = ghost.normal * (ABOVE * problem.resolution.at(&ghost.position));
                    let place = if is_own {
                        ghost.position
                    } else {
                        ghost.foot() + lift
                    };
                    ghost.origin.curvature =
                        shape_operator(&body.shape, &place, problem.resolution.at(&ghost.position));
                });
        }
    }
    let inside_a_body = |position: &Vector<D>| {
        // What is under a body at rest closes the corner with it.
        let moving = problem.bodies.iter().filter(|body| body.motion.is_moving());
        let mut shapes = moving.map(|body| &body.shape);
        shapes.any(|shape| shape.signed_distance(position) < 0.0)
    };
    for (number, side) in sides.iter().enumerate() {
        for point in &side.ghosts {
            if inside_a_body(&point.position) {
                continue;
            }
            let mut ghost = blank(problem, point.position, point.normal, point.depth);
            ghost.body = (problem.bodies.len() + number) as u32;
            ghost.layer = point.layer;
            ghosts.push(ghost);
        }
    }
    join(problem, &mut ghosts);
    let thin = problem
        .scheme
        .wall
        .surface_tags
        .then(|| thin_parts(problem))
        .flatten();
    if let Some(ThinParts { views, hidden, .. }) = &thin {
        let originals = ghosts.clone();
        let mut first = 0;
        for (number, hidden) in hidden.iter().enumerate() {
            for (ghost, &faces) in ghosts[first..].iter_mut().zip(hidden) {
                ghost.sight.hidden = faces;
            }
            let views = views.par_iter().filter(|view| view.body == number);
            let seen: Vec<Ghost<D>> = views
                .map(|view| seen_by_face(problem, &originals[first + view.ghost], view))
                .collect();
            ghosts.extend(seen);
            first += hidden.len();
        }
    }
    // What no gas sees, or another solid fills.
    ghosts.retain(|ghost| ghost.volume > 0.0);
    (ghosts, thin.map(|thin| thin.faces))
}

/// A ghost in the free stream's state.
fn blank<const D: usize>(
    problem: &Problem<D>,
    position: Vector<D>,
    normal: Vector<D>,
    depth: f64,
) -> Ghost<D> {
    let gas = &problem.free_stream;
    let spacing = problem.resolution.at(&position);
    let volume = spacing.powi(D as i32);
    Ghost {
        position,
        normal,
        origin: Origin {
            position,
            normal,
            curvature: Matrix::zeros(),
        },
        depth,
        volume,
        reference_mass: gas.density * volume,
        has_mirror: true,
        body: 0,
        layer: 0,
        sight: Sight::default(),
        wall: WallAbove::at_rest(),
        shown: Shown {
            velocity: Vector::zeros(),
            strain: Matrix::zeros(),
            pressure: gas.pressure,
            wall_pressure: gas.pressure,
            energy: problem.gas.energy(gas.density, gas.pressure),
            density: gas.density,
            density_gradient: Vector::zeros(),
            smoothing_length: SMOOTHING_RATIO * spacing,
            second: 0.0,
        },
    }
}

/// The part of a ghost that belongs to the modelled side of all symmetry planes: one half of it for each plane that it
/// lies on. Its images, at the same place, are the rest.
fn modelled_share<const D: usize>(problem: &Problem<D>, position: &Vector<D>) -> f64 {
    let planes = problem.domain.each_side().filter(|(axis, _, side, plane)| {
        side.is_mirror() && (position[*axis] - plane).abs() < 1e-9 * problem.resolution.at(position)
    });
    0.5_f64.powi(planes.count() as i32)
}

/// `ghost` as another face sees it.
fn seen_by_face<const D: usize>(
    problem: &Problem<D>,
    ghost: &Ghost<D>,
    view: &View<D>,
) -> Ghost<D> {
    let body = &problem.bodies[view.body];
    let mut seen = blank(problem, view.position, view.normal, view.depth);
    seen.volume = ghost.volume;
    seen.reference_mass = ghost.reference_mass;
    seen.body = ghost.body;
    // Only what lies in the body counts as its wall layer.
    seen.layer = ((view.depth / body.report.spacing) as u32).max(u32::from(view.continues));
    seen.sight = view.sight;
    let reached = body.shape.signed_distance(&seen.mirror());
    seen.has_mirror = (reached - view.depth).abs() < 0.1 * view.depth;
    if problem.scheme.wall.follows_the_bend {
        let above = seen.foot() + view.normal * (0.1 * problem.resolution.at(&seen.foot()));
        // The plane of a face goes on beyond the body's tip, where nothing bends.
        let shape = body.shape.as_ref();
        if !is_edge(shape, &shape.closest(&above), problem.resolution.at(&above)) {
            seen.origin.curvature = shape_operator(shape, &above, problem.resolution.at(&above));
        }
    }
    seen
}
