//! Gas that a step has carried through the surface of a wall, as a shock in the first moments of a run may: it comes back as off a
//! mirror, no deeper than it went, and no longer moves into the wall. Ghosts alone press it out too, but slowly, and out of a hollow
//! in three dimensions some of it never.

use aero_geometry::Vector;
use aero_geometry::parallel::prelude::*;

use super::rigid::Pose;
use super::{Walls, wall_sides};
use crate::books::Books;
use crate::frame::Totals;
use crate::particles::{Columns, Particle, Particles};
use crate::problem::Problem;
use crate::rings::Rings;
use crate::sides::closed::reflections;

/// What lies deeper than this, in spacings, has not come there in a step: it is left to be told as a leak.
const DEEPEST: f64 = 2.0;

/// Walls that meet may each send a particle into the other.
const TRIES: usize = 3;

/// Where a wall is above a particle that is in it.
struct Hit<const D: usize> {
    /// Number of the wall.
    wall: usize,
    normal: Vector<D>,
    depth: f64,
    /// Where it comes back to.
    to: Vector<D>,
    velocity: Vector<D>,
}

/// Walls that send a particle back, each with what that changes of its velocity.
type Strikes<const D: usize> = [Option<(usize, Vector<D>)>; TRIES];

/// Number of a particle that walls send back, and what becomes of it.
type Change<const D: usize> = (usize, Particle<D>, Strikes<D>);

/// Brings the gas that is in walls at `time`, the end of a step, back, and books the impulse. The columns still hold the step.
pub fn rebound<const D: usize>(
    problem: &Problem<D>,
    time: f64,
    fluid: &mut Particles<D>,
    walls: &mut Walls<D>,
    books: &mut Books,
) {
    if walls.body_count() == 0 {
        return;
    }
    let poses: Vec<Pose<D>> = (0..walls.body_count())
        .map(|number| walls.pose(number, time))
        .collect();
    let sides = wall_sides(&problem.domain);
    let hit = |position: &Vector<D>, before: &Vector<D>| {
        let bodies = problem.bodies.iter().zip(&poses).enumerate();
        let mut hits = bodies.filter_map(|(wall, (body, pose))| {
            let origin = pose.origin(position);
            if !body.shape.bounds().contains(&origin) {
                return None;
            }
            let mut seen = body.shape.closest(&origin);
            if seen.distance >= 0.0 {
                return None;
            }
            let mut to = seen.point - seen.normal * seen.distance;
            let from = pose.origin(before);
            if (from - seen.point).dot(&seen.normal) < 0.0 {
                // The near face of a thin part may be the far one by now.
                let start = body.shape.closest(&from);
                if start.distance >= 0.0 {
                    to = from;
                    seen.normal = start.normal;
                }
            }
            Some(Hit {
                wall,
                normal: pose.direction(&seen.normal),
                depth: -seen.distance,
                to: pose.position(&to),
                velocity: pose.velocity(position),
            })
        });
        let of_sides = || {
            let own = poses.iter().enumerate().skip(problem.bodies.len());
            let sides = sides.iter().zip(own);
            let mut hits = sides.filter_map(|(&(axis, end), (wall, pose))| {
                let inward = [1.0, -1.0][end];
                let origin = pose.origin(position)[axis];
                let depth = inward * (problem.domain.face(axis, end) - origin);
                let mut normal = Vector::zeros();
                normal[axis] = inward;
                let is_open = || problem.domain.part_at(axis, end, position).is_some();
                (depth > 0.0 && !is_open()).then(|| Hit {
                    wall,
                    normal,
                    depth,
                    to: position + normal * (2.0 * depth),
                    velocity: pose.velocity(position),
                })
            });
            hits.next()
        };
        hits.next().or_else(of_sides)
    };
    let Columns {
        state,
        saved,
        rates,
        ..
    } = fluid.columns();
    let changes: Vec<Change<D>> = state
        .par_iter()
        .zip(saved)
        .zip(&*rates)
        .enumerate()
        .filter_map(|(n, ((particle, before), rates))| {
            // Only what walls press can be in one.
            if rates.wall_acceleration.norm_squared() == 0.0 {
                return None;
            }
            let (mut back, mut strikes) = (*particle, Strikes::default());
            for strike in &mut strikes {
                let Some(hit) = hit(&back.position, &before.position) else {
                    break;
                };
                if hit.depth > DEEPEST * problem.resolution.at(&hit.to) {
                    return None;
                }
                back.position = hit.to;
                let inward = (back.velocity - hit.velocity).dot(&hit.normal).min(0.0);
                let change = hit.normal * (-2.0 * inward);
                back.velocity += change;
                *strike = Some((hit.wall, change));
                let inward = back.by_pressure.acceleration.dot(&hit.normal).min(0.0);
                back.by_pressure.acceleration -= hit.normal * (2.0 * inward);
            }
            (back.position != particle.position).then_some((n, back, strikes))
        })
        .collect();
    send_back(problem, time, (state, changes), walls, books);
}

/// Puts the gas that walls send back where they send it, and books what that gives gas and walls.
fn send_back<const D: usize>(
    problem: &Problem<D>,
    time: f64,
    (state, changes): (&mut [Particle<D>], Vec<Change<D>>),
    walls: &mut Walls<D>,
    books: &mut Books,
) {
    let rings = Rings::new(problem);
    let mut received = Totals::default();
    for (n, back, strikes) in changes {
        let particle = &mut state[n];
        for (wall, change) in strikes.into_iter().flatten() {
            let impulse = change * (-back.mass * rings.circumference(&back.position));
            let extent = problem.bodies.get(wall).map(|body| body.shape.bounds());
            for (sign, shift) in reflections(&problem.domain, extent.as_ref()) {
                let whole = rings.axial(sign.component_mul(&impulse));
                let at = rings.axial(sign.component_mul(&back.position) + shift);
                walls.strike(wall, &whole, &at, time);
            }
        }
        let kinetic = 0.5 * (back.velocity.norm_squared() - particle.velocity.norm_squared());
        received.energy += particle.mass * kinetic;
        for k in 0..D {
            received.momentum[k] += particle.mass * (back.velocity[k] - particle.velocity[k]);
        }
        *particle = back;
        books.extremes.returned += 1;
    }
    books.receive(&received);
}
