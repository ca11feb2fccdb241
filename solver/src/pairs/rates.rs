//! Rates of density, velocity and energy of all particles, from the sums over their pairs.

use rayon::prelude::*;

use crate::problem::Equations;

use super::super::lanes::Lane;
use super::super::neighbours::{Chunk, Lists};
use super::super::particles::{ByPressure, Rates};
use super::super::records::{GHOSTS, Matrix, Number, Records};
use super::super::vectors::{Arch, Pass, Vectors};
use super::super::walls::even_renormalisation;
use super::artificial_conduction::CONDUCTION;
use super::density_diffusion::DIFFUSION;
use super::renormalisation::Renormalisation;
use super::sums::{Forces, Own, Sums};
use super::{LaneVector, unlane, zeros};

/// Which sums a scheme asks for. Its switches are asked of every pair: the answer is always foreseen.
#[derive(Clone, Copy, Debug)]
pub struct Sought {
    /// Its equations.
    pub equations: Equations,
    /// How it moves particles.
    pub transport: Transport,
    /// Its viscosity spares what varies linearly.
    pub limits_viscosity: bool,
    /// Its conduction does.
    pub limits_conduction: bool,
}

/// How the flow is kept in place where particles move otherwise than with it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Transport {
    /// They move with it.
    None,
    /// The shifts in the rates alone, by advection terms [Villodi & Ramachandran 2024, eqs 19-21].
    Advection,
    /// All shifts, by exchange between pairs; of the conservative scheme.
    Exchange,
}

/// Rates of every listed particle of the fluid [Villodi & Ramachandran 2024, eqs 10, 12, 14; signs as
/// derived from the continuum equations].
///
/// The shifts in `rates` are read and kept; all else is overwritten.
pub fn rates<const D: usize>(
    arch: Arch,
    lists: &Lists,
    records: &Records<D>,
    renormalisations: &[Renormalisation<D>],
    sought: Sought,
    rates: &mut [Rates<D>],
) {
    lists
        .chunks
        .par_iter()
        .zip(rates.par_chunks_mut(lists.chunk_targets()))
        .for_each(|(chunk, rates)| {
            let pass = Work {
                chunk,
                records,
                sought,
                rates,
            };
            let own = renormalisations;
            match (sought.equations, sought.transport) {
                (Equations::Paper, Transport::None) => {
                    arch.dispatch(FluidPass::<D, false, false, false>(pass, own));
                }
                (Equations::Paper, _) => {
                    arch.dispatch(FluidPass::<D, false, true, false>(pass, own));
                }
                (Equations::Conservative, Transport::None) => {
                    arch.dispatch(FluidPass::<D, true, false, false>(pass, own));
                }
                (Equations::Conservative, Transport::Advection) => {
                    arch.dispatch(FluidPass::<D, true, true, false>(pass, own));
                }
                (Equations::Conservative, Transport::Exchange) => {
                    arch.dispatch(FluidPass::<D, true, false, true>(pass, own));
                }
            }
        });
}

/// Accelerations that the gas would give ghosts of mass `rho V`: by the pair laws' symmetry the
/// force on each ghost.
pub fn reactions<const D: usize>(
    arch: Arch,
    lists: &Lists,
    records: &Records<D>,
    sought: Sought,
    rates: &mut [Rates<D>],
) {
    lists
        .chunks
        .par_iter()
        .zip(rates.par_chunks_mut(lists.chunk_targets()))
        .for_each(|(chunk, rates)| {
            let pass = Work {
                chunk,
                records,
                sought,
                rates,
            };
            match sought.equations {
                Equations::Paper => arch.dispatch(ReactionPass::<D, false>(pass)),
                Equations::Conservative => arch.dispatch(ReactionPass::<D, true>(pass)),
            }
        });
}

struct Work<'a, const D: usize> {
    chunk: &'a Chunk,
    records: &'a Records<D>,
    sought: Sought,
    rates: &'a mut [Rates<D>],
}

/// With the renormalisation of the fluid.
struct FluidPass<
    'a,
    const D: usize,
    const CONSERVATIVE: bool,
    const SHIFTED: bool,
    const EXCHANGES: bool,
>(Work<'a, D>, &'a [Renormalisation<D>]);

struct ReactionPass<'a, const D: usize, const CONSERVATIVE: bool>(Work<'a, D>);

impl<const D: usize, const CONSERVATIVE: bool, const SHIFTED: bool, const EXCHANGES: bool> Pass
    for FluidPass<'_, D, CONSERVATIVE, SHIFTED, EXCHANGES>
{
    type Output = ();

    #[inline(always)]
    fn run<V: Vectors>(self, vectors: V) {
        let Self(pass, renormalisations) = self;
        let (chunk, records, sought) = (pass.chunk, pass.records, pass.sought);
        let read = V::Number::of(records);
        let per_length = Lane::splat(vectors, read.per_length);
        let mut results = pass.rates.iter_mut();
        for cluster in &chunk.clusters {
            if cluster.is_calm {
                let calm = results.by_ref().take(cluster.targets.len());
                calm.for_each(|rates| *rates = Rates::default());
                continue;
            }
            let (start, last) = (cluster.targets.start, cluster.targets.end - 1);
            let own = Own::load(vectors, read, |l| (start + l).min(last));
            let own_shift: LaneVector<V, D> = if EXCHANGES {
                let shift = |l: usize| &read.shift[(start + l).min(last)];
                std::array::from_fn(|k| Lane::gather(vectors, |l| shift(l)[k]))
            } else {
                zeros(vectors)
            };
            let mut sums = Sums::new(vectors);
            for &j in &chunk.entries[cluster.gas.clone()] {
                let (near, state) = (&read.near[j as usize], &read.state[j as usize]);
                sums.add::<true, CONSERVATIVE, SHIFTED>(vectors, sought, &own, (near, state));
                if EXCHANGES {
                    sums.exchange(vectors, &own, &own_shift, read, j as usize);
                }
            }
            let by_gas = Forces::from(&sums.per_length(per_length));
            for &j in &chunk.entries[cluster.wall.clone()] {
                let (near, state) = (&read.near[j as usize], &read.state[j as usize]);
                sums.add::<false, CONSERVATIVE, SHIFTED>(vectors, sought, &own, (near, state));
            }
            let sums = sums.per_length(per_length);
            let forces = Forces::from(&sums);
            let velocity_gradient = sums.velocity_gradient.map(|row| row.map(Lane::to_array));
            let energy_gradient = sums.energy_gradient.map(Lane::to_array);
            let heat = sums.viscous_heat.to_array();
            let conduction = sums.conduction.to_array();
            let diffusion = sums.diffusion.to_array();
            let exchange = (
                sums.exchange.density.to_array(),
                sums.exchange.velocity.map(Lane::to_array),
                sums.exchange.energy.to_array(),
            );

            for (l, rates) in results.by_ref().take(cluster.targets.len()).enumerate() {
                let (near, state) = (&records.near[start + l], &records.state[start + l]);
                let Renormalisation {
                    matrix: renormalisation,
                    density_gradient,
                    ..
                } = &renormalisations[start + l];
                let slope = Matrix::<D>::from_fn(|a, b| velocity_gradient[a][b][l]);
                let divergence = slope.component_mul(renormalisation).sum();
                rates.velocity_gradient = slope * renormalisation;
                let energy_slope = unlane(&energy_gradient, l);
                if CONSERVATIVE {
                    rates.energy_gradient = renormalisation * energy_slope;
                }
                let pressure = state.pressure;
                let total = forces.acceleration(l, near, pressure, renormalisation);
                rates.acceleration = by_gas.acceleration(l, near, pressure, renormalisation);
                rates.wall_acceleration = total - rates.acceleration;
                rates.by_pressure = ByPressure {
                    acceleration: forces.by_pressure(l, near, pressure, renormalisation),
                    heating: -state.pressure / near.density() * divergence,
                };
                rates.density = -near.density() * divergence;
                if !CONSERVATIVE {
                    rates.density += DIFFUSION * diffusion[l];
                }
                rates.energy =
                    CONDUCTION * conduction[l] - 0.5 * heat[l] + rates.by_pressure.heating;
                if SHIFTED {
                    let shift = renormalisation * rates.shift;
                    rates.acceleration += slope * shift;
                    rates.energy += energy_slope.dot(&shift);
                    rates.density += density_gradient.dot(&rates.shift);
                }
                if EXCHANGES {
                    let (density, velocity, energy) = &exchange;
                    rates.acceleration += unlane(velocity, l);
                    rates.energy += energy[l];
                    // What the sum over the moved particles will read.
                    rates.density += density[l];
                }
            }
        }
    }
}

impl<const D: usize, const CONSERVATIVE: bool> Pass for ReactionPass<'_, D, CONSERVATIVE> {
    type Output = ();

    #[inline(always)]
    fn run<V: Vectors>(self, vectors: V) {
        let Work {
            chunk,
            records,
            sought,
            rates,
        } = self.0;
        let first = records.start[GHOSTS];
        let even = even_renormalisation();
        let read = V::Number::of(records);
        let per_length = Lane::splat(vectors, read.per_length);
        let mut results = rates.iter_mut();
        for cluster in &chunk.clusters {
            let (start, last) = (
                first + cluster.targets.start,
                first + cluster.targets.end - 1,
            );
            let own = Own::load(vectors, read, |l| (start + l).min(last));
            let mut sums = Sums::new(vectors);
            for &j in &chunk.entries[cluster.gas.clone()] {
                let (near, state) = (&read.near[j as usize], &read.state[j as usize]);
                sums.add::<false, CONSERVATIVE, false>(vectors, sought, &own, (near, state));
            }
            let sums = sums.per_length(per_length);
            let forces = Forces::from(&sums);
            for (l, rates) in results.by_ref().take(cluster.targets.len()).enumerate() {
                let (near, state) = (&records.near[start + l], &records.state[start + l]);
                rates.acceleration = forces.acceleration(l, near, state.pressure, &even);
            }
        }
    }
}
