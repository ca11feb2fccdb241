//! Artificial viscosity.

use pulp::Simd;

use super::super::lanes::Lane;
use super::Pair;

/// Linear and quadratic coefficients (Villodi & Ramachandran 2024, below eq. 13).
pub const ALPHA: f64 = 1.0;
/// See [`ALPHA`].
pub const BETA: f64 = 2.0;

/// Softening of the conservative scheme, in squared smoothing lengths (Monaghan 1992, below
/// eq. 4.2). Without it a particle that drifts towards its own image in a symmetry plane meets a viscous
/// pressure that grows as the inverse square of their distance.
const SOFTENING: f64 = 0.01;

/// What is left of the `approach` `u_ij.r_ij` of a closing pair without the part that varies linearly across
/// it, as the rates of strain `E` at both ends see it: `a_i = r_ij.E_i r_ij` and `a_j` likewise, `own` and
/// `other`, by van Leer's harmonic mean, which is nothing where they differ in sign [Frontiere, Raskin & Owen
/// 2017, section 2.4; van Leer 1974]. Smooth flow is left alone; a shock, whose ends differ, is not.
#[inline(always)]
pub fn unresolved<S: Simd>(simd: S, approach: Lane<S>, own: Lane<S>, other: Lane<S>) -> Lane<S> {
    let zero = Lane::splat(simd, 0.0);
    let (own, other) = (own.min(zero), other.min(zero));
    // Kept off zero, where both vanish and nothing is taken away.
    let both = own + other + Lane::splat(simd, -1e-300);
    let smooth = (own + own) * other * both.recip();
    approach.min(zero) + -smooth
}

/// `mu = h_ij u_ij.r_ij / (r_ij^2 + 0.01 h_ij^2)` of an approaching pair, zero of a parting one [Monaghan 1992, eq.
/// 4.2]: minus the speed at which the pair closes.
#[inline(always)]
pub fn closing_speed<S: Simd, const D: usize>(
    simd: S,
    pair: &Pair<S, D>,
    approach: Lane<S>,
) -> Lane<S> {
    // 1 / (r^2 + s h^2) = 1/r^2 / (1 + s h^2 / r^2).
    let softening = Lane::splat(simd, SOFTENING) * pair.h * pair.h;
    let one = Lane::splat(simd, 1.0);
    bare_closing_speed(simd, pair, approach)
        * softening
            .mul_add(pair.inverse_distance_squared, one)
            .recip()
}

/// The same without softening [Villodi & Ramachandran 2024, eq. 13].
#[inline(always)]
pub fn bare_closing_speed<S: Simd, const D: usize>(
    simd: S,
    pair: &Pair<S, D>,
    approach: Lane<S>,
) -> Lane<S> {
    pair.h * approach.min(Lane::splat(simd, 0.0)) * pair.inverse_distance_squared
}

/// `Pi_ij = alpha c_ij mu - beta mu^2`; never positive, so that it repels [Villodi & Ramachandran 2024,
/// eq. 13; Monaghan 1992]. `sound` is `c_ij`.
#[inline(always)]
pub fn viscous_pressure<S: Simd>(simd: S, closing: Lane<S>, sound: Lane<S>) -> Lane<S> {
    closing * (Lane::splat(simd, ALPHA) * sound - Lane::splat(simd, BETA) * closing)
}
