//! The passes of a step one by one, for `benches/`. A run needs [`Simulation::step`] alone.

use super::Simulation;
use super::evaluation::{read_densities, renormalise, sum_rates};
use super::fill::fill_gas;

/// One pass of a step. Each may follow any other; none moves a particle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pass {
    /// Sorts all particles in space and makes images.
    Sort,
    /// Lists the neighbours.
    List,
    /// Density by summation.
    Summation,
    /// Renormalisation matrices and density gradients.
    Renormalisation,
    /// Rates of density, velocity and energy.
    Rates,
    /// The stable time step, from the particles and their rates.
    TimeStep,
}

impl Pass {
    /// All of them, in the order of a step.
    pub const ALL: [Self; 6] = [
        Self::Sort,
        Self::List,
        Self::Summation,
        Self::Renormalisation,
        Self::Rates,
        Self::TimeStep,
    ];
}

impl<const D: usize> Simulation<D> {
    /// Does one pass at the present time.
    pub fn pass(&mut self, pass: Pass) {
        let Self {
            problem,
            clock,
            fluid,
            buffers,
            walls,
            around,
            ..
        } = self;
        let now = (clock.time, 0.0);
        match pass {
            Pass::Sort => {
                around.sort(problem, now, fluid, buffers, walls);
                fill_gas(problem, 0.0, fluid, buffers, around);
            }
            Pass::List => around.list(now, fluid, buffers, walls),
            Pass::Summation => read_densities(problem, fluid, around),
            Pass::Renormalisation => renormalise(problem, fluid, around),
            Pass::Rates => sum_rates(problem, fluid, around),
            Pass::TimeStep => {
                let columns = fluid.columns();
                let bound = problem.scheme.step;
                bound.time_step(&problem.gases(), columns.state, columns.rates);
            }
        }
    }

    /// Neighbours listed and pairs in those lists, lanes of a cluster counted one by one.
    pub fn listed_pairs(&self) -> usize {
        let clusters = self.around.lists.all().clusters;
        clusters
            .iter()
            .map(|c| (c.gas.len() + c.wall.len()) * c.targets.len())
            .sum()
    }
}
