//! All that a simulation must remember to go on with the same bits. Not the file that holds it.
//!
//! Whatever the first lines of a step make anew (neighbour lists, images, records, rates) is left
//! out; the order of the particles is not, because sums follow it.

use serde::{Deserialize, Serialize};

use super::open::OpenBoundaries;
use super::particle::{Ghost, Particle};
use super::{Simulation, snapshot};
use crate::case::Case;
use crate::frame::Totals;

/// A simulation between two steps.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Memory<const D: usize> {
    time: f64,
    steps: u64,
    last_step: f64,
    fluid: Vec<Particle<D>>,
    open: OpenBoundaries<D>,
    ghosts: Vec<Ghost<D>>,
    received: Totals,
    extremes: snapshot::Extremes,
}

impl<const D: usize> Simulation<D> {
    /// What [`Self::resume`] needs to go on from here.
    pub fn memory(&self) -> Memory<D> {
        Memory {
            time: self.time,
            steps: self.steps,
            last_step: self.last_step,
            fluid: self.fluid.clone(),
            open: self.open.clone(),
            ghosts: self.walls.ghosts.clone(),
            received: self.received,
            extremes: self.extremes,
        }
    }

    /// Goes on from `memory`, which a simulation of the same `case` left: every later step has the
    /// bits that it would have had there.
    pub fn resume(case: Case<D>, memory: Memory<D>) -> Result<Self, String> {
        let mut simulation = Self::new(case)?;
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
        simulation.fluid = memory.fluid;
        simulation.open = memory.open;
        simulation.received = memory.received;
        simulation.extremes = memory.extremes;
        simulation.walls.ghosts = memory.ghosts;
        // They were in order when they were saved, unless they have moved since; then the next
        // step sorts them again.
        if !simulation.walls.are_moving() {
            simulation.walls.sort();
        }
        Ok(simulation)
    }
}
