//! Artificial viscosity.

use pulp::Simd;

use super::super::lanes::Lane;
use super::Pair;

/// Linear and quadratic coefficients (Villodi & Ramachandran 2024, below eq. 13).
pub const ALPHA: f64 = 1.0;
/// See [`ALPHA`].
pub const BETA: f64 = 2.0;

/// `Pi_ij = alpha c_ij mu - beta mu^2` with `mu = h_ij u_ij.r_ij / r_ij^2` of an approaching pair,
/// zero of a parting one; never positive, so that it repels [Villodi & Ramachandran 2024, eq. 13;
/// Monaghan 1992]. `approach` is `u_ij.r_ij`, `half_sound` the halves' sum `c_ij`.
#[inline(always)]
pub fn viscous_pressure<S: Simd, const D: usize>(
    simd: S,
    pair: &Pair<S, D>,
    approach: Lane<S>,
    sound: Lane<S>,
) -> Lane<S> {
    let approaching = approach.min(Lane::splat(simd, 0.0));
    let mu = pair.h * approaching * pair.inverse_distance_squared;
    mu * (Lane::splat(simd, ALPHA) * sound - Lane::splat(simd, BETA) * mu)
}
