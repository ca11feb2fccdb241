//! Rates of density, velocity and energy: the sum of all pair laws.

use aero_geometry::Vector;
use pulp::{Arch, Simd, WithSimd};
use rayon::prelude::*;

use crate::case::Equations;

use super::super::lanes::Lane;
use super::super::neighbours::{Chunk, Lists};
use super::super::particle::{ByPressure, Rates};
use super::super::records::{GHOSTS, Matrix, Near, Records, State};
use super::super::walls::even_renormalisation;
use super::artificial_conduction::{CONDUCTION, shock_speed, uneven_part};
use super::artificial_viscosity::{
    bare_closing_speed, closing_speed, viscous_pressure, whole_closing_speed,
};
use super::density_diffusion::{DIFFUSION, diffusion};
use super::exchange::exchange_rate;
use super::renormalisation::Renormalisation;
use super::{LaneVector, Pair, Target, dot, dot_add, unlane, zeros};

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
            let pass = Pass {
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
            let pass = Pass {
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

struct Pass<'a, const D: usize> {
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
>(Pass<'a, D>, &'a [Renormalisation<D>]);

struct ReactionPass<'a, const D: usize, const CONSERVATIVE: bool>(Pass<'a, D>);

/// What the sums of particle `i` need of its own state, one per lane.
struct Own<S: Simd, const D: usize> {
    target: Target<S, D>,
    velocity: LaneVector<S, D>,
    half_sound: Lane<S>,
    energy: Lane<S>,
    half_gradient: LaneVector<S, D>,
    /// Rate of strain, on and above the diagonal.
    strain: [LaneVector<S, D>; D],
    energy_slope: LaneVector<S, D>,
}

/// Running sums, one per lane.
#[derive(Clone, Copy)]
struct Sums<S: Simd, const D: usize> {
    /// `sum V_j grad W`.
    gradient: LaneVector<S, D>,
    /// `sum V_j p_j L_j grad W`.
    stress: LaneVector<S, D>,
    /// `sum m_j / rho_ij Pi grad W`.
    viscous_force: LaneVector<S, D>,
    /// `sum V_j (u_j - u_i) (x) grad W`.
    velocity_gradient: [LaneVector<S, D>; D],
    /// `sum V_j (e_j - e_i) grad W`.
    energy_gradient: LaneVector<S, D>,
    /// `sum m_j / rho_ij Pi u_ij . grad W`.
    viscous_heat: Lane<S>,
    /// Over [`CONDUCTION`].
    conduction: Lane<S>,
    /// Over [`DIFFUSION`].
    diffusion: Lane<S>,
    exchange: Exchange<S, D>,
}

/// What shifted neighbours give, one per lane.
#[derive(Clone, Copy)]
struct Exchange<S: Simd, const D: usize> {
    /// `sum x_ij rho_ij`.
    density: Lane<S>,

    /// `sum x_ij (u_j - u_i)`.
    velocity: LaneVector<S, D>,
    /// `sum x_ij [e_j - e_i + (u_j - u_i)^2 / 2]`.
    energy: Lane<S>,
}

impl<S: Simd, const D: usize> Own<S, D> {
    #[inline(always)]
    fn load(simd: S, records: &Records<D>, slot: impl Fn(usize) -> usize) -> Self {
        let state = |l: usize| &records.state[slot(l)];
        Self {
            target: Target::load(simd, |l| &records.near[slot(l)]),
            velocity: std::array::from_fn(|k| {
                Lane::gather(simd, |l| records.near[slot(l)].velocity[k])
            }),
            half_sound: Lane::gather(simd, |l| state(l).half_sound),
            energy: Lane::gather(simd, |l| state(l).energy),
            half_gradient: std::array::from_fn(|k| {
                Lane::gather(simd, |l| state(l).half_gradient[k])
            }),
            strain: std::array::from_fn(|a| {
                std::array::from_fn(|b| Lane::gather(simd, |l| state(l).strain.get(a, b)))
            }),
            energy_slope: std::array::from_fn(|k| Lane::gather(simd, |l| state(l).energy_slope[k])),
        }
    }
}

impl<S: Simd, const D: usize> Sums<S, D> {
    #[inline(always)]
    fn new(simd: S) -> Self {
        Self {
            gradient: zeros(simd),
            stress: zeros(simd),
            viscous_force: zeros(simd),
            velocity_gradient: [zeros(simd); D],
            energy_gradient: zeros(simd),
            viscous_heat: Lane::splat(simd, 0.0),
            conduction: Lane::splat(simd, 0.0),
            diffusion: Lane::splat(simd, 0.0),
            exchange: Exchange {
                density: Lane::splat(simd, 0.0),
                velocity: zeros(simd),
                energy: Lane::splat(simd, 0.0),
            },
        }
    }

    /// Adds what `j` gives `i` where both are shifted. The heat `(u_j - u_i)^2 / 2` is half the kinetic energy
    /// that the pair loses.
    #[inline(always)]
    fn exchange(
        &mut self,
        simd: S,
        i: &Own<S, D>,
        own_shift: &LaneVector<S, D>,
        records: &Records<D>,
        j: usize,
    ) {
        let (near, state) = (&records.near[j], &records.state[j]);
        let pair = Pair::new(simd, &i.target, near);
        let shift: LaneVector<S, D> =
            std::array::from_fn(|k| own_shift[k] - Lane::splat(simd, records.shift[j][k]));
        let pairwise = Lane::splat(simd, near.mass) * pair.inverse_density;
        let rate = exchange_rate(&pair, &shift, pairwise);
        let jump: LaneVector<S, D> =
            std::array::from_fn(|k| Lane::splat(simd, near.velocity[k]) - i.velocity[k]);
        let energy = Lane::splat(simd, state.energy) - i.energy;
        let energy = (Lane::splat(simd, 0.5) * dot(&jump, &jump)) + energy;
        let sums = &mut self.exchange;
        let half_density = Lane::splat(simd, near.half_density);
        sums.density = rate.mul_add(half_density + i.target.half_density, sums.density);
        sums.energy = rate.mul_add(energy, sums.energy);
        for k in 0..D {
            sums.velocity[k] = rate.mul_add(jump[k], sums.velocity[k]);
        }
    }

    /// Adds the terms of `i` with `j`; `GAS` adds conduction and diffusion, which act within
    /// the gas only (`phi_ij` of Villodi & Ramachandran 2024, below eq. 10).
    #[inline(always)]
    fn add<const GAS: bool, const CONSERVATIVE: bool, const SHIFTED: bool>(
        &mut self,
        simd: S,
        sought: Sought,
        i: &Own<S, D>,
        (near, state): (&Near<D>, &State<D>),
    ) {
        let pair = Pair::new(simd, &i.target, near);
        let volume = Lane::splat(simd, near.volume);
        let reach = pair.h * pair.gradient_factor;
        let mass = Lane::splat(simd, near.mass);
        let gradient_volume = volume * pair.gradient_factor;
        let pairwise = mass * pair.inverse_density;
        let jump: LaneVector<S, D> =
            std::array::from_fn(|k| Lane::splat(simd, near.velocity[k]) - i.velocity[k]);
        let approach = -dot(&jump, &pair.separation);
        let sound = i.half_sound + Lane::splat(simd, state.half_sound);
        let closing = if CONSERVATIVE && sought.limits_viscosity {
            let (mut own, mut other) = (Lane::splat(simd, 0.0), Lane::splat(simd, 0.0));
            for b in 0..D {
                let twice = pair.separation[b] + pair.separation[b];
                for a in 0..=b {
                    let factor = if a == b { pair.separation[b] } else { twice };
                    let product = pair.separation[a] * factor;
                    own = i.strain[a][b].mul_add(product, own);
                    other = Lane::splat(simd, state.strain.get(a, b)).mul_add(product, other);
                }
            }
            closing_speed(simd, &pair, approach, own, other)
        } else if CONSERVATIVE {
            whole_closing_speed(simd, &pair, approach)
        } else {
            bare_closing_speed(simd, &pair, approach)
        };
        let viscous = pairwise * viscous_pressure(simd, closing, sound) * pair.gradient_factor;
        let energy = Lane::splat(simd, state.energy) - i.energy;

        self.viscous_heat = viscous.mul_add(approach, self.viscous_heat);
        for a in 0..D {
            let r = pair.separation[a];
            self.gradient[a] = gradient_volume.mul_add(r, self.gradient[a]);
            let row: LaneVector<S, D> =
                std::array::from_fn(|b| Lane::splat(simd, state.stress.get(a, b)));
            let stress = dot(&row, &pair.separation);
            self.stress[a] = stress.mul_add(pair.gradient_factor, self.stress[a]);
            self.viscous_force[a] = viscous.mul_add(r, self.viscous_force[a]);
            if SHIFTED || (CONSERVATIVE && sought.limits_conduction) {
                self.energy_gradient[a] =
                    (gradient_volume * energy).mul_add(r, self.energy_gradient[a]);
            }
            let weight = gradient_volume * jump[a];
            for b in 0..D {
                self.velocity_gradient[a][b] =
                    weight.mul_add(pair.separation[b], self.velocity_gradient[a][b]);
            }
        }
        if GAS {
            if !CONSERVATIVE {
                self.conduction = (sound * energy * reach).mul_add(volume, self.conduction);
                let slopes: LaneVector<S, D> = std::array::from_fn(|k| {
                    i.half_gradient[k] + Lane::splat(simd, state.half_gradient[k])
                });
                let rise = Lane::splat(simd, near.half_density) - i.target.half_density;
                let deviation = dot_add(&slopes, &pair.separation, rise + rise);
                let flow = diffusion(deviation, sound, reach);
                self.diffusion = flow.mul_add(volume, self.diffusion);
                return;
            }
            let uneven = if sought.limits_conduction {
                let slope = |k| Lane::splat(simd, state.energy_slope[k]);
                let theirs: LaneVector<S, D> = std::array::from_fn(slope);
                let own = -dot(&i.energy_slope, &pair.separation);
                let other = -dot(&theirs, &pair.separation);
                uneven_part(simd, energy, own, other)
            } else {
                energy
            };
            let exchanged = sound.mul_add(uneven, shock_speed(simd, closing) * energy);
            self.conduction = (exchanged * reach).mul_add(pairwise, self.conduction);
        }
    }
}

impl<const D: usize, const CONSERVATIVE: bool, const SHIFTED: bool, const EXCHANGES: bool> WithSimd
    for FluidPass<'_, D, CONSERVATIVE, SHIFTED, EXCHANGES>
{
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Self(pass, renormalisations) = self;
        let (chunk, records, sought) = (pass.chunk, pass.records, pass.sought);
        let mut results = pass.rates.iter_mut();
        for cluster in &chunk.clusters {
            if cluster.is_calm {
                let calm = results.by_ref().take(cluster.targets.len());
                calm.for_each(|rates| *rates = Rates::default());
                continue;
            }
            let (start, last) = (cluster.targets.start, cluster.targets.end - 1);
            let own = Own::load(simd, records, |l| (start + l).min(last));
            let own_shift: LaneVector<S, D> = if EXCHANGES {
                let shift = |l: usize| &records.shift[(start + l).min(last)];
                std::array::from_fn(|k| Lane::gather(simd, |l| shift(l)[k]))
            } else {
                zeros(simd)
            };
            let mut sums = Sums::new(simd);
            for &j in &chunk.entries[cluster.gas.clone()] {
                let (near, state) = (&records.near[j as usize], &records.state[j as usize]);
                sums.add::<true, CONSERVATIVE, SHIFTED>(simd, sought, &own, (near, state));
                if EXCHANGES {
                    sums.exchange(simd, &own, &own_shift, records, j as usize);
                }
            }
            let by_gas = Forces::from(&sums);
            for &j in &chunk.entries[cluster.wall.clone()] {
                let (near, state) = (&records.near[j as usize], &records.state[j as usize]);
                sums.add::<false, CONSERVATIVE, SHIFTED>(simd, sought, &own, (near, state));
            }
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

impl<const D: usize, const CONSERVATIVE: bool> WithSimd for ReactionPass<'_, D, CONSERVATIVE> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Pass {
            chunk,
            records,
            sought,
            rates,
        } = self.0;
        let first = records.start[GHOSTS];
        let even = even_renormalisation();
        let mut results = rates.iter_mut();
        for cluster in &chunk.clusters {
            let (start, last) = (
                first + cluster.targets.start,
                first + cluster.targets.end - 1,
            );
            let own = Own::load(simd, records, |l| (start + l).min(last));
            let mut sums = Sums::new(simd);
            for &j in &chunk.entries[cluster.gas.clone()] {
                let (near, state) = (&records.near[j as usize], &records.state[j as usize]);
                sums.add::<false, CONSERVATIVE, false>(simd, sought, &own, (near, state));
            }
            let forces = Forces::from(&sums);
            for (l, rates) in results.by_ref().take(cluster.targets.len()).enumerate() {
                let (near, state) = (&records.near[start + l], &records.state[start + l]);
                rates.acceleration = forces.acceleration(l, near, state.pressure, &even);
            }
        }
    }
}

/// The sums that make up the acceleration, as numbers.
struct Forces<const D: usize> {
    gradient: [[f64; super::super::lanes::MAX_LANES]; D],
    stress: [[f64; super::super::lanes::MAX_LANES]; D],
    viscous: [[f64; super::super::lanes::MAX_LANES]; D],
}

impl<const D: usize> Forces<D> {
    #[inline(always)]
    fn from<S: Simd>(sums: &Sums<S, D>) -> Self {
        Self {
            gradient: sums.gradient.map(Lane::to_array),
            stress: sums.stress.map(Lane::to_array),
            viscous: sums.viscous_force.map(Lane::to_array),
        }
    }

    /// `-1/rho_i sum V_j (p_i L_i + p_j L_j) grad W + sum m_j / rho_ij Pi grad W` of lane `l`.
    #[inline(always)]
    fn acceleration(
        &self,
        l: usize,
        near: &Near<D>,
        pressure: f64,
        renormalisation: &Matrix<D>,
    ) -> Vector<D> {
        self.by_pressure(l, near, pressure, renormalisation) + unlane(&self.viscous, l)
    }

    /// The same without the viscosity.
    #[inline(always)]
    fn by_pressure(
        &self,
        l: usize,
        near: &Near<D>,
        pressure: f64,
        renormalisation: &Matrix<D>,
    ) -> Vector<D> {
        let own = renormalisation * unlane(&self.gradient, l) * pressure;
        -(own + unlane(&self.stress, l)) / near.density()
    }
}
