//! Artificial viscosity.

use aero_geometry::Vector;

use super::encounter::{Encounter, Encounters, Own, Site};
use super::law::{Law, Neighbour};
use super::pair::{LaneVector, Pair, accumulate};
use crate::each::each;
use crate::lanes::Lane;
use crate::particles::Rates;
use crate::record::Symmetric;
use crate::records::Read;
use crate::scheme::{Scheme, Viscosity};
use crate::vectors::Vectors;

/// Linear and quadratic coefficients (Villodi & Ramachandran 2024, below eq. 13).
pub const ALPHA: f64 = 1.0;
/// See [`ALPHA`].
pub const BETA: f64 = 2.0;

/// Linear coefficient of pairs that part, twice that of pairs that close: enough to take most of its ringing from a fan that springs from a
/// corner.
pub const PARTING: f64 = 2.0;

/// Softening of the conservative scheme, in squared smoothing lengths (Monaghan 1992, below
/// eq. 4.2). Without it a particle that drifts towards its own image in a symmetry plane meets a viscous
/// pressure that grows as the inverse square of their distance.
const SOFTENING: f64 = 0.01;

/// `mu = h_ij a / (r_ij^2 + 0.01 h_ij^2)`: minus the speed at which the pair closes, zero of a parting one [Monaghan 1992, eq. 4.2],
/// and that at which it parts in gas that expands, zero of any other.
///
/// Of the `approach` `u_ij.r_ij` only that part `a` counts that does not vary linearly across the pair. The linear part is
/// what the rates of strain `E` at both ends see of it, `own = r_ij.E_i r_ij` and `other = r_ij.E_j r_ij`. Of a closing pair it is van Leer's harmonic
/// mean, which is nothing where they differ in sign [Frontiere, Raskin & Owen 2017, section 2.4; van Leer 1974], of a parting one the larger of both, and of what
/// is left no more counts than gas parts by that expands as both ends do, `expansion r_ij^2` with `expansion = tr E_i + tr E_j`: next to nothing in smooth
/// flow, nothing in shocks, in shear and in vortices.
#[inline(always)]
fn speeds<V: Vectors, const D: usize>(
    vectors: V,
    pair: &Pair<V, D>,
    approach: Lane<V>,
    [own, other]: [Lane<V>; 2],
    expansion: Lane<V>,
) -> [Lane<V>; 2] {
    let zero = Lane::splat(vectors, 0.0);
    let parting = (approach - own.max(other).max(zero))
        .min(expansion * pair.squared)
        .max(zero);
    let (own, other) = (own.min(zero), other.min(zero));
    // Kept off zero, where both vanish and nothing is taken away.
    let both = own + other + Lane::splat(vectors, -V::LEAST);
    // a both = approach both - 2 own other.
    let closing = approach
        .min(zero)
        .mul_add(both, -((own + own) * other))
        .max(zero);
    let factor = pair.h * (both * softened(vectors, pair)).recip();
    [closing * factor, parting * both * factor]
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

/// `Pi_ij = alpha c_ij mu - beta mu^2` of a closing pair, which repels [Villodi & Ramachandran 2024, eq. 13; Monaghan
/// 1992], and `2 c_ij mu` of a parting one, which holds: without it a fan that springs from a corner rings, as nothing else there
/// dissipates. `sound` is `c_ij`, `held` twice the `mu` of what parts.
#[inline(always)]
fn viscous_pressure<V: Vectors>(
    vectors: V,
    closing: Lane<V>,
    held: Lane<V>,
    sound: Lane<V>,
) -> Lane<V> {
    let linear = Lane::splat(vectors, ALPHA).mul_add(closing, held);
    sound.mul_add(linear, Lane::splat(vectors, -BETA) * closing * closing)
}

/// What the viscosity knows of the particles `i`, one per lane.
#[derive(Clone, Copy)]
pub struct Strained<V: Vectors, const D: usize> {
    /// `E_i`.
    strain: [LaneVector<V, D>; D],
    /// `tr E_i`.
    expansion: Lane<V>,
}

impl<V: Vectors, const D: usize> Strained<V, D> {
    /// `r_ij.E_i r_ij`, `r_ij.E_j r_ij`, and `tr E_i + tr E_j`.
    #[inline(always)]
    fn seen(
        &self,
        vectors: V,
        pair: &Pair<V, D>,
        others: &Symmetric<D, V::Number>,
    ) -> ([Lane<V>; 2], Lane<V>) {
        let (mut own, mut other) = (Lane::splat(vectors, 0.0), Lane::splat(vectors, 0.0));
        let mut expansion = self.expansion;
        for b in 0..D {
            let twice = pair.separation[b] + pair.separation[b];
            for a in 0..=b {
                let factor = if a == b { pair.separation[b] } else { twice };
                let product = pair.separation[a] * factor;
                let strain = Lane::broadcast(vectors, others.get(a, b));
                own = self.strain[a][b].mul_add(product, own);
                other = strain.mul_add(product, other);
                if a == b {
                    expansion += strain;
                }
            }
        }
        ([own, other], expansion)
    }
}

/// Acceleration `sum_j m_j / rho_ij Pi_ij grad_i W_ij` and half the heat of its work [Villodi & Ramachandran 2024, eqs 12-14].
/// Leaves word of the closing speed.
#[derive(Clone, Copy, Debug)]
pub struct ArtificialViscosity {
    /// What of the approach it acts on.
    viscosity: Viscosity,
    /// Linear coefficient of parting pairs.
    parting: f64,
}

impl ArtificialViscosity {
    /// That of a scheme. Steps too long for [`PARTING`] get less of it: at Courant numbers above one half its inverse, as gas that a
    /// step pulls together by more than it parted swings.
    pub fn of(scheme: &Scheme) -> Self {
        Self {
            viscosity: scheme.viscosity,
            parting: PARTING.min(1.0 / scheme.step.cfl),
        }
    }
}

impl<const D: usize> Law<Encounters<'_, D>, D> for ArtificialViscosity {
    type Own<V: Vectors> = Strained<V, D>;
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
        let strain = each(|a| each(|b| Lane::gather(vectors, |l| strain(l).get(a, b))));
        let mut expansion = Lane::splat(vectors, 0.0);
        for (a, row) in strain.iter().enumerate() {
            expansion += row[a];
        }
        Strained { strain, expansion }
    }

    #[inline(always)]
    fn add<V: Vectors>(
        &self,
        (_, own): (&Own<V, D>, &Self::Own<V>),
        met: &mut Encounter<V, D>,
        j: Neighbour<'_, V, D>,
        (force, heat): &mut Self::Sums<V>,
    ) {
        let (vectors, pair) = (j.vectors, &met.pair);
        let none = Lane::splat(vectors, 0.0);
        let [closing, parting] = match self.viscosity {
            Viscosity::None => return,
            Viscosity::Limited => {
                let (ends, expansion) = own.seen(vectors, pair, &j.read.state[j.slot].strain);
                speeds(vectors, pair, met.approach, ends, expansion)
            }
            Viscosity::Softened => [whole_closing_speed(vectors, pair, met.approach), none],
            Viscosity::Bare => [bare_closing_speed(vectors, pair, met.approach), none],
        };
        met.closing = closing;
        let held = Lane::splat(vectors, self.parting) * parting;
        let pressure = viscous_pressure(vectors, closing, held, met.sound);
        let viscous = met.pairwise * pressure * pair.gradient_factor;
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
