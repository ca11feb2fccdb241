//! The particle method: takes a [`Case`], advances it step by step, hands out snapshots.
//!
//! [`Simulation::step`] is the contents page: exchange with open boundaries, sort, list the
//! neighbours, read the density off the particles, evaluate, predict, evaluate, correct.

use aero_geometry::Pencils;
use aero_geometry::kernel::{SMOOTHING_RATIO, SUPPORT};
use pulp::Arch;
use rayon::prelude::*;

use crate::case::{Case, Equations, Side};
use crate::frame::Totals;

mod calm;
mod checkpoint;
mod curvature;
mod faces;
mod failure;
mod fill;
mod images;
mod initial;
mod lanes;
mod lattice;
mod loads;
mod neighbours;
mod open;
mod pairs;
mod particle;
mod passes;
mod reach;
mod records;
mod reservoir;
mod rigid;
mod rings;
mod shifting;
mod shock_sensor;
mod side_walls;
mod snapshot;
mod stages;
#[cfg(test)]
mod tests;
mod time_step;
mod turning;
mod walls;

use calm::Calm;
use images::Images;
use neighbours::{Candidates, GROWTH, Lists, Seeker};
use open::OpenBoundaries;
use pairs::rates::{Transport, rates};
use pairs::renormalisation::{Renormalisation, renormalise};
use pairs::shield::shield;
use pairs::summation::densities;
use particle::{Particle, Rates};
use records::{FLOW_IMAGES, FLUID, GHOST_IMAGES, GHOSTS, OPEN, Records};
use rings::Rings;
use shock_sensor::find_shocks;
use walls::{WallLists, Walls};

pub use checkpoint::Memory;
pub use failure::Failure;
pub use passes::Pass;
pub use side_walls::wall_sides;
pub use snapshot::Statistics;

/// A run in progress.
#[derive(Debug)]
pub struct Simulation<const D: usize> {
    case: Case<D>,
    time: f64,
    steps: u64,
    /// Gas that moves by the equations, in the order of `fluid_pencils`.
    fluid: Vec<Particle<D>>,
    rates: Vec<Rates<D>>,
    /// The fluid at the start of the step.
    saved: Vec<Particle<D>>,
    open: OpenBoundaries<D>,
    rings: Rings,
    walls: Walls<D>,
    /// Where there is a free stream whose pair sums may be skipped.
    calm: Option<Calm<D>>,
    flow_images: Images<D>,
    ghost_images: Images<D>,
    records: Records<D>,
    lists: Lists,
    wall_lists: WallLists,
    fluid_pencils: Pencils<D>,
    open_pencils: Pencils<D>,
    renormalisations: Vec<Renormalisation<D>>,
    densities: Vec<f64>,
    /// Step before this one; the next may be a tenth longer.
    last_step: f64,
    /// Summation density of a perfect lattice of unit density.
    lattice_sum: f64,
    /// Width of a pencil: a cluster is then about as wide as long.
    width: f64,
    arch: Arch,
    /// Impulse and work of walls and open neighbours on the fluid so far.
    received: Totals,
    extremes: snapshot::Extremes,
}

/// How far a half step at most carries the particles; the neighbour lists allow for it.
#[derive(Clone, Copy, Debug)]
struct StepBound {
    step: f64,
}

impl<const D: usize> Simulation<D> {
    /// Sets up the particles of `case`.
    pub fn new(case: Case<D>) -> Result<Self, String> {
        let arch = lanes::processor()?;
        let lanes = neighbours::lane_count(arch) as f64;
        let width = case.spacing * lanes.powf(1.0 / D as f64);
        let (fluid, open) = OpenBoundaries::fill(&case)?;
        if fluid.is_empty() {
            return Err("no gas particle fits between the bodies and the sides; \
                        use a smaller `spacing` or a larger domain"
                .into());
        }
        let walls = Walls::new(&case, width);
        let mut simulation = Self {
            time: 0.0,
            steps: 0,
            fluid,
            rates: Vec::new(),
            saved: Vec::new(),
            open,
            rings: Rings::new(&case),
            walls,
            calm: Calm::new(&case),
            flow_images: Images::default(),
            ghost_images: Images::default(),
            records: Records::default(),
            lists: Lists::default(),
            wall_lists: WallLists::default(),
            fluid_pencils: Pencils::default(),
            open_pencils: Pencils::default(),
            renormalisations: Vec::new(),
            densities: Vec::new(),
            last_step: f64::INFINITY,
            lattice_sum: lattice::density_sum::<D>(SMOOTHING_RATIO),
            width,
            arch,
            received: Totals::default(),
            extremes: snapshot::Extremes::default(),
            case,
        };
        simulation.prepare(StepBound { step: 0.0 });
        simulation.evaluate(0.0);
        Ok(simulation)
    }

    /// The case that runs.
    pub fn case(&self) -> &Case<D> {
        &self.case
    }

    /// Time reached.
    pub fn time(&self) -> f64 {
        self.time
    }

    /// Steps taken.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// Advances by one time step, no further than `limit`; returns the step taken.
    ///
    /// Evaluate, predict, evaluate, correct [Villodi & Ramachandran 2024, section 3.6]: a
    /// midpoint rule, second order in time.
    ///
    /// # Errors
    /// A [`Failure`] when a particle's state stops making sense; the simulation then stands at
    /// its last good state.
    pub fn step(&mut self, limit: f64) -> Result<f64, Failure> {
        let bound = self.step_bound();
        self.prepare(bound);
        if self.case.scheme.equations == Equations::Conservative {
            self.read_densities();
        }
        self.evaluate(0.0);
        let free = self.time_step().min(bound.step);
        let step = if self.time + free * (1.0 + 1e-9) >= limit {
            limit - self.time
        } else {
            free
        };
        self.last_step = free;

        self.predict(0.5 * step)?;
        self.walls.update_smoothing_lengths();
        self.evaluate(0.5 * step);
        self.account(step);
        self.correct(step)?;

        let before = self.time;
        self.time = if limit - self.time == step {
            limit
        } else {
            self.time + step
        };
        self.steps += 1;
        self.cross_sides(before);
        self.extremes.updates += self.fluid.len() as u64;
        Ok(step)
    }

    /// The longest step that the neighbour lists of this step have to allow for.
    fn step_bound(&self) -> StepBound {
        const GROWTH_OF_STEP: f64 = 1.1;
        let acoustic = time_step::acoustic_step(self.case.scheme.cfl, self.case.gamma, &self.fluid);
        let mut step = acoustic.min(GROWTH_OF_STEP * self.last_step);
        if self.case.has_open_sides() {
            // The free-stream lattice must not jump across its buffer.
            let speed = self.case.free_stream.velocity.norm();
            step = step.min(2.0 * self.case.spacing / speed);
        }
        StepBound { step }
    }

    /// The stable step, at the rates of its start.
    fn time_step(&self) -> f64 {
        time_step::time_step(
            self.case.scheme.equations,
            self.case.scheme.cfl,
            self.case.gamma,
            &self.fluid,
            &self.rates,
        )
    }

    /// Sorts all particles in space, makes images and lists neighbours.
    fn prepare(&mut self, bound: StepBound) {
        self.sort(bound);
        self.list(bound);
    }

    /// Sorts all particles in space, makes images and writes the records.
    fn sort(&mut self, bound: StepBound) {
        let half_step = 0.5 * bound.step;
        let positions: Vec<_> = self.fluid.par_iter().map(|p| p.position).collect();
        self.fluid_pencils.rebuild(&positions, self.width);
        // Between two steps nothing is saved: that room takes the new order, and no third one is needed.
        permute(&self.fluid, self.fluid_pencils.order(), &mut self.saved);
        std::mem::swap(&mut self.fluid, &mut self.saved);
        let positions: Vec<_> = self
            .open
            .particles
            .iter()
            .map(|p| p.particle.position)
            .collect();
        self.open_pencils.rebuild(&positions, self.width);
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
        self.fill_gas(0.0);
        self.fill_ghosts();
    }

    /// Lists the neighbours.
    fn list(&mut self, bound: StepBound) {
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
        let sets = [
            Candidates::new(&self.fluid_pencils, records, FLUID),
            Candidates::new(&self.open_pencils, records, OPEN),
            Candidates::new(&self.flow_images.pencils, records, FLOW_IMAGES),
            Candidates::ghosts(&self.walls.pencils, records, ghosts.start..views),
            Candidates::ghosts(&self.walls.view_pencils, records, views..ghosts.end),
            Candidates::new(&self.ghost_images.pencils, records, GHOST_IMAGES),
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
    fn make_images(&mut self, half_step: f64) {
        let mirrors = |side: &Side| side.is_mirror() || *side == Side::Periodic;
        if !self.case.domain.sides.iter().flatten().any(mirrors) {
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
            .rebuild(&self.case.domain, &gas, reach, self.width);
        self.ghost_images
            .rebuild(&self.case.domain, &ghosts, reach, self.width);
    }

    /// Replaces each density by the sum over the particles, and the smoothing length with it
    /// (`h = 1.5 (m / rho)^(1/D)`), so that neither can drift from the particles' spacing.
    ///
    /// In rarefied gas the smoothing length stops growing where [`Self::widest`] says.
    fn read_densities(&mut self) {
        let widest = self.widest();
        self.densities.resize(self.fluid.len(), 0.0);
        densities(
            self.arch,
            &self.lists,
            &self.records.near,
            self.lattice_sum,
            &mut self.densities,
        );
        let rings = self.rings;
        let growth = if self.case.scheme.shifting {
            GROWTH - shifting::ROOM
        } else {
            GROWTH
        };
        self.fluid
            .par_iter_mut()
            .zip(&self.densities)
            .zip(widest)
            .for_each(|((particle, &density), widest)| {
                particle.density = density;
                let mass = rings.spanned_mass(particle);
                let h = SMOOTHING_RATIO * edge::<D>(mass / density);
                particle.smoothing_length = h.min(growth * particle.smoothing_length).min(widest);
            });
    }

    /// Rates of the fluid `ahead` of the start of the step.
    fn evaluate(&mut self, ahead: f64) {
        self.fill_gas(ahead);
        if self.walls.are_moving() {
            self.walls.move_to(self.time + ahead);
        }
        self.walls
            .extrapolate(self.arch, &self.wall_lists, &self.records);
        self.fill_ghosts();
        self.renormalise();
        if self.case.scheme.shield {
            self.shield();
        }
        if self.case.scheme.shifting {
            self.shift();
        }
        self.sum_rates();
        find_shocks(&self.case, self.rings, &self.rates, &mut self.fluid);
        self.rings
            .stretch(&self.fluid, self.case.gamma, &mut self.rates);
    }

    /// Sums the rates of the fluid.
    fn sum_rates(&mut self) {
        let scheme = &self.case.scheme;
        let transport = match (scheme.equations, scheme.shifting, scheme.shield) {
            (_, false, false) => Transport::None,
            (Equations::Conservative, true, _) => Transport::Exchange,
            _ => Transport::Advection,
        };
        rates(
            self.arch,
            &self.lists,
            &self.records,
            &self.renormalisations,
            (scheme.equations, transport),
            &mut self.rates,
        );
    }

    /// Renormalisation of the fluid; buffers keep theirs, and ghosts have that of a lattice.
    fn renormalise(&mut self) {
        self.renormalisations
            .resize(self.fluid.len(), Renormalisation::default());
        renormalise(
            self.arch,
            &self.lists,
            &self.records.near,
            0,
            self.case.scheme.shifting,
            &mut self.renormalisations,
        );
        let Records { near, state, .. } = &mut self.records;
        state
            .par_iter_mut()
            .zip(near.par_iter())
            .zip(&self.renormalisations)
            .for_each(|((state, near), r)| {
                state.renormalise(&r.matrix, &r.density_gradient, near.volume);
            });
        self.flow_images
            .refresh(&mut self.records, FLUID, FLOW_IMAGES);
    }

    fn shield(&mut self) {
        let first = self.records.start[GHOSTS];
        let (ghosts, images) = (&self.walls.ghosts, &self.ghost_images);
        let wall = |slot: usize| {
            if let Some(ghost) = ghosts.get(slot - first) {
                return (ghost.normal, ghost.wall_velocity);
            }
            let (source, sign) = images.source(slot - first - ghosts.len());
            let ghost = &ghosts[source];
            (
                sign.component_mul(&ghost.normal),
                sign.component_mul(&ghost.wall_velocity),
            )
        };
        shield(
            &self.lists,
            &self.records.near,
            &self.fluid,
            wall,
            &mut self.rates,
        );
    }
}

/// Edge of a cube of this `D`-dimensional volume.
fn edge<const D: usize>(volume: f64) -> f64 {
    match D {
        1 => volume,
        2 => volume.sqrt(),
        _ => volume.cbrt(),
    }
}

/// Writes the elements in a new order into `room`.
fn permute<T: Copy + Send + Sync>(elements: &[T], order: &[u32], room: &mut Vec<T>) {
    let moved = order.par_iter().map(|&n| elements[n as usize]);
    moved.collect_into_vec(room);
}
