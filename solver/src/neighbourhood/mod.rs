//! Who is near whom: before a step sorts all particles in space, copies those beyond sides that map the flow onto itself, and
//! lists neighbours. What the pair sums read of a particle lies here too. Moves none.

use aero_geometry::Pencils;
use aero_geometry::kernel::{SMOOTHING_RATIO, SUPPORT};
use rayon::prelude::*;

pub mod calm;
mod images;
mod reach;

use super::faces::part_thin_sides;
use super::lattice;
use super::neighbours::{Candidates, GROWTH, Lists, Rough, Seeker};
use super::particles::Particles;
use super::problem::Problem;
use super::records::{FLOW_IMAGES, FLUID, GHOST_IMAGES, GHOSTS, OPEN, Records, Rounded};
use super::sides::{Buffers, Side};
use super::vectors::Arch;
use super::walls::{WallLists, Walls};
use calm::Calm;

pub use images::{Copies, Images};
pub use reach::{LAYERS, open_side_distance, widest};

/// Records of all particles in the order of space, and lists of their neighbours.
#[derive(Debug)]
pub struct Neighbourhood<const D: usize> {
    /// The processor's vectors.
    pub arch: Arch,
    /// What the pair sums read.
    pub records: Records<D>,
    /// Neighbours of the fluid.
    pub lists: Lists,
    /// Neighbours of the ghosts.
    pub wall_lists: WallLists,
    /// Where there is a free stream whose pair sums may be skipped.
    pub calm: Option<Calm<D>>,
    /// Copies beyond sides that map the flow onto itself.
    pub copies: Copies<D>,
    /// Summation density of a perfect lattice of unit density.
    pub lattice_sum: f64,
    rough: Rough<D>,
    /// Order of the fluid, and that of the buffers.
    pencils: [Pencils<D>; 2],
    /// Width of a pencil: a cluster is then about as wide as long.
    width: f64,
}

impl<const D: usize> Neighbourhood<D> {
    /// Nothing yet, for `problem`.
    ///
    /// # Errors
    /// Where the processor lacks the vectors that are asked for.
    pub fn new(problem: &Problem<D>) -> Result<Self, String> {
        let arch = Arch::of_processor(problem.scheme.precision)?;
        let lanes = arch.lanes() as f64;
        Ok(Self {
            arch,
            records: Records {
                rounded: Rounded::new(problem),
                ..Records::default()
            },
            lists: Lists::default(),
            wall_lists: WallLists::default(),
            calm: Calm::new(problem),
            copies: Copies::default(),
            lattice_sum: lattice::density_sum::<D>(SMOOTHING_RATIO),
            rough: Rough::default(),
            pencils: std::array::from_fn(|_| Pencils::default()),
            width: problem.spacing * lanes.powf(1.0 / D as f64),
        })
    }

    /// Width of a pencil.
    pub fn width(&self) -> f64 {
        self.width
    }

    /// Sorts all particles in space, copies those near planes and lays the records out; `time` is now.
    pub fn sort(
        &mut self,
        problem: &Problem<D>,
        (time, half_step): (f64, f64),
        fluid: &mut Particles<D>,
        buffers: &mut Buffers<D>,
        walls: &mut Walls<D>,
    ) {
        let [fluid_pencils, open_pencils] = &mut self.pencils;
        fluid_pencils.rebuild_from(fluid.len(), |i| fluid[i].position, self.width);
        fluid.permute(fluid_pencils.order());
        let open = buffers.particles();
        open_pencils.rebuild_from(open.len(), |i| open[i].particle.position, self.width);
        buffers.permute(open_pencils.order());
        if walls.are_moving() {
            walls.move_to(time);
            walls.sort();
        }
        self.make_images(problem, half_step, fluid, buffers, walls);
        self.records.lay_out([
            fluid.len(),
            buffers.particles().len(),
            self.copies.gas.len(),
            walls.ghosts.len(),
            self.copies.ghosts.len(),
        ]);
    }

    /// Lists the neighbours among the particles whose records have been written; `time` is now.
    pub fn list(
        &mut self,
        (time, half_step): (f64, f64),
        fluid: &Particles<D>,
        buffers: &Buffers<D>,
        walls: &Walls<D>,
    ) {
        self.draw_calm(half_step, fluid, buffers);
        let records = &self.records;
        let ghosts = records.segment(GHOSTS);
        let views = ghosts.start + walls.own_count();
        let ghost_images = &self.copies.ghosts;
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
            Candidates::gas(&self.pencils[0], rough, slots(FLUID)),
            Candidates::gas(&self.pencils[1], rough, slots(OPEN)),
            Candidates::gas(&self.copies.gas.pencils, rough, slots(FLOW_IMAGES)),
            Candidates::ghosts(&walls.pencils, rough, ghosts.start..views),
            Candidates::ghosts(&walls.view_pencils, rough, views..ghosts.end),
            Candidates::ghosts(&self.copies.ghosts.pencils, rough, slots(GHOST_IMAGES)),
        ];
        let seeker = |i: usize| Seeker {
            position: records.near[i].position,
            half_h: records.near[i].half_h,
            velocity: records.near[i].velocity,
        };
        self.lists.build(
            self.arch,
            fluid.len(),
            seeker,
            &sets,
            half_step,
            self.calm.as_ref(),
        );
        walls.build_lists(self.arch, &sets, half_step, &mut self.wall_lists);
        if let Some(faces) = walls.faces() {
            let WallLists { near, mirror } = &mut self.wall_lists;
            let lists = [&mut self.lists, near, mirror];
            part_thin_sides(faces, (walls, time), records, &self.copies, lists);
        }
    }

    /// Draws the map of what is calm.
    fn draw_calm(&mut self, half_step: f64, fluid: &Particles<D>, buffers: &Buffers<D>) {
        let Some(calm) = &mut self.calm else {
            return;
        };
        let (records, images, open) = (&self.records, &self.copies.gas, buffers.particles());
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
        calm.draw(&records.near, is_calm, half_step);
    }

    /// Copies particles near symmetry planes and periodic sides to beyond them.
    fn make_images(
        &mut self,
        problem: &Problem<D>,
        half_step: f64,
        fluid: &Particles<D>,
        buffers: &Buffers<D>,
        walls: &Walls<D>,
    ) {
        let domain = &problem.domain;
        if !domain.has(|side: Side| side.is_mirror() || side.is_periodic()) {
            return;
        }
        let (ghosts, open) = (&walls.ghosts, buffers.particles());
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
        self.copies.gas.rebuild(domain, &gas, reach, self.width);
        self.copies
            .ghosts
            .rebuild(domain, &ghosts, reach, self.width);
    }
}
