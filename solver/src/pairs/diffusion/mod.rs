//! Diffusion of momentum and heat by the gas's own viscosity and conductivity: a second pass over the pairs, which only viscous gas asks
//! for, over the gradients that the first one found.
//!
//! A flux `f`, stress or heat, is summed as pressure is, `sum_j (V_j f_i L_i + V_i f_j L_j) grad_i W_ij`, which conserves what it
//! carries. That sum of a sum is blind to the shortest wave; what neighbours differ by beyond their gradients is exchanged as well,
//! by the Laplacian of pairs [Morris, Fox & Zhu 1997, eq. 22; Cleary & Monaghan 1999], and vanishes where the flow is smooth.

mod coupled_stress;
mod heat_flux;
mod viscous_stress;
mod volume_gradient;

use aero_geometry::Vector;

pub use coupled_stress::CoupledStress;
pub use heat_flux::HeatFlux;
pub use viscous_stress::ViscousStress;
pub use volume_gradient::VolumeGradient;

use super::law::Basis;
use super::pair::{LaneVector, Pair, Target};
use super::renormalisation::Renormalisation;
use crate::backend::Backend;
use crate::each::each;
use crate::lanes::Lane;
use crate::neighbours::Lists;
use crate::particles::Rates;
use crate::records::{Diffusive, GHOSTS, Matrix, Near, Read, Records};
use crate::vectors::Vectors;

/// What the pass sums.
const LAWS: (VolumeGradient, (ViscousStress, HeatFlux)) =
    (VolumeGradient, (ViscousStress, HeatFlux));

/// Adds to the rates of every listed particle of the fluid what its viscosity and conductivity do; always in `f64`.
pub fn diffuse<const D: usize>(
    backend: &impl Backend,
    lists: &Lists,
    records: &Records<D>,
    rates: &mut [Rates<D>],
) {
    let met = Neighbours {
        records,
        first: 0,
        friction_heats: true,
    };
    backend.sweep_in_double(lists, records, &met, &LAWS, rates);
}

/// Adds what viscosity alone does, by differences of stresses, to the fluid with these `renormalisations`.
pub fn diffuse_by_differences<const D: usize>(
    backend: &impl Backend,
    lists: &Lists,
    records: &Records<D>,
    renormalisations: &[Renormalisation<D>],
    rates: &mut [Rates<D>],
) {
    let met = Neighbours {
        records,
        first: 0,
        friction_heats: false,
    };
    let law = CoupledStress(renormalisations);
    backend.sweep_in_double(lists, records, &met, &law, rates);
}

/// What the gas would do to ghosts of mass `rho V`: accelerate them by its friction, and heat them through the wall. Ghosts have no heat of
/// friction: no work is done inside of a wall.
pub fn diffuse_into_ghosts<const D: usize>(
    backend: &impl Backend,
    lists: &Lists,
    records: &Records<D>,
    rates: &mut [Rates<D>],
) {
    let met = Neighbours {
        records,
        first: records.start[GHOSTS],
        friction_heats: false,
    };
    backend.sweep_in_double(lists, records, &met, &LAWS, rates);
}

/// What a pass reads.
pub struct Neighbours<'a, const D: usize> {
    records: &'a Records<D>,
    first: usize,
    friction_heats: bool,
}

/// The particles `i`, one per lane.
#[derive(Clone, Copy)]
pub struct Own<V: Vectors, const D: usize> {
    target: Target<V, D>,
    velocity: LaneVector<V, D>,
    energy: Lane<V>,
}

/// A pair.
#[derive(Clone, Copy)]
pub struct Met<V: Vectors, const D: usize> {
    /// Its geometry.
    pub pair: Pair<V, D>,
    /// `V_j F`.
    pub gradient_volume: Lane<V>,
    /// `u_i - u_j`.
    pub jump: LaneVector<V, D>,
    /// `e_i - e_j`.
    pub energy: Lane<V>,
}

/// A particle whose sums are complete.
pub struct Site<'a, const D: usize> {
    /// Its density and volume.
    pub near: &'a Near<D>,
    /// Its fluxes.
    pub own: &'a Diffusive<D>,
    /// Gradient of its velocity.
    pub velocity_gradient: Matrix<D>,
    /// `sum V_j grad W` over the gas, and over all: left by the volume gradient.
    pub volume_gradients: [Vector<D>; 2],
    /// Acceleration by the gas, and by all.
    pub accelerations: [Vector<D>; 2],
    /// Rate of specific internal energy by friction.
    pub friction: f64,
    /// And by conduction.
    pub conduction: f64,
}

impl<const D: usize> Basis<D> for Neighbours<'_, D> {
    type Own<V: Vectors> = Own<V, D>;
    type Pair<V: Vectors> = Met<V, D>;
    type Site<'a>
        = Site<'a, D>
    where
        Self: 'a;
    type Result = Rates<D>;

    fn first(&self) -> usize {
        self.first
    }

    #[inline(always)]
    fn load<V: Vectors>(
        &self,
        vectors: V,
        read: Read<'_, D, V::Number>,
        slot: impl Fn(usize) -> usize,
    ) -> Own<V, D> {
        let velocity = |l: usize, k: usize| read.near[slot(l)].velocity[k];
        Own {
            target: Target::load(vectors, read, &slot),
            velocity: each(|k| Lane::gather(vectors, |l| velocity(l, k))),
            energy: Lane::gather(vectors, |l| read.state[slot(l)].energy),
        }
    }

    #[inline(always)]
    fn meet<V: Vectors>(
        &self,
        vectors: V,
        i: &Own<V, D>,
        read: Read<'_, D, V::Number>,
        j: usize,
    ) -> Met<V, D> {
        let near = &read.near[j];
        let pair = Pair::new(vectors, &i.target, near);
        Met {
            gradient_volume: Lane::broadcast(vectors, near.volume) * pair.gradient_factor,
            jump: each(|k| i.velocity[k] - Lane::broadcast(vectors, near.velocity[k])),
            energy: i.energy - Lane::broadcast(vectors, read.state[j].energy),
            pair,
        }
    }

    /// Nothing flows through what is undisturbed.
    fn rest(&self, _: usize, _: &mut Rates<D>) {}

    #[inline(always)]
    fn open(&self, slot: usize, rates: &mut Rates<D>) -> Site<'_, D> {
        Site {
            near: &self.records.near[slot],
            own: &self.records.diffusive[slot],
            velocity_gradient: rates.velocity_gradient,
            volume_gradients: [Vector::zeros(); 2],
            accelerations: [Vector::zeros(); 2],
            friction: 0.0,
            conduction: 0.0,
        }
    }

    #[inline(always)]
    fn close(&self, site: Site<'_, D>, rates: &mut Rates<D>) {
        let [gas, all] = site.accelerations;
        rates.acceleration += gas;
        rates.wall_acceleration += all - gas;
        rates.energy += site.conduction;
        if self.friction_heats {
            rates.energy += site.friction;
        }
    }
}
