//! Diffusion of density, the "delta" of delta-SPH.

use pulp::Simd;

use super::super::lanes::Lane;
use super::Pair;

/// Coefficient (Antuono et al. 2010; Villodi & Ramachandran 2024, below eq. 10).
pub const DELTA: f64 = 0.1;

/// `delta c_ij h_ij D_ij.grad_i W_ij` with `D_ij = 2 r_ji / r_ij^2 [(rho_j - rho_i) -
/// (g_i + g_j).r_ji / 2]`, to be weighed by `m_j / rho_j` [Villodi & Ramachandran 2024, eqs
/// 10-11]. `deviation` is the bracket.
#[inline(always)]
pub fn diffusion<S: Simd, const D: usize>(
    simd: S,
    pair: &Pair<S, D>,
    deviation: Lane<S>,
    sound: Lane<S>,
) -> Lane<S> {
    Lane::splat(simd, -2.0 * DELTA) * sound * pair.h * deviation * pair.gradient_factor
}
