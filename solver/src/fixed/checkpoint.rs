//! All that a flow about fixed points must remember to go on with the same bits.

use std::borrow::Cow;

use aero_geometry::Vector;
use serde::ser::SerializeSeq;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

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
    points: Known,
    /// Which lattice cells are split, where the flow may ask for that: level and index of each.
    split: Option<Vec<i32>>,
    /// Mass, momentum and energy per volume of each cell.
    held: Held<'a, D>,
    received: Vec<f64>,
    pressures: Cow<'a, [Vec<f64>]>,
    /// What comes in through outlets that relax, in the order of their faces.
    waves: Vec<Option<Incoming>>,
    settling: Cow<'a, Settling>,
    updates: u64,
    min_density: f64,
    min_energy: f64,
}

/// Points by which they are known again: their number and the sum of Fowler, Noll & Vo over the bits of their places.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
struct Known {
    count: usize,
    sum: u64,
}

impl Known {
    fn of<const D: usize>(points: &[Vector<D>]) -> Self {
        /// Of FNV-1a with 64 bits, here number by number.
        const START: u64 = 0xcbf2_9ce4_8422_2325;
        const PRIME: u64 = 0x100_0000_01b3;
        let places = points.iter().flat_map(Vector::iter);
        Self {
            count: points.len(),
            sum: places.fold(START, |sum, x| (sum ^ x.to_bits()).wrapping_mul(PRIME)),
        }
    }
}

/// What cells hold, as one row of numbers where it is written.
#[derive(Clone, Debug)]
struct Held<'a, const D: usize>(Cow<'a, [Conserved<D>]>);

impl<const D: usize> Serialize for Held<'_, D> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut row = serializer.serialize_seq(Some(self.0.len() * (D + 2)))?;
        let mut all = self.0.iter().flat_map(numbers);
        all.try_for_each(|number| row.serialize_element(&number))?;
        row.end()
    }
}

impl<'de, const D: usize> Deserialize<'de> for Held<'_, D> {
    fn deserialize<R: Deserializer<'de>>(deserializer: R) -> Result<Self, R::Error> {
        let row: Vec<f64> = Vec::deserialize(deserializer)?;
        Ok(Self(row.chunks_exact(D + 2).map(conserved).collect()))
    }
}

impl<const D: usize> FixedSimulation<D> {
    /// What [`Self::resume_on`] needs to go on from here.
    pub fn memory(&self) -> FixedMemory<'_, D> {
        FixedMemory {
            time: self.tally.time,
            steps: self.tally.steps,
            points: Known::of(&self.points),
            split: self.ground.as_ref().map(|ground| ground.levels.numbers()),
            held: Held(Cow::Borrowed(&self.columns.held)),
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
        let ground = ground.if_wanted();
        let mut simulation = Self::resume_on(cells, problem, memory)?;
        simulation.ground = ground;
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
        if memory.points != Known::of(&cells.points) {
            return Err(format!(
                "it holds {} points, which are not the {} that bodies and domain now give",
                memory.points.count,
                cells.points.len()
            ));
        }
        let gas = super::AnyGas::of(&problem.gas)?;
        let held = memory.held.0.into_owned();
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

#[cfg(test)]
mod tests {
    use super::super::tests::lattice::{lattice, problem};
    use super::*;
    use crate::problem::Side;

    /// One point a bit off, one more, and two that have changed places.
    #[test]
    fn a_memory_is_of_the_same_points_alone() {
        let closed = || problem::<2>([3, 2], 0.5, [[Side::Symmetry; 2]; 2]);
        let flow = FixedSimulation::on(lattice(&closed()), closed()).unwrap();
        assert!(FixedSimulation::resume_on(lattice(&closed()), closed(), flow.memory()).is_ok());
        let refused = |change: fn(&mut Vec<Vector<2>>)| {
            let mut cells = lattice(&closed());
            change(&mut cells.points);
            FixedSimulation::resume_on(cells, closed(), flow.memory()).unwrap_err()
        };
        for error in [
            refused(|points| points[4].y = points[4].y.next_up()),
            refused(|points| points.push(Vector::zeros())),
            refused(|points| points.swap(1, 2)),
        ] {
            assert!(error.contains("it holds 6 points"), "{error}");
        }
    }
}
