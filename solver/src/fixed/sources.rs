//! What a problem adds to the rates of cells, and to what its walls hold up.

use aero_geometry::Vector;
use aero_geometry::parallel::prelude::*;

use super::FixedSimulation;
use super::columns::Columns;
use super::equation_of_state::AnyGas;
use super::state::{Conserved, Primitive};
use crate::problem::Added;

impl<const D: usize> FixedSimulation<D> {
    /// Adds to what cells hold what the source gives them over `step`, by their states and as it is at `time`.
    pub(super) fn add_source(&mut self, step: f64, time: f64) {
        let Some(source) = &self.problem.source else {
            return;
        };
        let gas = self.fluid.gas;
        let Columns { held, states, .. } = &mut self.columns;
        held.par_iter_mut()
            .zip(&*states)
            .zip(&self.points)
            .for_each(|((held, state), point)| {
                let gain = per_volume(&source.at(point, time), state, gas);
                *held = held.plus(step, &gain);
            });
    }

    /// Adds the source to what each cell gains per time, which stands where what it held before does.
    pub(super) fn add_steady_source(&mut self) {
        let Some(source) = &self.problem.source else {
            return;
        };
        let gas = self.fluid.gas;
        let net = &self.net;
        let Columns { before, states, .. } = &mut self.columns;
        before
            .par_iter_mut()
            .zip(&*states)
            .zip(&self.points)
            .enumerate()
            .for_each(|(i, ((gains, state), point))| {
                let gain = per_volume(&source.at(point, 0.0), state, gas);
                *gains = gains.plus(net.cell(i).volume, &gain);
            });
    }

    /// Tells walls what drives the gas into them at `time`.
    pub(super) fn push_walls(&mut self, time: f64) {
        let Some(source) = &self.problem.source else {
            return;
        };
        for wall in self
            .net
            .blocks
            .iter_mut()
            .flat_map(|block| &mut block.walls)
        {
            let normal = Vector::from(wall.image.normal);
            wall.push = source.at(&wall.foot, time).acceleration.dot(&normal);
        }
    }
}

/// What is added to gas in `state`, per volume: `S`, `rho a + u S` and `rho (q + u.a) + (e + u^2 / 2) S`.
fn per_volume<const D: usize>(added: &Added<D>, state: &Primitive<D>, gas: AnyGas) -> Conserved<D> {
    let velocity = Vector::from(state.velocity);
    let energy = state.conserved(&gas).energy / state.density;
    let work = velocity.dot(&added.acceleration);
    Conserved {
        mass: added.density,
        momentum: (added.acceleration * state.density + velocity * added.density).into(),
        energy: state.density * (added.heating + work) + energy * added.density,
    }
}
