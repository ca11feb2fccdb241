//! Forces and moments on bodies and walls, and the fluid's balance with them.

use aero_geometry::Vector;
use aero_geometry::parallel::prelude::*;
use nalgebra::Vector3;

use super::cut::within_open_sides;
use super::rigid::pad;
use super::{Ghost, Walls};
use crate::frame::{Load, Totals};
use crate::neighbourhood::Neighbourhood;
use crate::neighbours::Lists;
use crate::pairs::diffusion::diffuse_into_ghosts;
use crate::pairs::rates::reactions;
use crate::particles::{Particles, Rates};
use crate::problem::{Domain, Problem, Side};
use crate::records::GHOSTS;
use crate::rings::Rings;
use crate::scheme::PressureGradient;
use crate::sides::closed::reflections;

/// Particles that are summed up at once.
const BLOCK: usize = 4096;

/// Loads on the bodies, in scene order; then on the wall sides in the order of
/// [`crate::wall_sides`]. They belong to the state of the last evaluation, half a step back of `time`.
///
/// Where pairs share their momentum alike the force on a ghost is minus what the ghost gives the gas:
/// `F = -sum m_i a_i^(body)`. A body that a symmetry plane cuts is reported whole; of a body or wall that runs
/// on through an open side, what lies in the domain ([`super::cut`]).
pub fn loads<const D: usize>(
    problem: &Problem<D>,
    time: f64,
    walls: &Walls<D>,
    around: &Neighbourhood<D>,
) -> Vec<Load> {
    let (near, gas) = (&around.wall_lists.near, &around.records.near);
    let within = within_open_sides(&problem.domain, &walls.ghosts, gas, near);
    let forces = on_ghosts(problem, walls, around, within.as_ref().unwrap_or(near));
    let mut loads = vec![Load::default(); walls.body_count()];
    let (bodies, domain) = (&problem.bodies, &problem.domain);
    let rings = Rings::new(problem);
    let reflections: Vec<_> = (0..loads.len())
        .map(|body| {
            let extent = bodies.get(body).map(|body| body.shape.bounds());
            reflections(domain, extent.as_ref())
        })
        .collect();
    let centres: Vec<Vector3<f64>> = (0..loads.len())
        .map(|body| match bodies.get(body) {
            Some(body_case) => {
                let pose = walls.pose(body, time);
                pad(&pose.position(&body_case.moment_centre))
            }
            None => Vector3::zeros(),
        })
        .collect();
    for (ghost, on_ghost) in walls.ghosts.iter().zip(&forces) {
        let body = ghost.body as usize;
        if body < bodies.len() && !is_reported(domain, ghost) {
            continue;
        }
        for (sign, shift) in &reflections[body] {
            let whole = |force: &Vector<D>| pad(&rings.axial(sign.component_mul(force)));
            let (force, friction) = (whole(&on_ghost.force), whole(&on_ghost.friction));
            let arm = rings.axial(sign.component_mul(&ghost.position) + shift);
            let arm = pad(&arm) - centres[body];
            let moment = arm.cross(&force);
            for k in 0..3 {
                loads[body].force[k] += force[k];
                loads[body].moment[k] += moment[k];
                loads[body].friction[k] += friction[k];
            }
            loads[body].heat -= on_ghost.heat;
        }
    }
    loads
}

/// Impulse and work on the fluid of a step, at the rates of its middle.
///
/// Walls at rest do no work, so what the pair sums make of it is drift, not inflow. Beyond
/// open sides and planes the neighbours' share cannot be told from the fluid's own and all is booked. Where pressures act by their
/// differences ghosts give the fluid less than the walls bear, and those have the word.
pub fn received<const D: usize>(
    problem: &Problem<D>,
    step: f64,
    fluid: &Particles<D>,
    walls: &Walls<D>,
    around: &Neighbourhood<D>,
) -> Totals {
    let mut received = Totals::default();
    let has_planes = problem.domain.has(Side::is_mirror);
    let is_open = problem.domain.has(Side::is_open);
    let is_borne = problem.scheme.operators.pressure == PressureGradient::Difference
        && !is_open
        && !has_planes;
    if !is_open && !has_planes && walls.ghosts.is_empty() {
        return received;
    }
    // Block by block, whatever the threads: a sum depends on its order.
    let blocks: Vec<(Vector<D>, f64)> = fluid
        .par_chunks(BLOCK)
        .zip(fluid.rates().par_chunks(BLOCK))
        .map(|(fluid, rates)| {
            let (mut impulse, mut work) = (Vector::zeros(), 0.0);
            for (particle, rates) in fluid.iter().zip(rates) {
                let mut acceleration = rates.wall_acceleration;
                if is_open || has_planes {
                    acceleration += rates.acceleration;
                }
                impulse += acceleration * particle.mass;
                if is_open {
                    let power = particle.velocity.dot(&acceleration) + rates.energy;
                    work += particle.mass * power;
                }
            }
            (impulse, work)
        })
        .collect();
    let mut impulse = Vector::<D>::zeros();
    let mut work = 0.0;
    for (block_impulse, block_work) in blocks {
        impulse += block_impulse;
        work += block_work;
    }
    let is_at_work = walls.are_moving() || walls.are_sliding() || walls.are_conducting();
    if is_borne || (!is_open && is_at_work) {
        let all = on_ghosts(problem, walls, around, &around.wall_lists.near);
        if is_borne {
            impulse = -all.iter().map(|on_ghost| on_ghost.force).sum::<Vector<D>>();
        }
        for (ghost, OnGhost { force, heat, .. }) in walls.ghosts.iter().zip(all) {
            work -= force.dot(&(ghost.wall.velocity + ghost.wall.slide));
            if walls.kind(ghost.body).conducts() {
                work -= heat;
            }
        }
    }
    for k in 0..D {
        received.momentum[k] = step * impulse[k];
    }
    received.energy = step * work;
    received
}

/// What the gas does to a ghost, all around an axis if there is one.
struct OnGhost<const D: usize> {
    /// Force.
    force: Vector<D>,
    /// What of it viscosity makes.
    friction: Vector<D>,
    /// Heat that goes into it per time.
    heat: f64,
}

/// What the gas in `lists` does to each ghost.
fn on_ghosts<const D: usize>(
    problem: &Problem<D>,
    walls: &Walls<D>,
    around: &Neighbourhood<D>,
    lists: &Lists,
) -> Vec<OnGhost<D>> {
    let mut rates = vec![Rates::default(); walls.ghosts.len()];
    let records = &around.records;
    reactions(&around.arch, lists, records, &problem.scheme, &mut rates);
    let diffused = problem.gas.is_viscous().then(|| {
        let mut diffused = vec![Rates::default(); walls.ghosts.len()];
        diffuse_into_ghosts(&around.arch, lists, records, &mut diffused);
        diffused
    });
    let rings = Rings::new(problem);
    let masses = &records.near[records.segment(GHOSTS)];
    rates
        .iter()
        .zip(masses)
        .zip(&walls.ghosts)
        .enumerate()
        .map(|(index, ((rates, near), ghost))| {
            let mass = near.mass * rings.circumference(&foot(&problem.domain, ghost));
            let pressed = rates.acceleration * mass;
            match &diffused {
                Some(diffused) => {
                    let Rates {
                        acceleration,
                        energy,
                        ..
                    } = &diffused[index];
                    let friction = acceleration * mass;
                    OnGhost {
                        force: pressed + friction,
                        friction,
                        heat: energy * mass,
                    }
                }
                None => OnGhost {
                    force: pressed,
                    friction: Vector::zeros(),
                    heat: 0.0,
                },
            }
        })
        .collect()
}

/// The foot of a ghost; of one beyond a symmetry plane the foot's mirror image in the domain. A ghost on the plane faces
/// either way, and a view looks from beyond it, as its own image does.
fn foot<const D: usize>(domain: &Domain<D>, ghost: &Ghost<D>) -> Vector<D> {
    let mut foot = ghost.foot();
    for (axis, end, side, plane) in domain.each_side() {
        if side.is_mirror() && domain.depth_within(axis, end, &foot) < 0.0 {
            foot[axis] = 2.0 * plane - foot[axis];
        }
    }
    foot
}

/// True of a ghost of a body unless its foot lies beyond a side that is no open one, where a copy of it or another wall is.
fn is_reported<const D: usize>(domain: &Domain<D>, ghost: &Ghost<D>) -> bool {
    /// Feet on a side may be rounded to beyond it by no more than this part of the ghost's smoothing length.
    const ROUNDED: f64 = 1e-6;
    let foot = foot(domain, ghost);
    let least = -ROUNDED * ghost.shown.smoothing_length;
    domain.each_side().all(|(axis, end, side, _)| {
        side.is_open() || domain.depth_within(axis, end, &foot) >= least
    })
}

/// True of a ghost whose foot is not beyond a symmetry plane.
pub fn is_on_this_side<const D: usize>(domain: &Domain<D>, ghost: &Ghost<D>) -> bool {
    !ghost.sight.is_view() || foot(domain, ghost) == ghost.foot()
}
