//! The undisturbed free stream, which costs next to nothing.
//!
//! A block of cells that hold the free stream's state to a tolerance, with no wall in its way, is *quiet*. One with no other than quiet
//! blocks within two faces sleeps: whatever flows into its cells flows out again, below the tolerance.

use super::FixedSimulation;
use super::beyond::Beyond;
use super::cells::Matrix;
use super::net::{Block, Net};
use super::slopes::Slopes;
use super::state::{Conserved, Primitive};
use super::walls::Wall;
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
    /// True where all `states` are its own.
    pub fn is_in(&self, states: &[Primitive<D>]) -> bool {
        let Primitive {
            density,
            velocity,
            pressure,
        } = self.state;
        let slowest = TOLERANCE * self.sound;
        states.iter().all(|state| {
            (state.density - density).abs() <= TOLERANCE * density
                && (state.pressure - pressure).abs() <= TOLERANCE * pressure
                && (0..D).all(|k| (state.velocity[k] - velocity[k]).abs() <= slowest)
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
    /// True where something in it disturbs the stream in any case.
    pub is_in_the_way: bool,
    /// True where all cells hold the free stream.
    pub is_quiet: bool,
    /// True where its cells have to be computed.
    pub is_awake: bool,
    /// The least of `V / L` in the free stream.
    pub reach: f64,
    /// What it gains through walls and sides in the free stream.
    pub boundary: Conserved<D>,
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
        let rest = |block: &Block<D>| Rest {
            is_in_the_way: stream.is_none_or(|stream| stream.is_disturbed_in(block)),
            is_quiet: false,
            is_awake: true,
            reach: 0.0,
            boundary: Conserved::ZERO,
        };
        Self {
            blocks: net.blocks.iter().map(rest).collect(),
            stream,
        }
    }
}

impl<const D: usize> Stream<D> {
    /// True where walls or sides of `block` do not leave the stream alone.
    fn is_disturbed_in(&self, block: &Block<D>) -> bool {
        let walls = block.walls.iter();
        let mirrors = block
            .sides
            .iter()
            .filter(|s| matches!(s.beyond, Beyond::Mirror));
        let is_bent = |wall: &Wall<D>| wall.curvature != Matrix::<D>::zeros();
        walls
            .clone()
            .any(|wall| is_bent(wall) || wall.stick.is_some())
            || block
                .sides
                .iter()
                .any(|s| matches!(s.beyond, Beyond::Answers(..) | Beyond::Rides(..)))
            || walls
                .map(|wall| &wall.image)
                .chain(mirrors.map(|side| &side.image))
                .any(|image| !self.slides_along(&image.normal))
    }
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
            rest.is_awake = true;
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
            rest.is_quiet = stream.is_in(&self.columns.states[block.cells.clone()]);
        }
    }

    /// Wakes all blocks near one that is not quiet, and puts the others to sleep.
    pub(super) fn wake(&mut self) {
        let disturbs: Vec<bool> = self
            .quiet
            .blocks
            .iter()
            .map(|rest| rest.is_in_the_way || !rest.is_quiet)
            .collect();
        for (rest, block) in self.quiet.blocks.iter_mut().zip(&self.net.blocks) {
            let is_awake = block.nearby.iter().any(|&near| disturbs[near as usize]);
            if rest.is_awake && !is_awake {
                self.columns.slopes[block.cells.clone()].fill(Slopes::LEVEL);
            }
            rest.is_awake = is_awake;
        }
    }
}
