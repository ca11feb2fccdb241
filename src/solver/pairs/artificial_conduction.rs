//! Artificial conduction of heat, and the heat flux that keeps walls from overheating.

use pulp::Simd;

use super::super::lanes::Lane;

/// Coefficient (Villodi & Ramachandran 2024, below eq. 14).
pub const KAPPA: f64 = 0.1;

/// Coefficient of the flux in compressed gas: `g_2 = 1` of `g_2 h^2 (|div u| - div u)`, whose bracket is twice
/// the rate of compression (Fulk 1994; Monaghan 1995; Liu & Liu 2003, eq. 4.74).
const COMPRESSED: f64 = 2.0;

/// Speed at which a pair exchanges heat, over [`KAPPA`]: that of sound and, in the conservative scheme, what
/// Noh [1987] adds in a shock. Where gas first meets a wall the artificial viscosity heats it too much,
/// and its density is then too low for good; as long as it is compressed, its neighbours share that heat. `closing` is the
/// viscosity's `mu`, `sound` is `c_ij`.
#[inline(always)]
pub fn exchange_speed<S: Simd>(simd: S, closing: Lane<S>, sound: Lane<S>) -> Lane<S> {
    closing.mul_add(Lane::splat(simd, -COMPRESSED / KAPPA), sound)
}

/// What the sum of all [`heat_flow`] is to be multiplied with: `r_ji.grad_i W_ij / r_ij^2` is `-F`.
pub const CONDUCTION: f64 = -2.0 * KAPPA;

/// `kappa c_ij h_ij E_ij.grad_i W_ij` over [`CONDUCTION`], with `E_ij = 2 (e_j - e_i) r_ji / r_ij^2` [Villodi &
/// Ramachandran 2024, eqs 14-15]; the caller weighs it by `m_j / rho_j` (as printed) or by
/// `m_j / rho_ij`, which exchanges energy pairwise and so conserves it. `reach` is `h_ij F`.
#[inline(always)]
pub fn heat_flow<S: Simd>(energy_difference: Lane<S>, speed: Lane<S>, reach: Lane<S>) -> Lane<S> {
    speed * reach * energy_difference
}
