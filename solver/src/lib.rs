//! The particle method: takes a [`Problem`], advances it step by step, hands out snapshots.
//!
//! [`Simulation::step`] is the contents page: sort and list the neighbours, predict, read the density off the particles,
//! evaluate, correct, cross the sides.
//!
//! Gas under pressure is let loose in a tube:
//!
//! ```
//! use aero_geometry::{Bounds, Vector};
//! use aero_solver::problem::{Domain, Initial, Problem, Side, State};
//! use aero_solver::{Simulation, gas::Gas};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let (left, right) = (State::at_rest(1.0, 1.0), State::at_rest(0.125, 0.1));
//! let bounds = Bounds::new(Vector::<1>::new(-0.5), Vector::<1>::new(0.5));
//! let still = Problem::new(Gas::ideal(1.4), Domain::new(bounds, [[Side::Symmetry; 2]]), left, 0.005);
//! let initial = Initial::Riemann { left, right, position: 0.0, smooth: false };
//! let mut tube = Simulation::new(Problem { initial, ..still })?;
//! while tube.time() < 0.1 { tube.step(0.1)?; }
//! let frame = tube.frame();
//! let behind = frame.position.iter().position(|x| (x[0] - 0.04).abs() < 0.01).expect("gas everywhere");
//! assert!((frame.density[behind] - 0.426).abs() < 0.02); // exact: between rarefaction and contact
//! # Ok(()) }
//! ```
//!
//! Where things are: `particles` their life and start, `sides` what bounds the domain, `walls` bodies and ghosts, `faces` thin
//! parts, `panels` the surfaces that pressure is shown on, `neighbourhood` order and copies, `neighbours` lists, `pairs` the laws, `step` time, `show` what is handed out.

use std::sync::OnceLock;

use problem::Problem;

mod backend;
mod books;
mod carrier;
mod compiled;
mod diffusion;
mod diffusive;
mod each;
mod evaluation;
mod faces;
mod fill;
pub mod fixed;
mod flow;
pub mod frame;
pub mod gas;
mod initial;
mod iterative_shifting;
mod lanes;
mod lattice;
pub mod layers;
pub mod method;
mod neighbourhood;
mod neighbours;
mod pairs;
pub mod panels;
mod particles;
mod passes;
mod preparation;
pub mod problem;
mod record;
mod records;
mod rings;
mod rounding;
pub mod scheme;
mod schemes;
mod shifting;
mod shock_sensor;
mod show;
mod sides;
mod sources;
mod step;
#[cfg(test)]
mod tests;
mod time_step;
mod vectors;
mod walls;

use books::Books;
use evaluation::Moment;
use neighbourhood::Neighbourhood;
use panels::Panels;
use particles::Particles;
use sides::Buffers;
use step::Clock;
use walls::Walls;

pub use flow::{Flow, FlowMemory};
pub use passes::Pass;
pub use show::{Memory, Statistics};
pub use step::Failure;
pub use walls::rigid::Pose;
pub use walls::wall_sides;

/// A run in progress.
#[derive(Debug)]
pub struct Simulation<const D: usize> {
    problem: Problem<D>,
    clock: Clock,
    /// Gas that moves by the equations, in the order of space.
    fluid: Particles<D>,
    /// Open sides and the gas beyond them.
    buffers: Buffers<D>,
    walls: Walls<D>,
    /// Who is near whom.
    around: Neighbourhood<D>,
    books: Books,
    /// Made when somebody asks for them.
    panels: OnceLock<Panels<D>>,
}

impl<const D: usize> Simulation<D> {
    /// Sets up the particles of `problem`.
    ///
    /// # Errors
    /// Where no gas fits into the domain, or it cannot start in the state that is asked for.
    pub fn new(mut problem: Problem<D>) -> Result<Self, String> {
        walls::part_ridges(&mut problem);
        let mut around = Neighbourhood::new(&problem)?;
        let (mut fluid, mut buffers) = particles::start(&problem)?;
        if fluid.is_empty() {
            return Err("no gas particle fits between the bodies and the sides; \
                        use a smaller `spacing` or a larger domain"
                .into());
        }
        let mut walls = Walls::new(&problem, around.grid());
        let clock = Clock::default();
        let now = (clock.time, 0.0);
        step::prepare(
            &problem,
            now,
            &mut fluid,
            &mut buffers,
            &mut walls,
            &mut around,
        );
        let moment = Moment {
            start: clock.time,
            ahead: 0.0,
        };
        evaluation::evaluate(
            &problem,
            moment,
            &mut fluid,
            &buffers,
            &mut walls,
            &mut around,
        );
        let simulation = Self {
            problem,
            clock,
            fluid,
            buffers,
            walls,
            around,
            books: Books::default(),
            panels: OnceLock::new(),
        };
        match simulation.walls.contact(&simulation.problem, 0.0) {
            Some(contact) => Err(simulation.touched(&contact).reason),
            None => Ok(simulation),
        }
    }

    /// Where body `number` is now, and how it moves.
    pub fn pose(&self, number: usize) -> Pose<D> {
        self.walls.pose(number, self.clock.time)
    }

    /// The problem that runs.
    pub fn problem(&self) -> &Problem<D> {
        &self.problem
    }

    /// Time reached.
    pub fn time(&self) -> f64 {
        self.clock.time
    }

    /// Steps taken.
    pub fn steps(&self) -> u64 {
        self.clock.steps
    }
}
