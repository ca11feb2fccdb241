//! The order in which cells are swept towards the steady state ([`super::relax`]).
//!
//! Cells that no face joins are computed side by side, in an order that no number of threads changes.
//! [For cells of any shape: Sharov & Nakahashi 1998, AIAA J. 36, 484-486]

use std::ops::Range;

use super::face_list::Join;
use super::net::{BLOCK, Net};
use super::order::{Link, levels};

/// Cells in the order of the flow, with their neighbours.
///
/// Cells stand in levels: no two cells of a level are neighbours, and a cell's level is above those of all its neighbours upstream. All
/// cells of a level can then be computed at once, and whoever computes them, the sums are the same.
#[derive(Clone, Debug)]
pub struct Sweeps {
    /// Cells by level, and by number within one.
    order: Vec<u32>,
    /// Where each level starts in the order, and where the last one ends.
    levels: Vec<usize>,
    /// Where the links of the cell at each place start.
    starts: Vec<u32>,
    links: Vec<Link>,
    /// Places of the cells that are awake, in their order.
    awake: Vec<u32>,
    /// Where each level starts among them, and where the last one ends.
    awake_levels: Vec<usize>,
    /// The blocks that these are of.
    awake_blocks: Vec<bool>,
}

/// The cells of a level that are awake.
#[derive(Clone, Debug)]
pub struct Level {
    /// Which they are among all that are awake.
    pub awake: Range<usize>,
    /// First and last place of the level.
    pub places: Range<usize>,
}

impl Sweeps {
    /// The cells of `net`, `along` the flow.
    pub fn new<const D: usize>(net: &Net<D>, along: impl Fn(usize) -> f64) -> Self {
        let count = net.len();
        let each = || {
            net.blocks.iter().flat_map(|block| {
                let is_first = |face: &&Join| block.cells.contains(&(face.i as usize));
                block.faces.iter().filter(is_first)
            })
        };
        let mut numbers = vec![0_u32; count];
        for face in each() {
            numbers[face.i as usize] += 1;
            numbers[face.j as usize] += 1;
        }
        let starts = starts(numbers.iter().copied());
        let mut beside = vec![0_u32; starts[count] as usize];
        let mut next = starts.clone();
        for face in each() {
            for (i, cell) in [(face.i, face.j), (face.j, face.i)] {
                beside[taken(&mut next[i as usize])] = cell;
            }
        }
        drop(next);
        let keys: Vec<f64> = (0..count).map(along).collect();
        let level_of = levels(&starts, &beside, &keys);
        drop((starts, beside, keys));
        let mut sweeps = Self::ordered(&level_of, &numbers);
        let mut places = vec![0_u32; count];
        for (place, &i) in (0..).zip(&sweeps.order) {
            places[i as usize] = place;
        }
        let nothing = Link::new(0, 0, 0, false);
        sweeps.links = vec![nothing; sweeps.starts[count] as usize];
        let mut next = sweeps.starts.clone();
        for face in each() {
            for (i, cell, is_inward) in [(face.i, face.j, false), (face.j, face.i, true)] {
                let [own, other] = [i, cell].map(|i| places[i as usize]);
                let link = Link::new(cell, other, face.shape, is_inward);
                sweeps.links[taken(&mut next[own as usize])] = link;
            }
        }
        sweeps
    }

    /// The cells in the order of their levels, each with so many links, which are still to come.
    fn ordered(level_of: &[u32], numbers: &[u32]) -> Self {
        let mut order: Vec<u32> = (0..level_of.len() as u32).collect();
        order.sort_unstable_by_key(|&i| (level_of[i as usize], i));
        let mut levels = Vec::new();
        for (place, &i) in order.iter().enumerate() {
            if level_of[i as usize] as usize == levels.len() {
                levels.push(place);
            }
        }
        levels.push(order.len());
        Self {
            starts: starts(order.iter().map(|&i| numbers[i as usize])),
            order,
            levels,
            links: Vec::new(),
            awake: Vec::new(),
            awake_levels: Vec::new(),
            awake_blocks: Vec::new(),
        }
    }

    /// The cell at `place`.
    pub fn cell(&self, place: usize) -> usize {
        self.order[place] as usize
    }

    /// Cells.
    pub fn len(&self) -> usize {
        self.order.len()
    }

    /// Says which blocks are awake.
    pub fn wake(&mut self, blocks: &[bool]) {
        if blocks == self.awake_blocks {
            return;
        }
        self.awake_blocks = blocks.to_vec();
        self.awake.clear();
        self.awake_levels.clear();
        for ends in self.levels.windows(2) {
            self.awake_levels.push(self.awake.len());
            let is_awake = |&place: &usize| blocks[self.order[place] as usize / BLOCK];
            let places = (ends[0]..ends[1]).filter(is_awake);
            self.awake.extend(places.map(|place| place as u32));
        }
        self.awake_levels.push(self.awake.len());
    }

    /// Places of the cells that are awake, in their order.
    pub fn awake(&self) -> &[u32] {
        &self.awake
    }

    /// Neighbours of the cell at `place`.
    pub fn links(&self, place: usize) -> &[Link] {
        &self.links[self.starts[place] as usize..self.starts[place + 1] as usize]
    }

    /// The levels, in their order.
    pub fn levels(&self) -> impl DoubleEndedIterator<Item = Level> {
        let ends = self.levels.windows(2).zip(self.awake_levels.windows(2));
        ends.map(|(places, awake)| Level {
            awake: awake[0]..awake[1],
            places: places[0]..places[1],
        })
    }
}

/// Where each of lists of these `numbers` starts, and where the last one ends.
fn starts(numbers: impl Iterator<Item = u32>) -> Vec<u32> {
    let mut sum = 0;
    let ends = numbers.map(|number| {
        sum += number;
        sum
    });
    std::iter::once(0).chain(ends).collect()
}

/// The next place of a list, which is taken now.
fn taken(next: &mut u32) -> usize {
    *next += 1;
    *next as usize - 1
}

#[cfg(test)]
mod tests {
    use super::super::FixedSimulation;
    use super::super::tests::lattice::{lattice, problem};
    use super::*;
    use crate::problem::Side;

    #[test]
    fn no_neighbours_share_a_level_and_the_stream_goes_upwards() {
        let problem = problem::<2>(
            [7, 6],
            1.0,
            [[Side::Inlet, Side::Outlet], [Side::Periodic; 2]],
        );
        let cells = lattice(&problem);
        let x: Vec<f64> = cells.points.iter().map(|point| point[0]).collect();
        let flow = FixedSimulation::on(cells, problem).unwrap();
        let mut sweeps = Sweeps::new(&flow.net, |i| x[i]);
        sweeps.wake(&vec![true; flow.net.blocks.len()]);
        let mut level_of = vec![0; x.len()];
        for (number, level) in sweeps.levels().enumerate() {
            assert_eq!(level.awake, level.places);
            for &i in &sweeps.order[level.places] {
                level_of[i as usize] = number;
            }
        }
        for (place, &i) in sweeps.order.iter().enumerate() {
            assert!(sweeps.links(place).len() >= 3);
            for link in sweeps.links(place) {
                let (i, j) = (i as usize, link.cell as usize);
                assert_eq!(sweeps.order[link.place as usize], link.cell);
                assert_ne!(level_of[i], level_of[j]);
                assert!(x[i] <= x[j] || level_of[i] > level_of[j]);
            }
        }
        // One for each column, and one more for every other cell of it.
        assert_eq!(sweeps.levels().count(), 8);
        sweeps.wake(&vec![false; flow.net.blocks.len()]);
        assert!(sweeps.awake().is_empty());
        assert!(sweeps.levels().all(|level| level.awake.is_empty()));
    }
}
