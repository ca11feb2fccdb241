//! The particle method: takes a [`Problem`], advances it step by step, hands out snapshots.
//!
//! [`Simulation::step`] is the contents page: sort and list the neighbours, predict, read the density off the particles,
//! evaluate, correct, exchange with open boundaries.

use aero_geometry::kernel::{SMOOTHING_RATIO, SUPPORT};
use aero_geometry::{Pencils, Vector};
use rayon::prelude::*;

use frame::Totals;
use problem::{Equations, Problem};

mod calm;
mod checkpoint;
mod curvature;
mod evaluation;
mod faces;
mod failure;
mod fill;
pub mod fixed;
pub mod frame;
pub mod gas;
mod images;
mod initial;
mod lanes;
mod lattice;
mod loads;
pub mod method;
mod neighbours;
mod open;
mod pairs;
mod particle;
mod passes;
pub mod problem;
mod reach;
mod records;
mod reservoir;
mod rigid;
mod rings;
mod rounding;
mod shifting;
mod shock_sensor;
mod side_walls;
mod snapshot;
mod sorting;
mod stages;
#[cfg(test)]
mod tests;
mod time_step;
mod turning;
mod vectors;
mod walls;

use calm::Calm;
use images::Images;
use neighbours::{Lists, Rough};
use open::OpenBoundaries;
use pairs::renormalisation::Renormalisation;
use particle::{Particle, Rates};
use records::{Records, Rounded};
use rings::Rings;
use vectors::Arch;
use walls::{WallLists, Walls};

pub use checkpoint::Memory;
pub use failure::Failure;
pub use passes::Pass;
pub use side_walls::wall_sides;
pub use snapshot::Statistics;

/// How often a step is halved before the run stops.
const HALVINGS: u32 = 5;

/// A run in progress.
#[derive(Debug)]
pub struct Simulation<const D: usize> {
    problem: Problem<D>,
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
    rough: Rough<D>,
    lists: Lists,
    wall_lists: WallLists,
    fluid_pencils: Pencils<D>,
    open_pencils: Pencils<D>,
    renormalisations: Vec<Renormalisation<D>>,
    densities: Vec<f64>,
    /// Step before this one; the next may be a tenth longer.
    last_step: f64,
    /// The longest stable step, at the rates of the last evaluation.
    stable_step: f64,
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
    /// Sets up the particles of `problem`.
    pub fn new(problem: Problem<D>) -> Result<Self, String> {
        let arch = Arch::of_processor(problem.scheme.precision)?;
        let lanes = arch.lanes() as f64;
        let width = problem.spacing * lanes.powf(1.0 / D as f64);
        let (fluid, open) = OpenBoundaries::fill(&problem)?;
        if fluid.is_empty() {
            return Err("no gas particle fits between the bodies and the sides; \
                        use a smaller `spacing` or a larger domain"
                .into());
        }
        let walls = Walls::new(&problem, width);
        let mut simulation = Self {
            time: 0.0,
            steps: 0,
            fluid,
            rates: Vec::new(),
            saved: Vec::new(),
            open,
            rings: Rings::new(&problem),
            walls,
            calm: Calm::new(&problem),
            flow_images: Images::default(),
            ghost_images: Images::default(),
            records: Records {
                rounded: Rounded::new(&problem),
                ..Records::default()
            },
            rough: Rough::default(),
            lists: Lists::default(),
            wall_lists: WallLists::default(),
            fluid_pencils: Pencils::default(),
            open_pencils: Pencils::default(),
            renormalisations: Vec::new(),
            densities: Vec::new(),
            last_step: f64::INFINITY,
            stable_step: f64::INFINITY,
            lattice_sum: lattice::density_sum::<D>(SMOOTHING_RATIO),
            width,
            arch,
            received: Totals::default(),
            extremes: snapshot::Extremes::default(),
            problem,
        };
        simulation.prepare(StepBound { step: 0.0 });
        simulation.evaluate(0.0);
        Ok(simulation)
    }

    /// The problem that runs.
    pub fn problem(&self) -> &Problem<D> {
        &self.problem
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
    /// The published scheme evaluates, predicts, evaluates and corrects [Villodi & Ramachandran 2024, section 3.6].
    /// The conservative one is a leapfrog that drifts, kicks and drifts, and evaluates once: its prediction of velocity and
    /// energy goes by what pressure did in the step before, so that viscosity and conduction bear steps twice as long. Both are
    /// second order in time but for the dissipation.
    ///
    /// # Errors
    /// A [`Failure`] when a particle's state stops making sense; the simulation then stands at
    /// its last good state.
    pub fn step(&mut self, limit: f64) -> Result<f64, Failure> {
        let is_leapfrog = self.problem.scheme.equations == Equations::Conservative;
        let bound = self.step_bound();
        self.prepare(bound);
        if self.steps == 0 && is_leapfrog {
            self.read_densities();
        }
        if self.steps == 0 || !is_leapfrog {
            self.evaluate(0.0);
            self.remember_rates();
        }
        let free = self.stable_step.min(bound.step);
        let step = if self.time + free * (1.0 + 1e-9) >= limit {
            limit - self.time
        } else {
            free
        };
        self.last_step = free;
        let step = self.advance_by(step)?;
        self.walls.update_smoothing_lengths();

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

    /// Predicts, evaluates and corrects; returns the step taken. The leapfrog takes a step that would leave a particle
    /// in a state that makes no sense again, at half the length.
    fn advance_by(&mut self, mut step: f64) -> Result<f64, Failure> {
        let is_leapfrog = self.problem.scheme.equations == Equations::Conservative;
        let received = self.received;
        let mut halvings = if is_leapfrog { HALVINGS } else { 0 };
        loop {
            match self.try_step(step) {
                Err(_) if halvings > 0 => {
                    halvings -= 1;
                    step *= 0.5;
                    self.last_step = step;
                    self.received = received;
                }
                result => return result.map(|()| step),
            }
        }
    }

    fn try_step(&mut self, step: f64) -> Result<(), Failure> {
        self.predict(0.5 * step)?;
        if self.problem.scheme.equations == Equations::Conservative {
            self.sum_densities(0.5 * step);
        }
        self.evaluate(0.5 * step);
        self.account(step);
        self.correct(step)
    }

    /// The longest step that the neighbour lists of this step have to allow for.
    fn step_bound(&self) -> StepBound {
        const GROWTH_OF_STEP: f64 = 1.1;
        let acoustic =
            time_step::acoustic_step(self.problem.scheme.cfl, &self.problem.gas, &self.fluid);
        let mut step = acoustic.min(GROWTH_OF_STEP * self.last_step);
        if self.last_step.is_infinite() {
            step = step.min(self.crossing_time());
        }
        if self.problem.has_open_sides() {
            // The free-stream lattice must not jump across its buffer.
            let speed = self.problem.free_stream.velocity.norm();
            step = step.min(2.0 * self.problem.spacing / speed);
        }
        StepBound { step }
    }

    /// Time in which a half step brings nothing nearer to anything by more than a support. No rates bound a first step yet, and
    /// sound alone would let it list all of a cold gas as neighbours of each other.
    fn crossing_time(&self) -> f64 {
        let nowhere = Vector::<D>::repeat(f64::INFINITY);
        let gas = self.fluid.par_iter().map(|particle| particle.velocity);
        let walls = self
            .walls
            .ghosts
            .par_iter()
            .map(|ghost| ghost.wall_velocity);
        let (slowest, fastest) = gas
            .chain(walls)
            .map(|velocity| (velocity, velocity))
            .reduce(
                || (nowhere, -nowhere),
                |(a, b), (c, d)| (a.inf(&c), b.sup(&d)),
            );
        2.0 * SUPPORT * SMOOTHING_RATIO * self.problem.spacing / (fastest - slowest).norm()
    }

    /// The stable step, at the rates of its start.
    fn time_step(&self) -> f64 {
        time_step::time_step(
            self.problem.scheme.equations,
            self.problem.scheme.cfl,
            &self.problem.gas,
            &self.fluid,
            &self.rates,
        )
    }
}
