//! Who is near whom: before a step sorts all particles in space, copies those beyond sides that map the flow onto itself, and
//! lists neighbours. What the pair sums read of a particle lies here too. Moves none.

use aero_geometry::kernel::{SMOOTHING_RATIO, SUPPORT};
use aero_geometry::parallel::prelude::*;

pub mod calm;
pub mod images;
pub mod levels;
pub mod reach;

use super::faces::part_thin_sides;
use super::lattice;
use super::neighbours::{Candidates, GROWTH, Kind, Lists, Rough, Seeker};
use super::particles::{Particle, Particles};
use super::problem::{Problem, Side};
use super::records::{FLOW_IMAGES, FLUID, GHOSTS, OPEN, Records, Rounded};
use super::sides::Buffers;
use super::vectors::Arch;
use super::walls::{WallLists, Walls};
use calm::Calm;
use levels::Levels;

use images::Copies;
use levels::Grid;
pub use reach::{limit_widths, open_side_distance};

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
    /// Order of the fluid in space, and that of the buffers.
    orders: [Levels<D>; 2],
    grid: Grid<D>,
}

impl<const D: usize> Neighbourhood<D> {
    /// Nothing yet, for `problem`.
    ///
    /// # Errors
    /// Where the processor lacks the vectors that are asked for.
    pub fn new(problem: &Problem<D>) -> Result<Self, String> {
        let arch = Arch::of_processor(problem.scheme.precision)?;
        Ok(Self {
            arch,
            records: Records {
                are_two: problem.second.is_some(),
                is_viscous: problem.gas.is_viscous(),
                rounded: Rounded::new(problem),
                ..Records::default()
            },
            lists: Lists::default(),
            wall_lists: WallLists::default(),
            calm: Calm::new(problem),
            copies: Copies::default(),
            lattice_sum: lattice::density_sum::<D>(SMOOTHING_RATIO),
            rough: Rough::default(),
            orders: std::array::from_fn(|_| Levels::default()),
            grid: Grid::new(problem),
        })
    }

    /// How particles are sorted.
    pub fn grid(&self) -> &Grid<D> {
        &self.grid
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
        let [own, beyond] = &mut self.orders;
        let grid = &self.grid;
        let place = |p: &Particle<D>| (p.position, p.smoothing_length);
        own.rebuild(grid, fluid.len(), |i| place(&fluid[i]), |i| fluid[i].id);
        fluid.permute(own.order());
        let open = buffers.particles();
        let buffered = |i: usize| &open[i].particle;
        beyond.rebuild(grid, open.len(), |i| place(buffered(i)), |i| buffered(i).id);
        buffers.permute(beyond.order());
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
            sign.component_mul(&ghost.wall.velocity)
        });
        let (rough, slots) = (&self.rough, |segment| records.segment(segment));
        let [own, beyond] = &self.orders;
        let gas = (own.candidates(rough, slots(FLUID).start))
            .chain(beyond.candidates(rough, slots(OPEN).start))
            .chain(self.copies.gas.candidates(rough, records));
        let walled = [
            Candidates::ghosts(&walls.pencils, rough, ghosts.start..views),
            Candidates::ghosts(&walls.view_pencils, rough, views..ghosts.end),
        ];
        let copied = self.copies.ghosts.candidates(rough, records);
        let copied = copied.map(Candidates::of_ghosts);
        let sets: Vec<_> = gas.chain(walled).chain(copied).collect();
        let calm = self.calm.as_ref();
        let seeker = |i: usize| Seeker {
            position: records.near[i].position,
            half_h: records.near[i].half_h,
            velocity: records.near[i].velocity,
        };
        self.lists
            .build(self.arch, fluid.len(), seeker, &sets, half_step, |i| Kind {
                level: own.level(i),
                is_calm: calm.is_some_and(|calm| calm.covers(&records.near[i].position)),
            });
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
        let open = || open.iter().map(|open| &open.particle);
        let widest = |p: &Particle<D>| [p.smoothing_length, p.velocity.norm_squared()];
        let either = |a: [f64; 2], b: [f64; 2]| [a[0].max(b[0]), a[1].max(b[1])];
        let of_fluid = fluid.par_iter().map(widest).reduce(|| [0.0; 2], either);
        let [h, fastest] = open().map(widest).fold(of_fluid, either);
        let h = ghosts
            .iter()
            .map(|g| g.shown.smoothing_length)
            .fold(h, f64::max);
        // A copy is seen by nobody further off than the widest sees it, in the gas or beyond the wall.
        let reach =
            |own: f64| 0.5 * GROWTH * SUPPORT * (own + h) + 2.0 * half_step * fastest.sqrt();
        let place = |p: &Particle<D>| (p.position, p.smoothing_length);
        let mut gas: Vec<_> = fluid.par_iter().map(place).collect();
        gas.extend(open().map(place));
        let ghosts: Vec<_> = ghosts
            .iter()
            .map(|g| (g.position, g.shown.smoothing_length))
            .collect();
        self.copies.gas.rebuild(domain, &self.grid, &gas, reach);
        self.copies
            .ghosts
            .rebuild(domain, &self.grid, &ghosts, reach);
    }
}
