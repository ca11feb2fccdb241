//! All that a simulation must remember to go on with the same bits. Not the file that holds it.
//!
//! Whatever the first lines of a step make anew (neighbour lists, images, records, rates) is left
//! out; the order of the particles is not, because sums follow it.

use std::borrow::Cow;

use serde::{Deserialize, Serialize};

use super::open::OpenBoundaries;
use super::particle::{Ghost, Particle};
use super::{Simulation, snapshot};
use crate::frame::Totals;
use crate::problem::Problem;

/// A simulation between two steps; borrowed from it where it is only to be written.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Memory<'a, const D: usize> {
    time: f64,
    steps: u64,
    last_step: f64,
    stable_step: f64,
    fluid: Cow<'a, [Particle<D>]>,
    open: Cow<'a, OpenBoundaries<D>>,
    ghosts: Cow<'a, [Ghost<D>]>,
    received: Totals,
    extremes: snapshot::Extremes,
}

impl<const D: usize> Simulation<D> {
    /// What [`Self::resume`] needs to go on from here.
    pub fn memory(&self) -> Memory<'_, D> {
        Memory {
            time: self.time,
            steps: self.steps,
            last_step: self.last_step,
            stable_step: self.stable_step,
            fluid: Cow::Borrowed(&self.fluid),
            open: Cow::Borrowed(&self.open),
            ghosts: Cow::Borrowed(&self.walls.ghosts),
            received: self.received,
            extremes: self.extremes,
        }
    }

    /// Goes on from `memory`, which a simulation of the same `problem` left: every later step has the
    /// bits that it would have had there.
    pub fn resume(problem: Problem<D>, memory: Memory<'_, D>) -> Result<Self, String> {
        let mut simulation = Self::new(problem)?;
        if memory.ghosts.len() != simulation.walls.ghosts.len() {
            return Err(format!(
                "it holds {} ghosts, but the bodies now pack into {}",
                memory.ghosts.len(),
                simulation.walls.ghosts.len()
            ));
        }
        simulation.time = memory.time;
        simulation.steps = memory.steps;
        simulation.last_step = memory.last_step;
        simulation.stable_step = memory.stable_step;
        simulation.fluid = memory.fluid.into_owned();
        simulation.open = memory.open.into_owned();
        simulation.received = memory.received;
        simulation.extremes = memory.extremes;
        simulation.walls.ghosts = memory.ghosts.into_owned();
        // They were in order when they were saved, unless they have moved since; then the next
        // step sorts them again.
        if !simulation.walls.are_moving() {
            simulation.walls.sort();
        }
        Ok(simulation)
    }
}
