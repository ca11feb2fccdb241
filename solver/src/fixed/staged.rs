//! In how many stages an implicit step goes.
//!
//! Over second-order slopes, which its left-hand side does not know, one stage of [`super::relax`] is not stable at high Courant numbers: sound
//! aslant to the sweeps, some seventeen cells long, grows by 1.0044 in each at Mach 0.5 and a Courant number of 20 (von Neumann's analysis, on
//! a square lattice). Two stages, of which the first goes [`FIRST_STAGE`] of the way and the second starts where the first did, leave 1.0004,
//! and 1.0000 where the first-order system is swept twice.
//!
//! A stream faster than sound carries what grows out of the domain, but for where it is slower: in gas that a bow shock has stopped sound
//! goes to and fro, and on small cells it has long enough to grow to several times the pressure there. Those blocks go in two stages. The
//! stages are the whole flow's where the residual grows ([`super::pace`]), or where sides throw sound back, as those of a duct do. In
//! viscous gas none has been seen to grow, and most of its cells are those of layers: it goes in one.
//!
//! [Stages around such sweeps: Rossow 2007, J. Comput. Phys. 220, 879-899]

use aero_geometry::parallel::prelude::*;

use super::FixedSimulation;
use super::equation_of_state::EquationOfState;
use super::net::BLOCK;
use super::state::{Conserved, Primitive, dot};
use crate::Failure;
use crate::problem::Side;

/// Part of its way that a step of two stages goes in the first.
const FIRST_STAGE: f64 = 0.4;

impl<const D: usize> FixedSimulation<D> {
    /// One implicit step with the Courant number `courant`, in stages where the flow asks for them; returns the residual of
    /// [`Self::implicit_stage`] at its start.
    ///
    /// # Errors
    /// A [`Failure`] where a cell's state makes no sense any more.
    pub(super) fn implicit_step(&mut self, courant: f64) -> Result<f64, Failure> {
        self.wake();
        let staged = self.staged_blocks();
        if !staged.contains(&true) {
            return self.implicit_stage(courant, |_| 1.0, None);
        }
        let held = self.columns.held.chunks(BLOCK);
        let start = held.zip(&staged);
        let start: Vec<Vec<Conserved<D>>> = start
            .map(|(held, is_staged)| {
                if *is_staged {
                    held.to_vec()
                } else {
                    Vec::new()
                }
            })
            .collect();
        let first = |block: usize| if staged[block] { FIRST_STAGE } else { 1.0 };
        let residual = self.implicit_stage(courant, first, None)?;
        let awake: Vec<bool> = self.quiet.blocks.iter().map(|rest| rest.is_awake).collect();
        for (rest, is_staged) in self.quiet.blocks.iter_mut().zip(&staged) {
            rest.is_awake &= is_staged;
        }
        self.implicit_stage(courant, |_| 1.0, Some(&start))?;
        for (rest, is_awake) in self.quiet.blocks.iter_mut().zip(awake) {
            rest.is_awake = is_awake;
        }
        Ok(residual)
    }

    /// Blocks that go in two stages: all, or those with gas slower than sound in a stream that is faster.
    fn staged_blocks(&self) -> Vec<bool> {
        let are_all = self.settling.pace.is_staged() || self.throws_sound_back();
        if are_all || self.is_slow() || self.fluid.viscous.is_some() {
            return vec![are_all; self.net.blocks.len()];
        }
        let gas = &self.fluid.gas;
        let is_slow = |state: &Primitive<D>| {
            dot(&state.velocity, &state.velocity) < gas.sound_square(state.density, state.pressure)
        };
        let states = self.columns.states.par_chunks(BLOCK);
        let blocks = states.zip(&self.quiet.blocks);
        blocks
            .map(|(states, rest)| rest.is_awake && states.iter().any(is_slow))
            .collect()
    }

    /// True of a stream slower than sound between sides that hold a pressure.
    pub(super) fn throws_sound_back(&self) -> bool {
        self.is_slow() && self.problem.domain.has(Side::holds_pressure)
    }

    /// True of a stream slower than sound.
    pub(super) fn is_slow(&self) -> bool {
        self.problem.stream_mach() < 1.0
    }
}
