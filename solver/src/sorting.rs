//! Before a step: sorts all particles in space, makes images and lists neighbours. Moves none.

use aero_geometry::kernel::SUPPORT;
use rayon::prelude::*;

use super::neighbours::{Candidates, GROWTH, Seeker};
use super::particle::Rates;
use super::records::{FLOW_IMAGES, FLUID, GHOST_IMAGES, GHOSTS, OPEN};
use super::{Simulation, StepBound};
use crate::problem::Side;

impl<const D: usize> Simulation<D> {
    /// Sorts all particles in space, makes images and lists neighbours.
    pub(super) fn prepare(&mut self, bound: StepBound) {
        self.sort(bound);
        self.list(bound);
    }

    /// Sorts all particles in space, makes images and writes the records.
    pub(super) fn sort(&mut self, bound: StepBound) {
        let half_step = 0.5 * bound.step;
        let fluid = &self.fluid;
        self.fluid_pencils
            .rebuild_from(fluid.len(), |i| fluid[i].position, self.width);
        // Between two steps nothing is saved: that room takes the new order, and no third one is needed.
        permute(&self.fluid, self.fluid_pencils.order(), &mut self.saved);
        std::mem::swap(&mut self.fluid, &mut self.saved);
        let open = &self.open.particles;
        self.open_pencils
            .rebuild_from(open.len(), |i| open[i].particle.position, self.width);
        let mut particles = Vec::new();
        permute(
            &self.open.particles,
            self.open_pencils.order(),
            &mut particles,
        );
        self.open.particles = particles;
        if self.walls.are_moving() {
            self.walls.move_to(self.time);
            self.walls.sort();
        }
        self.make_images(half_step);
        self.records.lay_out([
            self.fluid.len(),
            self.open.particles.len(),
            self.flow_images.len(),
            self.walls.ghosts.len(),
            self.ghost_images.len(),
        ]);
        self.rates.resize(self.fluid.len(), Rates::default());
        self.fill_near(0.0);
        self.fill_ghosts();
    }

    /// Lists the neighbours.
    pub(super) fn list(&mut self, bound: StepBound) {
        let half_step = 0.5 * bound.step;
        let records = &self.records;
        let ghosts = records.segment(GHOSTS);
        let views = ghosts.start + self.walls.own_count();
        let (fluid, open, images) = (&self.fluid, &self.open.particles, &self.flow_images);
        let gas = |slot: usize| match slot.checked_sub(fluid.len()) {
            None => fluid[slot].is_calm,
            Some(slot) => open[slot].lattice.is_some() || open[slot].particle.is_calm,
        };
        let is_calm = |slot: usize| {
            if slot >= records.start[GHOSTS] {
                return false;
            }
            match slot.checked_sub(records.start[FLOW_IMAGES]) {
                None => gas(slot),
                Some(image) => gas(images.source(image).0),
            }
        };
        if let Some(calm) = &mut self.calm {
            calm.draw(&records.near, is_calm, half_step);
        }
        let (walls, ghost_images) = (&self.walls, &self.ghost_images);
        self.rough.copy(&records.near, |slot| {
            // Ghosts show the gas a velocity at which they do not move.
            let Some(number) = slot.checked_sub(ghosts.start) else {
                return records.near[slot].velocity;
            };
            let (ghost, sign) = ghost_images.seen(&walls.ghosts, number);
            sign.component_mul(&ghost.wall_velocity)
        });
        let (rough, slots) = (&self.rough, |segment| records.segment(segment));
        let sets = [
            Candidates::gas(&self.fluid_pencils, rough, slots(FLUID)),
            Candidates::gas(&self.open_pencils, rough, slots(OPEN)),
            Candidates::gas(&self.flow_images.pencils, rough, slots(FLOW_IMAGES)),
            Candidates::ghosts(&self.walls.pencils, rough, ghosts.start..views),
            Candidates::ghosts(&self.walls.view_pencils, rough, views..ghosts.end),
            Candidates::ghosts(&self.ghost_images.pencils, rough, slots(GHOST_IMAGES)),
        ];
        let seeker = |i: usize| Seeker {
            position: records.near[i].position,
            half_h: records.near[i].half_h,
            velocity: records.near[i].velocity,
        };
        self.lists.build(
            self.arch,
            self.fluid.len(),
            seeker,
            &sets,
            half_step,
            self.calm.as_ref(),
        );
        self.walls
            .build_lists(self.arch, &sets, half_step, &mut self.wall_lists);
        self.part_thin_sides();
    }

    /// Copies particles near symmetry planes and periodic sides to beyond them.
    pub(super) fn make_images(&mut self, half_step: f64) {
        let mirrors = |side: &Side| side.is_mirror() || *side == Side::Periodic;
        if !self.problem.domain.sides.iter().flatten().any(mirrors) {
            return;
        }
        let ghosts = &self.walls.ghosts;
        let (fluid, open) = (&self.fluid, &self.open.particles);
        let gas = || {
            fluid
                .par_iter()
                .chain(open.par_iter().map(|open| &open.particle))
        };
        let [h, fastest] = gas()
            .map(|p| [p.smoothing_length, p.velocity.norm_squared()])
            .reduce(|| [0.0; 2], |a, b| [a[0].max(b[0]), a[1].max(b[1])]);
        let h = ghosts.iter().map(|g| g.smoothing_length).fold(h, f64::max);
        let reach = GROWTH * SUPPORT * h + 2.0 * half_step * fastest.sqrt();
        let gas: Vec<_> = gas().map(|p| p.position).collect();
        let ghosts: Vec<_> = ghosts.iter().map(|g| g.position).collect();
        self.flow_images
            .rebuild(&self.problem.domain, &gas, reach, self.width);
        self.ghost_images
            .rebuild(&self.problem.domain, &ghosts, reach, self.width);
    }
}

/// Writes the elements in a new order into `room`.
fn permute<T: Copy + Send + Sync>(elements: &[T], order: &[u32], room: &mut Vec<T>) {
    let moved = order.par_iter().map(|&n| elements[n as usize]);
    moved.collect_into_vec(room);
}
