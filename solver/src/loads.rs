//! Forces and moments on bodies and walls, and the fluid's balance with them.

use aero_geometry::Vector;
use nalgebra::Vector3;
use rayon::prelude::*;

use super::Simulation;
use super::pairs::rates::reactions;
use super::particle::{Ghost, Rates};
use super::records::GHOSTS;
use super::rigid::pad;
use crate::frame::{Load, Totals};
use crate::problem::Side;

/// Particles that are summed up at once.
const BLOCK: usize = 4096;

impl<const D: usize> Simulation<D> {
    /// Loads on the bodies, in scene order; then on the wall sides in the order of
    /// [`super::wall_sides`]. They belong to the state of the last evaluation, half a step back.
    ///
    /// By the pair laws' symmetry the force on a ghost is minus what the ghost gives the gas:
    /// `F = -sum m_i a_i^(body)`. A body that a symmetry plane cuts is reported whole; of a body that runs
    /// on through an open side, what lies in the domain.
    pub fn loads(&self) -> Vec<Load> {
        let forces = self.ghost_forces();
        let mut loads = vec![Load::default(); self.walls.body_count()];
        let bodies = &self.problem.bodies;
        let reflections: Vec<_> = (0..loads.len())
            .map(|body| self.reflections(body))
            .collect();
        let centres: Vec<Vector3<f64>> = (0..loads.len())
            .map(|body| match bodies.get(body) {
                Some(body_case) => {
                    let pose = self.walls.pose(body, self.time);
                    pad(&pose.position(&body_case.moment_centre))
                }
                None => Vector3::zeros(),
            })
            .collect();
        let domain = &self.problem.domain.bounds;
        for (ghost, force) in self.walls.ghosts.iter().zip(&forces) {
            let body = ghost.body as usize;
            if body < bodies.len() && !domain.contains(&self.foot(ghost)) {
                continue;
            }
            for (sign, shift) in &reflections[body] {
                let force = pad(&self.rings.axial(sign.component_mul(force)));
                let arm = self
                    .rings
                    .axial(sign.component_mul(&ghost.position) + shift);
                let arm = pad(&arm) - centres[body];
                let moment = arm.cross(&force);
                for k in 0..3 {
                    loads[body].force[k] += force[k];
                    loads[body].moment[k] += moment[k];
                }
            }
        }
        loads
    }

    /// Rates of the fluid's momentum and energy by the pair sums of the last evaluation. In a
    /// periodic box both are zero to round-off.
    pub fn rates_of_totals(&self) -> Totals {
        let mut rates = Totals::default();
        for (particle, rate) in self.fluid.iter().zip(&self.rates) {
            let acceleration = rate.acceleration + rate.wall_acceleration;
            for k in 0..D {
                rates.momentum[k] += particle.mass * acceleration[k];
            }
            let power = particle.velocity.dot(&acceleration) + rate.energy;
            rates.energy += particle.mass * power;
        }
        rates
    }

    /// What the fluid received since the start: inflow minus outflow through open sides, the
    /// impulse of walls, the work of moving walls.
    pub fn inflow(&self) -> Totals {
        let mut sum = self.open.inflow;
        sum.energy += self.received.energy;
        for k in 0..3 {
            sum.momentum[k] += self.received.momentum[k];
        }
        sum
    }

    /// Books the step's impulse and work on the fluid, at the rates of its middle.
    ///
    /// Walls at rest do no work, so what the pair sums make of it is drift, not inflow. Beyond
    /// open sides and planes the neighbours' share cannot be told from the fluid's own and all is booked.
    pub(super) fn account(&mut self, step: f64) {
        let has_planes = self
            .problem
            .domain
            .sides
            .iter()
            .flatten()
            .any(|side| side.is_mirror());
        let is_open = self.problem.has_open_sides();
        if !is_open && !has_planes && self.walls.ghosts.is_empty() {
            return;
        }
        // Block by block, whatever the threads: a sum depends on its order.
        let blocks: Vec<(Vector<D>, f64)> = self
            .fluid
            .par_chunks(BLOCK)
            .zip(self.rates.par_chunks(BLOCK))
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
        if !is_open && self.walls.are_moving() {
            for (ghost, force) in self.walls.ghosts.iter().zip(self.ghost_forces()) {
                work -= force.dot(&ghost.wall_velocity);
            }
        }
        for k in 0..D {
            self.received.momentum[k] += step * impulse[k];
        }
        self.received.energy += step * work;
    }

    /// Force of the gas on each ghost, all around an axis if there is one.
    fn ghost_forces(&self) -> Vec<Vector<D>> {
        let mut rates = vec![Rates::default(); self.walls.ghosts.len()];
        reactions(
            &self.arch,
            &self.wall_lists.near,
            &self.records,
            &self.problem.scheme,
            &mut rates,
        );
        let masses = &self.records.near[self.records.segment(GHOSTS)];
        rates
            .iter()
            .zip(masses)
            .zip(&self.walls.ghosts)
            .map(|((rates, near), ghost)| {
                rates.acceleration * (near.mass * self.rings.circumference(&self.foot(ghost)))
            })
            .collect()
    }

    /// The foot of a ghost; of a view that looks from beyond a symmetry plane, as its own image does, the foot's
    /// mirror image in the domain.
    pub(super) fn foot(&self, ghost: &Ghost<D>) -> Vector<D> {
        let mut foot = ghost.foot();
        if !ghost.sight.is_view() {
            return foot;
        }
        let bounds = &self.problem.domain.bounds;
        for (axis, [low, high]) in self.problem.domain.sides.iter().enumerate() {
            if low.is_mirror() && foot[axis] < bounds.min[axis] {
                foot[axis] = 2.0 * bounds.min[axis] - foot[axis];
            } else if high.is_mirror() && foot[axis] > bounds.max[axis] {
                foot[axis] = 2.0 * bounds.max[axis] - foot[axis];
            }
        }
        foot
    }

    /// Maps `x' = sign x + shift` that make the whole body of the modelled part.
    fn reflections(&self, body: usize) -> Vec<(Vector<D>, Vector<D>)> {
        let mut maps = vec![(Vector::repeat(1.0), Vector::zeros())];
        let Some(body) = self.problem.bodies.get(body) else {
            return maps;
        };
        let extent = body.shape.bounds();
        let domain = &self.problem.domain;
        for axis in 0..D {
            let planes = [domain.bounds.min[axis], domain.bounds.max[axis]];
            for (side, plane) in domain.sides[axis].into_iter().zip(planes) {
                let cut = extent.min[axis] < plane && plane < extent.max[axis];
                if side == Side::Symmetry && cut {
                    let mirrored: Vec<_> = maps
                        .iter()
                        .map(|(sign, shift): &(Vector<D>, Vector<D>)| {
                            let (mut sign, mut shift) = (*sign, *shift);
                            sign[axis] = -sign[axis];
                            shift[axis] = 2.0 * plane - shift[axis];
                            (sign, shift)
                        })
                        .collect();
                    maps.extend(mirrored);
                }
            }
        }
        maps
    }
}
