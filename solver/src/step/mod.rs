//! One time step: sort and list the neighbours, predict, read the density off the particles, evaluate, correct, cross the
//! sides.

mod clock;
mod failure;
mod stages;

use super::Simulation;
use super::evaluation::{Moment, arrange, evaluate, read_densities, sum_densities};
use super::iterative_shifting::even_out;
use super::scheme::{Density, Integrator};
use super::sides::closed;
use super::walls::{loads, rebound};
use stages::Senseless;

pub use super::preparation::prepare;
pub use clock::Clock;
pub use failure::Failure;

/// How often a step is halved before the run stops.
const HALVINGS: u32 = 5;

impl<const D: usize> Simulation<D> {
    /// Advances by one time step, no further than `limit`; returns the step taken.
    ///
    /// How is up to the scheme's [`Integrator`].
    ///
    /// # Errors
    /// A [`Failure`] when a particle's state stops making sense; the simulation then stands at
    /// its last good state.
    pub fn step(&mut self, limit: f64) -> Result<f64, Failure> {
        let is_leapfrog = self.problem.scheme.integrator == Integrator::Leapfrog;
        self.even_out();
        let bound = self.prepare();
        if self.clock.steps == 0 || !is_leapfrog {
            self.evaluate_start();
        }
        let mut step = self.clock.next_step(bound, limit);
        let mut halvings = if is_leapfrog { HALVINGS } else { 0 };
        // The leapfrog takes a step that would leave a particle in a state that makes no sense again, at half the length.
        while let Err(senseless) = self.try_step(step) {
            if halvings == 0 {
                return Err(self.failure(senseless));
            }
            halvings -= 1;
            step *= 0.5;
            self.clock.last_step = step;
        }
        let Self {
            problem,
            clock,
            fluid,
            buffers,
            walls,
            books,
            ..
        } = self;
        walls.update_smoothing_lengths();
        let times = clock.go_on(step, limit);
        if problem.scheme.wall.sends_back {
            rebound(problem, times[1], fluid, walls, books);
        }
        buffers.exchange(problem, times, fluid, books);
        books.receive(&closed::bring_back(&problem.domain, fluid));
        books.extremes.updates += fluid.len() as u64;
        match walls.contact(problem, times[1]) {
            Some(contact) => Err(self.touched(&contact)),
            None => Ok(step),
        }
    }

    /// Moves the particles apart, after as many steps as the scheme says.
    fn even_out(&mut self) {
        let Self {
            problem,
            clock,
            fluid,
            buffers,
            walls,
            around,
            ..
        } = self;
        let every = problem.scheme.transport_velocity.evened_out;
        if every.is_some_and(|every| clock.steps > 0 && clock.steps.is_multiple_of(every)) {
            even_out(problem, clock.time, fluid, buffers, walls, around);
        }
    }

    /// Sorts the particles and lists their neighbours for the next step; returns what bounds it.
    pub(super) fn prepare(&mut self) -> f64 {
        let Self {
            problem,
            clock,
            fluid,
            buffers,
            walls,
            around,
            ..
        } = self;
        let bound = clock.bound(problem, fluid, buffers, walls);
        let now = (clock.time, 0.5 * bound);
        prepare(problem, now, fluid, buffers, walls, around);
        bound
    }

    /// Evaluates the state at the start of the step, and bounds the step by it.
    pub(super) fn evaluate_start(&mut self) {
        let Self {
            problem,
            clock,
            fluid,
            buffers,
            walls,
            around,
            ..
        } = self;
        let moment = Moment {
            start: clock.time,
            ahead: 0.0,
        };
        if problem.scheme.density == Density::Summation {
            // Sums at walls go by what ghosts show.
            arrange(problem, moment, fluid, buffers, walls, around);
            read_densities(problem, fluid, around);
        }
        evaluate(problem, moment, fluid, buffers, walls, around);
        stages::remember_rates(fluid);
        clock.stable_step = {
            let bound = problem.scheme.step;
            bound.time_step(&problem.gases(), fluid, fluid.rates())
        };
    }

    /// Predicts, evaluates and corrects; goes back to where the step began if that leaves a state that makes no sense.
    fn try_step(&mut self, step: f64) -> Result<(), Senseless<D>> {
        let Self {
            problem,
            clock,
            fluid,
            buffers,
            walls,
            around,
            books,
            ..
        } = self;
        let moment = Moment {
            start: clock.time,
            ahead: 0.5 * step,
        };
        let before = *books;
        let attempt = (|| {
            stages::predict(problem, moment.ahead, fluid, books)?;
            if problem.scheme.density == Density::Summation {
                sum_densities(problem, moment, fluid, buffers, walls, around);
            }
            evaluate(problem, moment, fluid, buffers, walls, around);
            let received = loads::received(problem, step, fluid, walls, around);
            books.receive(&received);
            let calm = around.calm.as_ref();
            let stable = stages::correct(problem, step, calm, fluid, books)?;
            clock.stable_step = stable.unwrap_or(clock.stable_step);
            if walls.are_free() {
                let middle = moment.start + moment.ahead;
                let loads = loads::loads(problem, middle, walls, around);
                walls.push(&problem.bodies, &loads, (middle, step));
            }
            Ok(())
        })();
        if attempt.is_err() {
            fluid.restore();
            books.received = before.received;
        }
        attempt
    }
}
