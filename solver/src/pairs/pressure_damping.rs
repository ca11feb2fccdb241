//! Damping of pressure by entropy: what makes an equation of its own of the pressure.

use super::encounter::{Encounter, Encounters, Own, Site};
use super::law::{Law, Neighbour};
use super::pair::{LaneVector, accumulate};
use crate::each::each;
use crate::lanes::Lane;
use crate::particles::Rates;
use crate::records::Read;
use crate::scheme::Damping;
use crate::vectors::Vectors;

/// `alpha / 8` in the diffusivity `nu = alpha h c / 8` of pressure, with `alpha = 1/2` [Ramachandran & Puri 2019; Negi & Ramachandran 2021,
/// below eq. 12].
pub const DAMPING: f64 = 0.5 / 8.0;

/// `nu lap p` in `dp/dt = -rho c^2 div u + nu lap p` [Clausen 2013; Negi & Ramachandran 2021, eq. 12], as a rate of the density that the
/// pressure stands for: `d rho = dp / c^2`. Within the gas only.
///
/// [`Damping::Coupled`]: `nu sum_j V_j (grad rho_j - grad rho_i).L_i grad_i W_ij` [eq. 13]; [`Damping::Pairwise`]: `nu sum_j (V_i^2 + V_j^2) / V_i
/// (rho_i - rho_j) F_ij` [Negi, Ramachandran & Haftu 2020, eq. 9].
#[derive(Clone, Copy, Debug)]
pub struct PressureDamping(pub Damping);

/// Of the particles `i`: half their density gradients, and their volumes.
#[derive(Clone, Copy)]
pub struct Damped<V: Vectors, const D: usize> {
    half_gradient: LaneVector<V, D>,
    volume: Lane<V>,
}

impl<const D: usize> Law<Encounters<'_, D>, D> for PressureDamping {
    type Own<V: Vectors> = Damped<V, D>;
    /// Halves of both sums.
    type Sums<V: Vectors> = ([LaneVector<V, D>; D], Lane<V>);
    type Number = ([[f64; D]; D], f64);

    #[inline(always)]
    fn load<V: Vectors>(
        &self,
        vectors: V,
        read: Read<'_, D, V::Number>,
        slot: impl Fn(usize) -> usize + Copy,
    ) -> Self::Own<V> {
        Damped {
            half_gradient: each(|k| {
                Lane::gather(vectors, |l| read.state[slot(l)].half_gradient[k])
            }),
            volume: Lane::gather(vectors, |l| read.near[slot(l)].volume),
        }
    }

    #[inline(always)]
    fn add<V: Vectors>(
        &self,
        (own, damped): (&Own<V, D>, &Self::Own<V>),
        met: &mut Encounter<V, D>,
        j: Neighbour<'_, V, D>,
        (coupled, pairwise): &mut Self::Sums<V>,
    ) {
        match self.0 {
            Damping::Coupled => {
                let state = &j.read.state[j.slot];
                let weight = met.sound * met.reach * met.volume;
                for a in 0..D {
                    let theirs = Lane::broadcast(j.vectors, state.half_gradient[a]);
                    let rise = theirs - damped.half_gradient[a];
                    accumulate(&mut coupled[a], weight * rise, &met.pair.separation);
                }
            }
            Damping::Pairwise => {
                let theirs = Lane::broadcast(j.vectors, j.read.near[j.slot].half_density);
                let fall = own.target.half_density - theirs;
                let volumes = met
                    .volume
                    .mul_add(met.volume / damped.volume, damped.volume);
                *pairwise = (met.sound * met.reach * fall).mul_add(volumes, *pairwise);
            }
            Damping::None | Damping::Delta => {}
        }
    }

    #[inline(always)]
    fn add_ghost<V: Vectors>(
        &self,
        _: (&Own<V, D>, &Self::Own<V>),
        _: &mut Encounter<V, D>,
        _: Neighbour<'_, V, D>,
        _: &mut Self::Sums<V>,
    ) {
    }

    #[inline(always)]
    fn finish(
        &self,
        _: Self::Number,
        (coupled, pairwise): Self::Number,
        site: &mut Site<'_, D>,
        rates: &mut Rates<D>,
    ) {
        let matrix = &site.renormalisation.matrix;
        let mut sum = pairwise;
        for (a, row) in coupled.iter().enumerate() {
            for (b, value) in row.iter().enumerate() {
                sum += value * matrix[(a, b)];
            }
        }
        rates.density += 2.0 * DAMPING * sum;
    }
}
