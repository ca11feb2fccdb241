//! What shifted particles exchange, so that the flow stays where it was.

use super::super::lanes::Lane;
use super::super::vectors::Vectors;
use super::{LaneVector, Pair, dot};

/// Rate at which `j` gives its state to `i` where both are shifted, over the mass of `i`:
/// `x_ij = (m_j / rho_ij) (s_i - s_j).grad_i W_ij`, with `shift` the difference `s_i - s_j` of the renormalised shifts and
/// `pairwise = m_j / rho_ij`.
///
/// `m_i x_ij` is the same from both ends. Velocity and energy that are exchanged in proportion to it,
/// `m_i du_i/dt = sum_j m_i x_ij (u_j - u_i)`, are therefore conserved pair by pair, with masses that stay as they are; the
/// frame of reference does not count, and uniform flow is left alone. In the limit of many neighbours the sum is
/// `(s - <s>).grad u`, `<s>` being the mean shift of the neighbourhood: what varies from particle to particle is
/// taken back, as the advection terms of Oger et al. [2016] and Sun et al. [2019] do, while the mean moves
/// mass, momentum and energy alike.
#[inline(always)]
pub fn exchange_rate<V: Vectors, const D: usize>(
    pair: &Pair<V, D>,
    shift: &LaneVector<V, D>,
    pairwise: Lane<V>,
) -> Lane<V> {
    pairwise * pair.gradient_factor * dot(shift, &pair.separation)
}
