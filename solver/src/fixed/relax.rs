//! One implicit step towards the steady state without matrices: lower-upper symmetric Gauss-Seidel.
//!
//! The left-hand side knows the first-order scheme alone; what that asks of the steps is in [`super::staged`].
//!
//! [Yoon & Jameson 1988, AIAA J. 26, 1025-1026; the fluxes of changes linearised, as there]

use std::ops::Range;

use aero_geometry::parallel::prelude::*;

use super::columns::Columns;
use super::equation_of_state::EquationOfState;
use super::net::BLOCK;
use super::order::Link;
use super::quiet::Rest;
use super::state::{Conserved, Primitive, dot, scaled};
use super::sweeps::{Level, Sweeps};
use super::viscous::add_reaches;
use super::{FixedSimulation, Fluid};
use crate::Failure;

/// A cell changes its density in one step by this part at most.
const MOST: f64 = 0.3;

/// A cell keeps this part of its pressure in one step at least.
const LEAST: f64 = 0.2;

/// How often the change of a cell is halved that would leave less.
const HALVINGS: u32 = 20;

/// Cells of a level that one thread takes at a time.
const CHUNK: usize = 64;

/// The linear system of a step: `D_i = L_i (1/2 + 1/(2 c))`, `L_i` the sum of wave speed times area, and neighbours.
struct System<'a> {
    sweeps: &'a Sweeps,
    /// `L_i` of each cell that is awake, in the order of their places.
    reaches: &'a [f64],
    /// Speed of sound of each cell that is awake, by its number.
    sounds: &'a [f64],
    /// `1/2 + 1/(2 c)`.
    share: f64,
}

/// Which way, and what is known of the changes beside the cells that are computed.
#[derive(Clone, Copy, PartialEq)]
enum Sweep {
    /// Along the flow, from nothing.
    First,
    /// Back from there.
    Back,
    /// Either way, over changes that are known of all cells.
    Again,
}

impl<const D: usize> FixedSimulation<D> {
    /// Goes the part of the way that `parts` says block by block, and that the rates of the flow as it is ask for, from what blocks held at the
    /// `start` or from where the flow is; returns the square mean of the relative rates of density, times the time in which a wave crosses a cell.
    ///
    /// # Errors
    /// A [`Failure`] where a cell's state makes no sense any more.
    pub(super) fn implicit_stage(
        &mut self,
        courant: f64,
        parts: impl Fn(usize) -> f64,
        start: Option<&[Vec<Conserved<D>>]>,
    ) -> Result<f64, Failure> {
        self.find_slopes();
        self.exchange(|_, part, gains| part.before.copy_from_slice(&gains.cells));
        self.add_steady_source();
        let mut sweeps = self.settling.sweeps.take().unwrap_or_else(|| {
            let stream = &self.problem.free_stream.velocity;
            Sweeps::new(&self.net, |i| {
                if stream.norm_squared() > 0.0 {
                    self.points[i].dot(stream)
                } else {
                    self.points[i][0]
                }
            })
        });
        let is_awake = |rest: &Rest<D>| rest.is_awake;
        let awake: Vec<bool> = self.quiet.blocks.iter().map(is_awake).collect();
        sweeps.wake(&awake);
        let sounds = self.sounds();
        let reaches = self.reaches(&sweeps, &sounds);
        let residual = self.residual(&sweeps, &reaches);
        let changes = self.solved(&System {
            sweeps: &sweeps,
            reaches: &reaches,
            sounds: &sounds,
            share: 0.5 + 0.5 / courant,
        });
        for &place in sweeps.awake() {
            let i = sweeps.cell(place as usize);
            if let Some(start) = start {
                self.columns.held[i] = start[i / BLOCK][i % BLOCK];
            }
            let change = Conserved::ZERO.plus(parts(i / BLOCK), &changes[place as usize]);
            self.columns.held[i] = self.changed(i, &change);
        }
        self.settling.sweeps = Some(sweeps);
        match self.find_states() {
            Ok(()) => Ok(residual),
            Err(bad) => Err(self.failure(bad[0])),
        }
    }

    /// The changes that a system asks for, place by place. A stream slower than sound carries nothing out of the domain at once, and what the
    /// first sweeps leave of the system is worth others; a flow that began near its end has all its cells from the first step on, and is
    /// there in fewer steps for one more sweep.
    fn solved(&self, system: &System<'_>) -> Vec<Conserved<D>> {
        let mut changes = vec![Conserved::ZERO; system.sweeps.len()];
        let levels: Vec<Level> = system.sweeps.levels().collect();
        let most = levels.iter().map(|level| level.awake.len()).max();
        let mut room = vec![Conserved::ZERO; most.unwrap_or(0)];
        let mut relax = |level, sweep| self.relax(system, level, sweep, &mut changes, &mut room);
        for level in &levels {
            relax(level, Sweep::First);
        }
        for level in levels.iter().rev() {
            relax(level, Sweep::Back);
        }
        if self.is_slow() {
            for level in levels.iter().chain(levels.iter().rev()) {
                relax(level, Sweep::Again);
            }
        } else if self.settling.is_near {
            for level in &levels {
                relax(level, Sweep::Again);
            }
        }
        changes
    }

    /// Computes the changes of the cells of one level:
    /// forward `dU_i = [R_i - 1/2 sum_before (dF_j.A - lambda_j A dU_j)] / D_i`, backward
    /// `dU_i -= 1/2 sum_after (dF_j.A - lambda_j A dU_j) / D_i`; again, over all neighbours, as forward.
    fn relax(
        &self,
        system: &System<'_>,
        level: &Level,
        sweep: Sweep,
        changes: &mut [Conserved<D>],
        room: &mut [Conserved<D>],
    ) {
        let Range { start, end } = level.places;
        let known = &*changes;
        let awake = &system.sweeps.awake()[level.awake.clone()];
        let room = &mut room[..awake.len()];
        let reaches = &system.reaches[level.awake.clone()];
        let pairs = awake.par_iter().zip(reaches).with_min_len(CHUNK);
        let each = pairs.map(|(&place, &reach)| {
            let place = place as usize;
            let i = system.sweeps.cell(place);
            let links = system.sweeps.links(place).iter();
            let beside = links.filter_map(|link| {
                let at = link.place as usize;
                let is_known = match sweep {
                    Sweep::First => at < start,
                    Sweep::Back => at >= end,
                    Sweep::Again => true,
                };
                is_known.then(|| (link, &known[at]))
            });
            let beside = self.neighbours(beside, system.sounds);
            let over = 1.0 / (system.share * reach);
            match sweep {
                Sweep::Back => known[place].plus(-0.5 * over, &beside),
                _ => Conserved::ZERO.plus(over, &self.columns.before[i].plus(-0.5, &beside)),
            }
        });
        each.zip(&mut *room).for_each(|(change, at)| *at = change);
        for (&place, change) in awake.iter().zip(room) {
            changes[place as usize] = *change;
        }
    }

    /// Speed of sound of each cell that is awake, by its number.
    fn sounds(&self) -> Vec<f64> {
        let mut sounds = vec![0.0; self.columns.states.len()];
        let blocks = sounds.par_chunks_mut(BLOCK).zip(&self.quiet.blocks);
        let states = self.columns.states.par_chunks(BLOCK);
        blocks
            .zip(states)
            .filter(|((_, rest), _)| rest.is_awake)
            .for_each(|((sounds, _), states)| {
                for (sound, state) in sounds.iter_mut().zip(states) {
                    *sound = self.sound(state);
                }
            });
        sounds
    }

    /// Sum of wave speed times area over all faces of each cell that is awake, in the order of their places.
    fn reaches(&self, sweeps: &Sweeps, sounds: &[f64]) -> Vec<f64> {
        let mut ends = vec![0.0; self.columns.held.len()];
        for (block, rest) in self.net.blocks.iter().zip(&self.quiet.blocks) {
            if !rest.is_awake {
                continue;
            }
            let walls = block.walls.iter().map(|wall| (wall.i, &wall.image));
            let sides = block.sides.iter().map(|side| (side.i, &side.image));
            for (i, image) in walls.chain(sides) {
                let state = &self.columns.states[i as usize];
                let speed = dot(&state.velocity, &image.normal).abs() + sounds[i as usize];
                ends[i as usize] += speed * image.size;
            }
            if let Some(viscous) = &self.fluid.viscous {
                let Columns {
                    states,
                    viscosities,
                    ..
                } = &self.columns;
                let add = |i: usize, reach| ends[i] += reach;
                add_reaches(viscous, &self.net, block, states, viscosities, add);
            }
        }
        let reach = |&place: &u32| {
            let i = sweeps.cell(place as usize);
            let (state, sound) = (&self.columns.states[i], sounds[i]);
            let mut sum = ends[i];
            for link in sweeps.links(place as usize) {
                let shape = &self.net.face_shapes[link.shape()];
                sum += dot(&state.velocity, &shape.area).abs() + sound * shape.size;
            }
            sum
        };
        let places = sweeps.awake().par_iter().with_min_len(CHUNK);
        places.map(reach).collect()
    }

    fn sound(&self, state: &Primitive<D>) -> f64 {
        self.fluid
            .gas
            .sound_square(state.density, state.pressure)
            .sqrt()
    }

    /// Mean over the cells that are awake of how much of its mass each gains while a wave crosses it.
    fn residual(&self, sweeps: &Sweeps, reaches: &[f64]) -> f64 {
        let mut sum = 0.0;
        for (&place, reach) in sweeps.awake().iter().zip(reaches) {
            let i = sweeps.cell(place as usize);
            let part = self.columns.before[i].mass / (self.columns.held[i].mass * reach);
            sum += part * part;
        }
        let count = reaches.len().max(1) as f64;
        f64::sqrt(sum / count)
    }

    /// `sum (dF_j.A_ij - lambda_j A_ij dU_j)` over the neighbours with `known` changes.
    fn neighbours<'a>(
        &self,
        known: impl Iterator<Item = (&'a Link, &'a Conserved<D>)>,
        sounds: &[f64],
    ) -> Conserved<D> {
        let Fluid { gas, viscous } = &self.fluid;
        let mut sum = Conserved::ZERO;
        for (link, change) in known {
            let j = link.cell as usize;
            let shape = &self.net.face_shapes[link.shape()];
            let area = scaled(&shape.area, link.sign());
            let state = &self.columns.states[j];
            let speed = dot(&state.velocity, &area);
            let moved = state.flux_change(gas, self.columns.held[j].energy, &area, change);
            let mut wave = speed.abs() + sounds[j] * shape.size;
            if let Some(viscous) = viscous {
                let apart = dot(&shape.apart, &shape.apart).sqrt();
                let viscosities = [self.columns.viscosities[j]; 2];
                wave += viscous.reach(viscosities, state.density, shape.size, apart);
            }
            sum = sum.plus(1.0, &moved).plus(-wave, change);
        }
        sum
    }

    /// What cell `i` holds after its `change`, which is cut where it would take or give too much.
    fn changed(&self, i: usize, change: &Conserved<D>) -> Conserved<D> {
        let held = &self.columns.held[i];
        let mut part = (MOST * held.mass / change.mass.abs()).min(1.0);
        let least = LEAST * self.columns.states[i].pressure;
        for _ in 0..HALVINGS {
            let changed = held.plus(part, change);
            if changed.primitive(&self.fluid.gas).pressure > least {
                return changed;
            }
            part *= 0.5;
        }
        *held
    }
}
