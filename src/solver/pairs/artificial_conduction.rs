//! Artificial conduction of heat.

use pulp::Simd;

use super::super::lanes::Lane;
use super::Pair;

/// Coefficient (Villodi & Ramachandran 2024, below eq. 14).
pub const KAPPA: f64 = 0.1;

/// `kappa c_ij h_ij E_ij.grad_i W_ij` with `E_ij = 2 (e_j - e_i) r_ji / r_ij^2` [Villodi &
/// Ramachandran 2024, eqs 14-15]; the caller weighs it by `m_j / rho_j` (as printed) or by
/// `m_j / rho_ij`, which exchanges energy pairwise and so conserves it.
#[inline(always)]
pub fn heat_flow<S: Simd, const D: usize>(
    simd: S,
    pair: &Pair<S, D>,
    energy_difference: Lane<S>,
    sound: Lane<S>,
) -> Lane<S> {
    // r_ji . grad_i W_ij / r_ij^2 = -F.
    Lane::splat(simd, -2.0 * KAPPA) * sound * pair.h * energy_difference * pair.gradient_factor
}
