//! All that a flow about fixed points must remember to go on with the same bits.

use std::borrow::Cow;

use aero_geometry::Vector;
use serde::{Deserialize, Serialize};

use super::FixedSimulation;
use super::cells::Cells;
use super::ground::Ground;
use super::settle::Settling;
use super::state::Conserved;
use super::tally::Tally;
use crate::problem::Problem;
use crate::sides::Incoming;

/// A flow between two steps; borrowed from it where it is only to be written.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct FixedMemory<'a, const D: usize> {
    time: f64,
    steps: u64,
    points: Cow<'a, [Vector<D>]>,
    /// Which lattice cells are split, where the flow may ask for that: level and index of each.
    split: Option<Vec<i32>>,
    /// Mass, momentum and energy per volume of each cell.
    held: Vec<f64>,
    received: Vec<f64>,
    pressures: Cow<'a, [Vec<f64>]>,
    /// What comes in through outlets that relax, in the order of their faces.
    waves: Vec<Option<Incoming>>,
    settling: Cow<'a, Settling>,
    updates: u64,
    min_density: f64,
    min_energy: f64,
}

impl<const D: usize> FixedSimulation<D> {
    /// What [`Self::resume_on`] needs to go on from here.
    pub fn memory(&self) -> FixedMemory<'_, D> {
        FixedMemory {
            time: self.tally.time,
            steps: self.tally.steps,
            points: Cow::Borrowed(&self.points),
            split: self.ground.as_ref().map(|ground| ground.levels.numbers()),
            held: self.columns.held.iter().flat_map(numbers).collect(),
            received: numbers(&self.tally.received).collect(),
            pressures: Cow::Borrowed(&self.columns.pressures),
            waves: self.waves(),
            settling: Cow::Borrowed(&self.settling),
            updates: self.tally.updates,
            min_density: self.tally.min_density,
            min_energy: self.tally.min_energy,
        }
    }

    /// Goes on from `memory`, which a flow of the same `problem` left, see [`Self::resume_on`].
    ///
    /// # Errors
    /// A problem that gives other points.
    pub fn resume(problem: Problem<D>, memory: FixedMemory<'_, D>) -> Result<Self, String> {
        let (mut ground, mut cells) = Ground::new(&problem)?;
        if let Some(split) = &memory.split {
            (ground, cells) = ground.with_numbers(&problem, split);
        }
        let mut simulation = Self::resume_on(cells, problem, memory)?;
        if ground.may_change() {
            simulation.ground = Some(Box::new(ground));
        }
        Ok(simulation)
    }

    /// Goes on from `memory`, which a flow of the same `problem` on the same `cells` left: every later step has the bits that it
    /// would have had there.
    ///
    /// # Errors
    /// Cells that are not the same.
    pub fn resume_on(
        cells: Cells<D>,
        problem: Problem<D>,
        memory: FixedMemory<'_, D>,
    ) -> Result<Self, String> {
        let found = cells.points.len();
        if *memory.points != cells.points {
            return Err(format!(
                "it holds {} points, which are not the {found} that bodies and domain now give",
                memory.points.len()
            ));
        }
        let gas = super::AnyGas::of(&problem.gas)?;
        let held: Vec<Conserved<D>> = memory.held.chunks_exact(D + 2).map(conserved).collect();
        let received = conserved(&memory.received);
        let states = held.iter().map(|held| held.primitive(&gas)).collect();
        let mut simulation = Self::from_states(cells, problem, states)?;
        simulation.columns.held = held;
        simulation.columns.pressures = memory.pressures.into_owned();
        simulation.set_waves(&memory.waves);
        simulation.settling = memory.settling.into_owned();
        simulation.tally = Tally {
            time: memory.time,
            steps: memory.steps,
            updates: memory.updates,
            received,
            min_density: memory.min_density,
            min_energy: memory.min_energy,
        };
        Ok(simulation)
    }
}

fn numbers<const D: usize>(held: &Conserved<D>) -> impl Iterator<Item = f64> + use<D> {
    let momentum = held.momentum;
    [held.mass].into_iter().chain(momentum).chain([held.energy])
}

fn conserved<const D: usize>(numbers: &[f64]) -> Conserved<D> {
    Conserved {
        mass: numbers[0],
        momentum: std::array::from_fn(|k| numbers[k + 1]),
        energy: numbers[D + 1],
    }
}
