//! The undisturbed free stream, which costs next to nothing.
//!
//! A block of cells sleeps where all of them and all within two faces of it hold the free stream's state to a tolerance, with no wall in
//! its way: whatever flows into its cells flows out again, below the tolerance.

use super::FixedSimulation;
use super::beyond::Beyond;
use super::cells::Matrix;
use super::columns::Columns;
use super::net::{Among, Block, Net, one_of};
use super::slopes::Slopes;
use super::snapshot::Holding;
use super::state::{Conserved, Primitive};
use crate::problem::Problem;

/// Differences of density and pressure over their values and of velocity over the speed of sound that count as nothing.
const TOLERANCE: f64 = 1e-10;

/// The free stream.
#[derive(Clone, Copy, Debug)]
pub struct Stream<const D: usize> {
    /// Its state.
    pub state: Primitive<D>,
    /// Its speed of sound.
    pub sound: f64,
}

impl<const D: usize> Stream<D> {
    /// Which `states` of a block are not its own.
    pub fn disturbed(&self, states: &[Primitive<D>]) -> Among {
        let Primitive {
            density,
            velocity,
            pressure,
        } = self.state;
        let slowest = TOLERANCE * self.sound;
        let is_own = |state: &Primitive<D>| {
            (state.density - density).abs() <= TOLERANCE * density
                && (state.pressure - pressure).abs() <= TOLERANCE * pressure
                && (0..D).all(|k| (state.velocity[k] - velocity[k]).abs() <= slowest)
        };
        let states = states.iter().enumerate();
        states.fold(0, |all, (k, state)| {
            all | if is_own(state) { 0 } else { one_of(k) }
        })
    }

    /// True of a plane with this normal that the stream slides along.
    pub fn slides_along(&self, normal: &[f64; D]) -> bool {
        super::state::dot(&self.state.velocity, normal).abs() <= TOLERANCE * self.sound
    }
}

/// A block of cells.
#[derive(Clone, Copy, Debug)]
pub struct Rest<const D: usize> {
    /// True where something in it or within two faces of it disturbs the stream in any case.
    pub is_in_the_way: bool,
    /// Which cells do not hold the free stream.
    pub disturbed: Among,
    /// True where its cells have to be computed.
    pub is_awake: bool,
    /// True where nothing disturbs them.
    pub sleeps: bool,
    /// The least of `V / L` in the free stream.
    pub reach: f64,
    /// What it gains through walls and sides in the free stream.
    pub boundary: Conserved<D>,
    /// What it holds while it sleeps.
    pub holding: Holding<D>,
}

/// Which blocks rest.
#[derive(Clone, Debug)]
pub struct Quiet<const D: usize> {
    /// The free stream; none where nothing keeps one up, or where it is to be computed in full.
    pub stream: Option<Stream<D>>,
    /// Block by block.
    pub blocks: Vec<Rest<D>>,
}

impl<const D: usize> Quiet<D> {
    /// That of `problem` on `net`.
    pub fn of(net: &Net<D>, problem: &Problem<D>) -> Self {
        let sides = || problem.domain.sides.iter().flatten();
        let is_kept = sides().any(|side| side.keeps_free_stream());
        let gas = &problem.free_stream;
        let is_kept = is_kept && problem.source.is_none();
        let stream = (is_kept && problem.skips_undisturbed()).then(|| Stream {
            state: Primitive::of(gas),
            sound: problem.gas.sound_speed_at(gas.density, gas.pressure),
        });
        let in_the_way: Option<Vec<Among>> = stream.map(|stream| {
            let blocks = net.blocks.iter();
            blocks.map(|block| stream.in_the_way(block)).collect()
        });
        let is_in_the_way = |(block, number): (&Block<D>, usize)| {
            let is_disturbed =
                |all: &Vec<Among>| all[number] != 0 || is_near(block, |near| all[near]);
            in_the_way.as_ref().is_none_or(is_disturbed)
        };
        let rest = |block: (&Block<D>, usize)| Rest {
            is_in_the_way: is_in_the_way(block),
            disturbed: Among::MAX,
            is_awake: true,
            sleeps: false,
            reach: 0.0,
            boundary: Conserved::ZERO,
            holding: Holding::NOTHING,
        };
        Self {
            blocks: net.blocks.iter().zip(0..).map(rest).collect(),
            stream,
        }
    }
}

impl<const D: usize> Stream<D> {
    /// The cells of `block` whose walls or sides do not leave the stream alone.
    fn in_the_way(&self, block: &Block<D>) -> Among {
        let walls = block.walls.iter().filter(|wall| {
            let is_bent = wall.curvature != Matrix::<D>::zeros();
            is_bent || wall.stick.is_some() || !self.slides_along(&wall.image.normal)
        });
        let sides = block.sides.iter().filter(|side| match side.beyond {
            Beyond::Mirror => !self.slides_along(&side.image.normal),
            Beyond::Answers(..) | Beyond::Rides(..) => true,
            _ => false,
        });
        let cells = walls.map(|wall| wall.i).chain(sides.map(|side| side.i));
        cells.fold(0, |all, i| all | one_of(i as usize - block.cells.start))
    }
}

/// True where one of the cells near `block` is among those that `of` a block are looked for.
fn is_near<const D: usize>(block: &Block<D>, of: impl Fn(usize) -> Among) -> bool {
    let mut nearby = block.nearby.iter();
    nearby.any(|near| near.cells & of(near.block as usize) != 0)
}

impl<const D: usize> FixedSimulation<D> {
    /// Finds out which blocks are quiet, and what the free stream does in those that can be.
    pub(super) fn find_quiet(&mut self) {
        let Some(stream) = self.quiet.stream else {
            return;
        };
        let everywhere = vec![stream.state; self.columns.states.len()];
        let states = std::mem::replace(&mut self.columns.states, everywhere);
        for rest in &mut self.quiet.blocks {
            (rest.is_awake, rest.sleeps) = (true, false);
        }
        self.turn_around_axis();
        let reaches = self.find_reaches();
        self.columns.slopes.fill(Slopes::LEVEL);
        let boundaries = self.boundaries();
        self.columns.states = states;
        let blocks = self.quiet.blocks.iter_mut().zip(&self.net.blocks);
        for ((rest, block), (reach, boundary)) in blocks.zip(reaches.into_iter().zip(boundaries)) {
            rest.reach = reach;
            rest.boundary = boundary;
            rest.disturbed = stream.disturbed(&self.columns.states[block.cells.clone()]);
        }
    }

    /// Wakes all blocks with cells that are disturbed in them or near them, and puts the others to sleep.
    pub(super) fn wake(&mut self) {
        for (number, is_stirred) in self.stirred().into_iter().enumerate() {
            let rest = self.quiet.blocks[number];
            if rest.is_awake && !is_stirred {
                let block = &self.net.blocks[number];
                self.columns.slopes[block.cells.clone()].fill(Slopes::LEVEL);
                self.quiet.blocks[number].holding = self.holding(block);
            }
            let rest = &mut self.quiet.blocks[number];
            (rest.is_awake, rest.sleeps) = (is_stirred, !is_stirred);
        }
    }

    /// Wakes those that a stage of a step has disturbed or come near to: the next stage goes two faces farther.
    pub(super) fn wake_more(&mut self) {
        let stirred = self.stirred();
        let Columns { held, before, .. } = &mut self.columns;
        let blocks = self.quiet.blocks.iter_mut().zip(&self.net.blocks);
        for ((rest, block), is_stirred) in blocks.zip(stirred) {
            if rest.sleeps && is_stirred {
                (rest.is_awake, rest.sleeps) = (true, false);
                before[block.cells.clone()].copy_from_slice(&held[block.cells.clone()]);
            }
        }
    }

    /// Block by block, whether something disturbs the stream in it or within two faces of it.
    fn stirred(&self) -> Vec<bool> {
        let rests = &self.quiet.blocks;
        let is_stirred = |(rest, block): (&Rest<D>, &Block<D>)| {
            rest.is_in_the_way
                || rest.disturbed != 0
                || is_near(block, |near| rests[near].disturbed)
        };
        rests.iter().zip(&self.net.blocks).map(is_stirred).collect()
    }
}
