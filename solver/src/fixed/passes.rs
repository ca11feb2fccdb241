//! From what cells hold to their states and slopes, and from these to what flows: the passes that marching and settling share.

use aero_geometry::parallel::prelude::*;

use super::cloven::{Cleaving, shocks};
use super::columns::Columns;
use super::drawing::drawing;
use super::energy::EnergyFlux;
use super::equation_of_state::AnyGas;
use super::exchange::Exchange;
use super::gains::Gains;
use super::gradients::slopes;
use super::net::{Among, BLOCK, Net};
use super::quiet::Quiet;
use super::reach::bound;
use super::slopes::Flow;
use super::slopes::Slopes;
use super::slow::least_mach;
use super::state::{Conserved, dot};
use super::viscous::Rubbing;
use super::{FixedSimulation, Fluid};

/// Cells of a block.
pub(super) struct Part<'a, const D: usize> {
    /// The first one.
    pub start: usize,
    /// What each holds.
    pub held: &'a mut [Conserved<D>],
    /// What each held before the step.
    pub before: &'a mut [Conserved<D>],
}

/// What a pass over a block's states finds.
#[derive(Clone, Debug, Default)]
struct Found {
    /// Cells whose state is none of a gas.
    bad: Vec<u32>,
    min_density: f64,
    min_energy: f64,
}

impl<const D: usize> FixedSimulation<D> {
    /// Slopes of all cells that are awake; returns the least of `V / L`.
    pub(super) fn find_slopes(&mut self) -> f64 {
        self.turn_around_axis();
        self.find_reaches()
            .into_iter()
            .fold(f64::INFINITY, f64::min)
    }

    /// The same; returns the least of `V / L` block by block.
    pub(super) fn find_reaches(&mut self) -> Vec<f64> {
        self.find_viscosities();
        let Self {
            fluid: Fluid { gas, viscous },
            net,
            quiet,
            columns,
            ..
        } = self;
        let Columns {
            states,
            slopes: results,
            careful,
            viscosities,
            ..
        } = columns;
        let viscous = viscous.as_ref().map(|viscous| (viscous, &**viscosities));
        let least: Vec<f64> = net
            .blocks
            .par_iter()
            .zip(results.par_chunks_mut(BLOCK))
            .zip(&quiet.blocks)
            .map(|((block, results), quiet)| {
                if quiet.is_awake {
                    slopes(gas, net, block, states, viscous, results)
                } else {
                    quiet.reach
                }
            })
            .collect();
        for &i in careful.iter() {
            results[i as usize].calmness = Slopes::<D>::CAREFUL;
        }
        least
    }

    /// Viscosities of all cells, of gas that has one.
    fn find_viscosities(&mut self) {
        let Some(viscous) = &self.fluid.viscous else {
            return;
        };
        let Columns {
            states,
            viscosities,
            ..
        } = &mut self.columns;
        states
            .par_iter()
            .map(|state| viscous.viscosity(state))
            .collect_into_vec(viscosities);
    }

    /// What flows in each block that is awake, as `apply` takes it; returns what all cells gain through walls and sides.
    pub(super) fn exchange(
        &mut self,
        apply: impl Fn(&Net<D>, Part<'_, D>, &Gains<D>) + Sync,
    ) -> Conserved<D> {
        self.boundaries_of(apply)
            .iter()
            .fold(Conserved::ZERO, |sum, block| sum.plus(1.0, block))
    }

    /// What each block gains through walls and sides in its present state.
    pub(super) fn boundaries(&mut self) -> Vec<Conserved<D>> {
        self.boundaries_of(|_, _, _| {})
    }

    fn boundaries_of(
        &mut self,
        apply: impl Fn(&Net<D>, Part<'_, D>, &Gains<D>) + Sync,
    ) -> Vec<Conserved<D>> {
        let energy = EnergyFlux::of(&self.problem);
        let least_mach = least_mach(&self.problem);
        let drawing = drawing(&self.problem, self.settling.has_begun());
        let is_axisymmetric = self.problem.domain.is_axisymmetric();
        let Self {
            arch,
            fluid: Fluid { gas, viscous },
            points,
            net,
            quiet,
            columns,
            ..
        } = self;
        let Columns {
            states,
            slopes,
            held,
            before,
            pressures,
            viscosities,
            shares,
            ..
        } = columns;
        let flow = Flow { states, slopes };
        let rubbing = viscous.as_ref().map(|viscous| Rubbing {
            viscous,
            viscosities,
            points,
            is_axisymmetric,
        });
        let rests = quiet.blocks.as_slice();
        // Gas that rubs sticks to walls: no shock stands at their bends.
        let mut standing: Vec<Vec<Cleaving<'_, D>>> = net
            .blocks
            .par_iter()
            .zip(&quiet.blocks)
            .map(|(block, quiet)| {
                if quiet.is_awake && rubbing.is_none() {
                    shocks(gas, block, states)
                } else {
                    Vec::new()
                }
            })
            .collect();
        bound(gas, &mut standing, states);
        net.blocks
            .par_iter()
            .zip(held.par_chunks_mut(BLOCK))
            .zip(before.par_chunks_mut(BLOCK))
            .zip(pressures.par_iter_mut())
            .zip(shares.par_iter_mut())
            .zip(&standing)
            .zip(&quiet.blocks)
            .map(
                |((((((block, held), before), pressures), shares), shocks), quiet)| {
                    if !quiet.is_awake {
                        return quiet.boundary;
                    }
                    let exchange = Exchange {
                        gas: &*gas,
                        net: &*net,
                        points,
                        rests,
                        energy,
                        least_mach,
                        drawing,
                        block,
                        flow,
                        shocks,
                        pressures: pressures.as_mut_slice(),
                        rubbing,
                        shares,
                    };
                    let gains = match &*gas {
                        AnyGas::Ideal(gas) => exchange.of(gas).gains(*arch),
                        AnyGas::Air(gas) => exchange.of(gas).gains(*arch),
                    };
                    let boundary = gains.boundary;
                    let start = block.cells.start;
                    apply(
                        net,
                        Part {
                            start,
                            held,
                            before,
                        },
                        &gains,
                    );
                    boundary
                },
            )
            .collect()
    }

    /// Reads the states off what the cells hold; the cells where that is no gas are the error.
    pub(super) fn find_states(&mut self) -> Result<(), Vec<u32>> {
        let Self {
            fluid,
            quiet,
            columns,
            ..
        } = self;
        let Columns { held, states, .. } = columns;
        let Quiet { stream, blocks } = quiet;
        let found: Vec<Found> = states
            .par_chunks_mut(BLOCK)
            .zip(held.par_chunks(BLOCK))
            .zip(blocks.par_iter_mut())
            .enumerate()
            .map(|(block, ((states, held), quiet))| {
                let mut found = Found {
                    min_density: f64::INFINITY,
                    min_energy: f64::INFINITY,
                    ..Found::default()
                };
                if !quiet.is_awake {
                    return found;
                }
                for (k, (state, held)) in states.iter_mut().zip(held).enumerate() {
                    *state = held.primitive(&fluid.gas);
                    if !state.makes_sense() {
                        found.bad.push((block * BLOCK + k) as u32);
                    }
                    found.min_density = found.min_density.min(state.density);
                    let energy = fluid
                        .gas
                        .energy_measure(state.pressure / state.density, || {
                            held.energy / held.mass - 0.5 * dot(&state.velocity, &state.velocity)
                        });
                    found.min_energy = found.min_energy.min(energy);
                }
                quiet.disturbed = stream
                    .as_ref()
                    .map_or(Among::MAX, |stream| stream.disturbed(states));
                found
            })
            .collect();
        let bad: Vec<u32> = found.iter().flat_map(|found| &found.bad).copied().collect();
        if !bad.is_empty() {
            return Err(bad);
        }
        for found in found {
            self.tally.min_density = self.tally.min_density.min(found.min_density);
            let energy = found.min_energy / self.fluid.gas.unit_energy();
            self.tally.min_energy = self.tally.min_energy.min(energy);
        }
        Ok(())
    }
}
