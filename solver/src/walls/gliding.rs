//! Walls that gas slides along: how fast gas comes to them or leaves.
//!
//! A sum over the gas in reach of a ghost reads it at the gas's centroid, nearer to the wall than the mirror point of a deep ghost and farther off than that of a shallow one. What
//! goes across the wall vanishes there and grows with the distance: mirrored as it was read, it takes gas beside a bent wall for one that hardly expands.

use super::Ghost;
use super::sticking::above;
use crate::fixed::limiter::minmod;
use crate::pairs::extrapolation::Interpolated;

/// Velocity across the wall at the mirror point of a ghost, relative to the wall and into the gas, where `across` was read at a distance of `arm` from the ghost: on a straight line with
/// the slope of the gas, `n.E n`, or that of the line from the wall, whichever is less. Nothing is added where they differ in sign, nor in shocks, where the rate of strain that is known vanishes.
pub fn across<const D: usize>(
    ghost: &Ghost<D>,
    gas: &Interpolated<D>,
    across: f64,
    arm: f64,
) -> f64 {
    let of_gas = ghost.normal.dot(&(gas.strain * ghost.normal));
    let of_line = across / above(ghost, arm - ghost.depth);
    across + (2.0 * ghost.depth - arm) * minmod(of_gas, of_line)
}
