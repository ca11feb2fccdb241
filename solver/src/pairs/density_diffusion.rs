//! Diffusion of density, the "delta" of delta-SPH.

use super::super::lanes::Lane;
use super::super::vectors::Vectors;

/// Coefficient (Antuono et al. 2010; Villodi & Ramachandran 2024, below eq. 10).
pub const DELTA: f64 = 0.1;

/// What the sum of all [`diffusion`] is to be multiplied with: `r_ji.grad_i W_ij / r_ij^2` is `-F`.
pub const DIFFUSION: f64 = -2.0 * DELTA;

/// `delta c_ij h_ij D_ij.grad_i W_ij` over [`DIFFUSION`], with `D_ij = 2 r_ji / r_ij^2 [(rho_j - rho_i) -
/// (g_i + g_j).r_ji / 2]`, to be weighed by `m_j / rho_j` [Villodi & Ramachandran 2024, eqs
/// 10-11]. `deviation` is the bracket, `reach` is `h_ij F`.
#[inline(always)]
pub fn diffusion<V: Vectors>(deviation: Lane<V>, sound: Lane<V>, reach: Lane<V>) -> Lane<V> {
    sound * reach * deviation
}
