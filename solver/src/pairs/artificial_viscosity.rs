//! Artificial viscosity.

use super::super::lanes::Lane;
use super::super::vectors::Vectors;
use super::Pair;

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
pub fn closing_speed<V: Vectors, const D: usize>(
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
pub fn whole_closing_speed<V: Vectors, const D: usize>(
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
pub fn bare_closing_speed<V: Vectors, const D: usize>(
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
pub fn viscous_pressure<V: Vectors>(vectors: V, closing: Lane<V>, sound: Lane<V>) -> Lane<V> {
    closing * (Lane::splat(vectors, ALPHA) * sound - Lane::splat(vectors, BETA) * closing)
}
