//! How far a run is, and how far its next step may go.

use aero_geometry::Vector;
use aero_geometry::kernel::{SMOOTHING_RATIO, SUPPORT};
use aero_geometry::parallel::prelude::*;
use serde::{Deserialize, Serialize};

use crate::particles::Particle;
use crate::problem::Problem;
use crate::sides::Buffers;
use crate::time_step::acoustic_step;
use crate::walls::Walls;

/// How far a run is.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Clock {
    /// Time reached.
    pub time: f64,
    /// Steps taken.
    pub steps: u64,
    /// Step before this one; the next may be a tenth longer.
    pub last_step: f64,
    /// The longest stable step, at the rates of the last evaluation.
    pub stable_step: f64,
}

impl Default for Clock {
    fn default() -> Self {
        Self {
            time: 0.0,
            steps: 0,
            last_step: f64::INFINITY,
            stable_step: f64::INFINITY,
        }
    }
}

impl Clock {
    /// The longest step that the neighbour lists of the next step have to allow for.
    pub fn bound<const D: usize>(
        &self,
        problem: &Problem<D>,
        fluid: &[Particle<D>],
        buffers: &Buffers<D>,
        walls: &Walls<D>,
    ) -> f64 {
        const GROWTH_OF_STEP: f64 = 1.1;
        let acoustic = acoustic_step(problem.scheme.step.cfl, &problem.gases(), fluid);
        let mut step = acoustic.min(GROWTH_OF_STEP * self.last_step);
        if self.last_step.is_infinite() {
            step = step.min(crossing_time(problem, fluid, walls));
        }
        if !buffers.sides.is_empty() {
            // No lattice may jump across its buffer.
            let speed = problem.free_stream.velocity.norm();
            step =
                step.min(2.0 * problem.resolution.finest() / speed.max(buffers.fastest_stream()));
        }
        step
    }

    /// The step to take within `bound`, which ends at `limit` at the latest.
    pub fn next_step(&mut self, bound: f64, limit: f64) -> f64 {
        let free = self.stable_step.min(bound);
        self.last_step = free;
        if self.time + free * (1.0 + 1e-9) >= limit {
            limit - self.time
        } else {
            free
        }
    }

    /// Goes on by `step`, exactly to `limit` if it ends there. Returns the time before and after.
    pub fn go_on(&mut self, step: f64, limit: f64) -> [f64; 2] {
        let before = self.time;
        self.time = if limit - self.time == step {
            limit
        } else {
            self.time + step
        };
        self.steps += 1;
        [before, self.time]
    }
}

/// Time in which a half step brings nothing nearer to anything by more than a support. No rates bound a first step yet, and
/// sound alone would let it list all of a cold gas as neighbours of each other.
fn crossing_time<const D: usize>(
    problem: &Problem<D>,
    fluid: &[Particle<D>],
    walls: &Walls<D>,
) -> f64 {
    let nowhere = Vector::<D>::repeat(f64::INFINITY);
    let either =
        |(a, b): (Vector<D>, Vector<D>), (c, d): (Vector<D>, Vector<D>)| (a.inf(&c), b.sup(&d));
    let gas = fluid.par_iter().map(|particle| particle.velocity);
    let ghosts = walls.ghosts.iter().map(|ghost| ghost.wall.velocity);
    let of_gas = gas
        .map(|velocity| (velocity, velocity))
        .reduce(|| (nowhere, -nowhere), either);
    let (slowest, fastest) = ghosts
        .map(|velocity| (velocity, velocity))
        .fold(of_gas, either);
    2.0 * SUPPORT * SMOOTHING_RATIO * problem.resolution.finest() / (fastest - slowest).norm()
}
