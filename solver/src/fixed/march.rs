//! One step of an unsteady flow: the third-order method in three stages that keeps totals, and whatever a single stage of Euler preserves
//! [Shu & Osher 1988, J. Comput. Phys. 77, 439-471].
//!
//! `U1 = U + dt R(U)`, `U2 = U + (U1 + dt R(U1) - U) / 4`, `U' = U + 2 (U2 + dt R(U2) - U) / 3`.

use aero_geometry::parallel::prelude::*;

use super::FixedSimulation;
use super::columns::Columns;
use super::net::BLOCK;
use super::state::{Conserved, Primitive};
use crate::Failure;
use crate::walls::rigid::pad;

/// How often a step is halved before the run stops.
const HALVINGS: u32 = 8;

/// How often a step is taken again with more cells in first order, before it is halved.
const RETRIES: u32 = 4;

/// A stage, `U' = (1 - new) U_0 + new (U + dt R(U))`.
#[derive(Clone, Copy, Debug)]
struct Stage {
    new: f64,
    /// When `U` is, in steps from the beginning.
    at: f64,
    /// What `R(U)` counts in the whole step.
    share: f64,
}

/// Their order.
const STAGES: [Stage; 3] = [
    Stage {
        new: 1.0,
        at: 0.0,
        share: 1.0 / 6.0,
    },
    Stage {
        new: 0.25,
        at: 1.0,
        share: 1.0 / 6.0,
    },
    Stage {
        new: 2.0 / 3.0,
        at: 0.5,
        share: 2.0 / 3.0,
    },
];

impl<const D: usize> FixedSimulation<D> {
    /// Advances by one time step, no further than `limit`; returns the step taken.
    ///
    /// A cell that would be left without density or pressure is taken again in first order; only where that does not
    /// help is the step halved.
    ///
    /// # Errors
    /// A [`Failure`] where that does not help either; the simulation then stands at its last good state.
    pub fn step(&mut self, limit: f64) -> Result<f64, Failure> {
        self.adapt_marching()?;
        self.wake();
        self.columns.careful.clear();
        self.give(self.tally.time);
        let least = self.find_slopes();
        let points = self.problem.method.fixed().copied().unwrap_or_default();
        let free = 2.0 * points.cfl * least;
        let mut step = if self.tally.time + free * (1.0 + 1e-9) >= limit {
            limit - self.tally.time
        } else {
            free
        };
        self.keep();
        let (mut halvings, mut retries) = (0, 0);
        while let Err(bad) = self.try_step(step) {
            self.restore();
            self.give(self.tally.time);
            let known = self.columns.careful.len();
            self.columns.careful.extend(&bad);
            self.columns.careful.sort_unstable();
            self.columns.careful.dedup();
            retries += 1;
            if retries > RETRIES || self.columns.careful.len() == known {
                if halvings == HALVINGS {
                    return Err(self.failure(bad[0]));
                }
                step *= 0.5;
                halvings += 1;
                retries = 0;
            }
            self.find_slopes();
        }
        self.tally.time = if limit - self.tally.time == step {
            limit
        } else {
            self.tally.time + step
        };
        self.ride(step);
        self.tally.steps += 1;
        self.tally.updates += self.awake_cells();
        Ok(step)
    }

    /// All stages; the cells that do not bear it are the error.
    fn try_step(&mut self, step: f64) -> Result<(), Vec<u32>> {
        let start = self.tally.time;
        let mut received = Conserved::ZERO;
        for stage in STAGES {
            let time = start + stage.at * step;
            if stage.at > 0.0 {
                self.wake_more();
                self.give(time);
                self.find_slopes();
            }
            let boundary = self.stage(stage.new, step, time);
            self.find_states()?;
            received = received.plus(stage.share * step, &boundary);
        }
        self.tally.received = self.tally.received.plus(1.0, &received);
        Ok(())
    }

    fn stage(&mut self, new: f64, step: f64, time: f64) -> Conserved<D> {
        let boundary = self.exchange(|net, part, gains| {
            let cells = part.held.iter_mut().zip(&*part.before).zip(&gains.cells);
            for (k, ((held, before), gain)) in cells.enumerate() {
                let there = held.plus(step / net.cell(part.start + k).volume, gain);
                *held = if new == 1.0 {
                    there
                } else {
                    before.plus(new, &there.plus(-1.0, before))
                };
            }
        });
        self.add_source(new * step, time);
        boundary
    }

    /// Keeps the state for a step that fails, and for later stages.
    fn keep(&mut self) {
        let Self { quiet, columns, .. } = self;
        let Columns { held, before, .. } = columns;
        before
            .par_chunks_mut(BLOCK)
            .zip(held.par_chunks(BLOCK))
            .zip(&quiet.blocks)
            .for_each(|((before, held), quiet)| {
                if quiet.is_awake {
                    before.copy_from_slice(held);
                }
            });
    }

    fn restore(&mut self) {
        let Self {
            fluid,
            quiet,
            columns,
            ..
        } = self;
        let Columns {
            held,
            before,
            states,
            ..
        } = columns;
        for (block, quiet) in quiet.blocks.iter().enumerate() {
            if quiet.is_awake {
                let cells = block * BLOCK..((block + 1) * BLOCK).min(held.len());
                for i in cells {
                    held[i] = before[i];
                    states[i] = held[i].primitive(&fluid.gas);
                }
            }
        }
    }

    pub(super) fn failure(&self, cell: u32) -> Failure {
        let i = cell as usize;
        let Primitive {
            density, pressure, ..
        } = self.columns.states[i];
        Failure {
            reason: format!(
                "a cell loses all of its density or pressure within the shortest step; it had a density of {density:.3e} and a \
                 pressure of {pressure:.3e}; use a smaller `spacing`, or `scheme.motion = \"with-the-gas\"`"
            ),
            particle: Some(u64::from(cell)),
            position: pad(&self.points[i]).into(),
            step: self.tally.steps,
            time: self.tally.time,
        }
    }
}
