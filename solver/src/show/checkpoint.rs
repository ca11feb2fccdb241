//! All that a simulation must remember to go on with the same bits. Not the file that holds it.
//!
//! Whatever the first lines of a step make anew (neighbour lists, images, records, rates) is left
//! out; the order of the particles is not, because sums follow it.

use std::borrow::Cow;

use serde::{Deserialize, Serialize};

use crate::Simulation;
use crate::books::Books;
use crate::particles::{Particle, Particles};
use crate::problem::Problem;
use crate::sides::Contents;
use crate::step::Clock;
use crate::walls::{FreeBody, Ghost};

/// A simulation between two steps; borrowed from it where it is only to be written.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Memory<'a, const D: usize> {
    clock: Clock,
    fluid: Cow<'a, [Particle<D>]>,
    buffers: Cow<'a, Contents<D>>,
    ghosts: Cow<'a, [Ghost<D>]>,
    free: Vec<Option<FreeBody>>,
    books: Books,
}

impl<const D: usize> Simulation<D> {
    /// What [`Self::resume`] needs to go on from here.
    pub fn memory(&self) -> Memory<'_, D> {
        Memory {
            clock: self.clock,
            fluid: Cow::Borrowed(&self.fluid),
            buffers: Cow::Borrowed(self.buffers.contents()),
            ghosts: Cow::Borrowed(&self.walls.ghosts),
            free: self.walls.free(),
            books: self.books,
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
        simulation.clock = memory.clock;
        simulation.fluid = Particles::new(memory.fluid.into_owned());
        simulation.buffers.restore(memory.buffers.into_owned());
        simulation.books = memory.books;
        simulation.walls.ghosts = memory.ghosts.into_owned();
        simulation.walls.restore_free(&memory.free);
        // They were in order when they were saved, unless they have moved since; then the next
        // step sorts them again.
        if !simulation.walls.are_moving() {
            simulation.walls.sort();
        }
        Ok(simulation)
    }
}
