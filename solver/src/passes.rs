//! The passes of a step one by one, for `benches/`. A run needs [`Simulation::step`] alone.

use super::{Simulation, StepBound};

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
        let still = StepBound { step: 0.0 };
        match pass {
            Pass::Sort => {
                self.sort(still);
                self.fill_gas(0.0);
            }
            Pass::List => self.list(still),
            Pass::Summation => self.read_densities(),
            Pass::Renormalisation => self.renormalise(),
            Pass::Rates => self.sum_rates(),
            Pass::TimeStep => {
                self.time_step();
            }
        }
    }

    /// Neighbours listed and pairs in those lists, lanes of a cluster counted one by one.
    pub fn listed_pairs(&self) -> usize {
        let clusters = self.lists.all().clusters;
        clusters
            .iter()
            .map(|c| (c.gas.len() + c.wall.len()) * c.targets.len())
            .sum()
    }
}
