//! Artificial viscosity.

use aero_geometry::Vector;

use super::encounter::{Encounter, Encounters, Own, Site};
use super::law::{Law, Neighbour};
use super::pair::{LaneVector, Pair, accumulate};
use crate::each::each;
use crate::lanes::Lane;
use crate::particles::Rates;
use crate::records::Read;
use crate::scheme::Viscosity;
use crate::vectors::Vectors;

/// Linear and quadratic coefficients (Villodi & Ramachandran 2024, below eq. 13).
pub const ALPHA: f64 = 1.0;
/// See [`ALPHA`].
pub const BETA: f64 = 2.0;

/// Softening of the conservative scheme, in squared smoothing lengths (Monaghan 1992, below
/// eq. 4.2). Without it a particle that drifts towards its own image in a symmetry plane meets a viscous
/// pressure that grows as the inverse square of their distance.
const SOFTENING: f64 = 0.01;

/// `mu = h_ij a / (r_ij^2 + 0.01 h_ij^2)` of an approaching pair, zero of a parting one [Monaghan 1992, eq. 4.2]: minus
/// the speed at which the pair closes.
///
/// Of the `approach` `u_ij.r_ij` only that part `a` counts that does not vary linearly across the pair. The linear part is
/// what the rates of strain `E` at both ends see of it, `own = r_ij.E_i r_ij` and `other = r_ij.E_j r_ij`, by van Leer's harmonic
/// mean, which is nothing where they differ in sign [Frontiere, Raskin & Owen 2017, section 2.4; van Leer 1974].
#[inline(always)]
fn closing_speed<V: Vectors, const D: usize>(
    vectors: V,
    pair: &Pair<V, D>,
    approach: Lane<V>,
    own: Lane<V>,
    other: Lane<V>,
) -> Lane<V> {
    let zero = Lane::splat(vectors, 0.0);
    let (own, other) = (own.min(zero), other.min(zero));
    // Kept off zero, where both vanish and nothing is taken away.
    let both = own + other + Lane::splat(vectors, -V::LEAST);
    // a both = approach both - 2 own other.
    let left = approach
        .min(zero)
        .mul_add(both, -((own + own) * other))
        .max(zero);
    pair.h * left * (both * softened(vectors, pair)).recip()
}

/// The same of the whole approach [Monaghan 1992, eq. 4.2].
#[inline(always)]
fn whole_closing_speed<V: Vectors, const D: usize>(
    vectors: V,
    pair: &Pair<V, D>,
    approach: Lane<V>,
) -> Lane<V> {
    pair.h * approach.min(Lane::splat(vectors, 0.0)) * softened(vectors, pair).recip()
}

/// `r_ij^2 + 0.01 h_ij^2`.
#[inline(always)]
fn softened<V: Vectors, const D: usize>(vectors: V, pair: &Pair<V, D>) -> Lane<V> {
    (Lane::splat(vectors, SOFTENING) * pair.h).mul_add(pair.h, pair.squared)
}

/// The same without softening [Villodi & Ramachandran 2024, eq. 13].
#[inline(always)]
fn bare_closing_speed<V: Vectors, const D: usize>(
    vectors: V,
    pair: &Pair<V, D>,
    approach: Lane<V>,
) -> Lane<V> {
    let inverse_squared = pair.inverse_distance * pair.inverse_distance;
    pair.h * approach.min(Lane::splat(vectors, 0.0)) * inverse_squared
}

/// `Pi_ij = alpha c_ij mu - beta mu^2`; never positive, so that it repels [Villodi & Ramachandran 2024,
/// eq. 13; Monaghan 1992]. `sound` is `c_ij`.
#[inline(always)]
fn viscous_pressure<V: Vectors>(vectors: V, closing: Lane<V>, sound: Lane<V>) -> Lane<V> {
    closing * (Lane::splat(vectors, ALPHA) * sound - Lane::splat(vectors, BETA) * closing)
}

/// Acceleration `sum_j m_j / rho_ij Pi_ij grad_i W_ij` and half the heat of its work [Villodi & Ramachandran 2024, eqs 12-14].
/// Leaves word of the closing speed.
#[derive(Clone, Copy, Debug)]
pub struct ArtificialViscosity(pub Viscosity);

impl<const D: usize> Law<Encounters<'_, D>, D> for ArtificialViscosity {
    type Own<V: Vectors> = [LaneVector<V, D>; D];
    type Sums<V: Vectors> = (LaneVector<V, D>, Lane<V>);
    type Number = ([f64; D], f64);

    #[inline(always)]
    fn load<V: Vectors>(
        &self,
        vectors: V,
        read: Read<'_, D, V::Number>,
        slot: impl Fn(usize) -> usize + Copy,
    ) -> Self::Own<V> {
        let strain = |l: usize| &read.state[slot(l)].strain;
        each(|a| each(|b| Lane::gather(vectors, |l| strain(l).get(a, b))))
    }

    #[inline(always)]
    fn add<V: Vectors>(
        &self,
        (_, own_strain): (&Own<V, D>, &Self::Own<V>),
        met: &mut Encounter<V, D>,
        j: Neighbour<'_, V, D>,
        (force, heat): &mut Self::Sums<V>,
    ) {
        let (vectors, pair) = (j.vectors, &met.pair);
        met.closing = match self.0 {
            Viscosity::None => return,
            Viscosity::Limited => {
                let strain = &j.read.state[j.slot].strain;
                let (mut own, mut other) = (Lane::splat(vectors, 0.0), Lane::splat(vectors, 0.0));
                for b in 0..D {
                    let twice = pair.separation[b] + pair.separation[b];
                    for a in 0..=b {
                        let factor = if a == b { pair.separation[b] } else { twice };
                        let product = pair.separation[a] * factor;
                        own = own_strain[a][b].mul_add(product, own);
                        other = Lane::broadcast(vectors, strain.get(a, b)).mul_add(product, other);
                    }
                }
                closing_speed(vectors, pair, met.approach, own, other)
            }
            Viscosity::Softened => whole_closing_speed(vectors, pair, met.approach),
            Viscosity::Bare => bare_closing_speed(vectors, pair, met.approach),
        };
        let viscous =
            met.pairwise * viscous_pressure(vectors, met.closing, met.sound) * pair.gradient_factor;
        *heat = viscous.mul_add(met.approach, *heat);
        accumulate(force, viscous, &pair.separation);
    }

    #[inline(always)]
    fn finish(
        &self,
        (by_gas, _): Self::Number,
        (force, heat): Self::Number,
        site: &mut Site<'_, D>,
        rates: &mut Rates<D>,
    ) {
        rates.acceleration += Vector::from(by_gas);
        site.acceleration += Vector::from(force);
        rates.energy -= 0.5 * heat;
    }
}
