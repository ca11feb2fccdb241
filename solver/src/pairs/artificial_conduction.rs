//! Artificial conduction of heat, and the heat flux that keeps walls from overheating.

use super::super::lanes::Lane;
use super::super::vectors::Vectors;

/// Coefficient (Villodi & Ramachandran 2024, below eq. 14).
pub const KAPPA: f64 = 0.1;

/// Coefficient of the flux in compressed gas: `g_2 = 1` of `g_2 h^2 (|div u| - div u)`, whose bracket is twice
/// the rate of compression (Fulk 1994; Monaghan 1995; Liu & Liu 2003, eq. 4.74).
const COMPRESSED: f64 = 2.0;

/// What the sum of all exchanges is to be multiplied with: `r_ji.grad_i W_ij / r_ij^2` is `-F`.
///
/// An exchange is `kappa c_ij h_ij E_ij.grad_i W_ij` over this, with `E_ij = 2 (e_j - e_i) r_ji / r_ij^2` [Villodi &
/// Ramachandran 2024, eqs 14-15], weighed by `m_j / rho_j` (as printed) or by `m_j / rho_ij`, which exchanges energy
/// pairwise and so conserves it.
pub const CONDUCTION: f64 = -2.0 * KAPPA;

/// What Noh [1987] adds to the speed of sound in a shock, over [`KAPPA`]. Where gas first meets a wall the artificial
/// viscosity heats it too much, and its density is then too low for good; as long as it is compressed, its neighbours
/// share that heat. `closing` is the viscosity's `mu`.
#[inline(always)]
pub fn shock_speed<V: Vectors>(vectors: V, closing: Lane<V>) -> Lane<V> {
    closing * Lane::splat(vectors, -COMPRESSED / KAPPA)
}

/// That part of the `difference` `e_j - e_i` that does not vary linearly across the pair: what is left of it by the least
/// of itself and of what the slopes at both ends see, `own = g_i.r_ji` and `other = g_j.r_ji` (Roe's minmod [1986]); all
/// of it where they differ in sign. As for the viscosity [Frontiere, Raskin & Owen 2017, section 2.4; for conduction
/// Rosswog 2020, section 2.3], contacts are then not smeared further than the scheme needs. Van Leer's mean is a tenth better at
/// contacts, costs 4 % more time and lets walls overheat.
#[inline(always)]
pub fn uneven_part<V: Vectors>(
    vectors: V,
    difference: Lane<V>,
    own: Lane<V>,
    other: Lane<V>,
) -> Lane<V> {
    let zero = Lane::splat(vectors, 0.0);
    let rise = own.min(other).min(difference).max(zero);
    let fall = own.max(other).max(difference).min(zero);
    difference - (rise + fall)
}
