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

/// `Pi_ij = alpha c_ij mu - beta mu^2` with `mu = h_ij u_ij.r_ij / r_ij^2` of an approaching pair,
/// zero of a parting one; never positive, so that it repels [Villodi & Ramachandran 2024, eq. 13;
/// Monaghan 1992]. `SOFT` adds `0.01 h_ij^2` to `r_ij^2`. `approach` is `u_ij.r_ij`, `sound` is `c_ij`.
#[inline(always)]
pub fn viscous_pressure<S: Simd, const D: usize, const SOFT: bool>(
    simd: S,
    pair: &Pair<S, D>,
    approach: Lane<S>,
    sound: Lane<S>,
) -> Lane<S> {
    let approaching = approach.min(Lane::splat(simd, 0.0));
    let mut mu = pair.h * approaching * pair.inverse_distance_squared;
    if SOFT {
        // 1 / (r^2 + s h^2) = 1/r^2 / (1 + s h^2 / r^2).
        let softening = Lane::splat(simd, SOFTENING) * pair.h * pair.h;
        let one = Lane::splat(simd, 1.0);
        mu = mu
            * softening
                .mul_add(pair.inverse_distance_squared, one)
                .recip();
    }
    mu * (Lane::splat(simd, ALPHA) * sound - Lane::splat(simd, BETA) * mu)
}
