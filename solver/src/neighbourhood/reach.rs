//! How wide a kernel may grow in rarefied gas, so that it never looks through the ghosts of a wall, past
//! the buffer of an open side or twice at the same particle.

use aero_geometry::Vector;
use aero_geometry::kernel::{SMOOTHING_RATIO, SUPPORT};
use aero_geometry::parallel::prelude::*;

use crate::layers::GHOSTS;
use crate::neighbours::{GROWTH, Lists};
use crate::particles::Particle;
use crate::problem::{Domain, Problem};
use crate::records::{Near, Records};

/// Largest smoothing length at a wall, relative to that of the starting lattice. A wider kernel would
/// look through the five layers of ghosts, and a lone particle in rarefied gas would no longer feel
/// the wall: at 1.5 the layers still hold 99 % of the kernel behind a wall.
const AT_WALLS: f64 = 1.5;

/// Layers of ghosts behind a wall, and what a buffer of an open side holds at least, in spacings.
pub const LAYERS: f64 = GHOSTS as f64;

/// Largest smoothing length anywhere, relative to that of the starting lattice, by dimension: every
/// search for neighbours reaches as far as the widest kernel.
const ANYWHERE: [f64; 3] = [1000.0, 4.0, 2.5];

/// Holds back the smoothing lengths of `particles`, the fluid, by this step's neighbour lists: only what has grown beyond what any
/// wall bears is looked at.
///
/// A distance `d` in front of a wall the ghosts behind it fill a support of `d + 5 dx`.
pub fn limit_widths<const D: usize>(
    problem: &Problem<D>,
    records: &Records<D>,
    lists: &Lists,
    particles: &mut [Particle<D>],
) {
    lists
        .par_runs()
        .zip(particles.par_chunks_mut(lists.run_targets()))
        .for_each(|(run, particles)| {
            let first = run.clusters.first().map_or(0, |c| c.targets.start);
            for cluster in run.clusters {
                for i in cluster.targets.clone() {
                    let near = &records.near[i];
                    let lattice = SMOOTHING_RATIO * problem.resolution.at(&near.position);
                    let width = &mut particles[i - first].smoothing_length;
                    if *width > AT_WALLS * lattice {
                        let ghosts = &run.entries[cluster.wall.clone()];
                        let ghosts = ghosts.iter().map(|&j| &records.near[j as usize]);
                        *width = width.min(widest(problem, near, ghosts));
                    }
                }
            }
        });
}

/// The largest smoothing length of the particle `near`, among `ghosts` some of which it may not see.
fn widest<'a, const D: usize>(
    problem: &Problem<D>,
    near: &Near<D>,
    ghosts: impl Iterator<Item = &'a Near<D>>,
) -> f64 {
    let own = &near.position;
    let spacing = problem.resolution.at(own);
    let lattice = SMOOTHING_RATIO * spacing;
    let distance = |ghost: &Near<D>| {
        let reach = GROWTH * SUPPORT * (near.half_h + ghost.half_h);
        let squared = (own - ghost.position).norm_squared();
        (squared < reach * reach).then_some(squared)
    };
    let nearest = ghosts
        .filter_map(distance)
        .fold(f64::INFINITY, f64::min)
        .sqrt();
    // The first layer lies half a spacing behind the wall.
    let free = (nearest - 0.5 * spacing).min(room(problem, own));
    let fits = (free + LAYERS * spacing) / SUPPORT;
    (ANYWHERE[D - 1] * lattice).min(fits.max(AT_WALLS * lattice))
}

/// Distance to the nearest open side, and what keeps a kernel clear of its own image.
fn room<const D: usize>(problem: &Problem<D>, position: &Vector<D>) -> f64 {
    let domain = &problem.domain;
    let mut room = open_side_distance(domain, position);
    for axis in 0..D {
        if domain.sides[axis][0].is_periodic() {
            let half = 0.5 * domain.bounds.size()[axis];
            room = room.min((half - LAYERS * problem.resolution.at(position)).max(0.0));
        }
    }
    room
}

/// Distance to the nearest open side, zero beyond it; infinite where there is none.
pub fn open_side_distance<const D: usize>(domain: &Domain<D>, position: &Vector<D>) -> f64 {
    let bounds = &domain.bounds;
    let mut distance = f64::INFINITY;
    for axis in 0..D {
        let [low, high] = domain.sides[axis];
        if low.is_open() {
            distance = distance.min((position[axis] - bounds.min[axis]).max(0.0));
        }
        if high.is_open() {
            distance = distance.min((bounds.max[axis] - position[axis]).max(0.0));
        }
    }
    for opening in domain
        .openings
        .iter()
        .filter(|opening| opening.side.is_open())
    {
        let plane = domain.face(opening.axis, opening.end);
        distance = distance.min(opening.distance(position, plane));
    }
    distance
}
