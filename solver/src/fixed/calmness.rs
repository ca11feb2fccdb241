//! What a ratio of pressures says of the flux and the slopes at a face, and of a wall.

use super::real::Real;

/// Ratio of pressures across a face below which a shock is strong, and its flux HLL.
const STRONG: f64 = 0.6;

/// Ratio above which there is no shock, and the flux HLLC.
const WEAK: f64 = 0.95;

/// Ratio of pressures below which a shock is so strong that slopes in it are those of minmod: with steeper ones a captured bow shock never
/// comes to rest.
const STRONGEST: f64 = 0.2;

/// Ratio above which slopes are those of central differences.
const NOT_STRONGEST: f64 = 0.4;

/// Ratio of pressures between neighbours below which cells are too coarse for what happens in them.
const COARSE: f64 = 0.9;

/// From zero where waves go by within a cell or two to one where cells resolve them.
#[inline(always)]
pub fn resolution<R: Real>(calmness: R) -> R {
    share(calmness, COARSE, WEAK)
}

/// From zero in strong shocks to one elsewhere: how much of the flux is HLLC's.
#[inline(always)]
pub fn smoothness<R: Real>(calmness: R) -> R {
    share(calmness, STRONG, WEAK)
}

/// From zero in the strongest shocks to one elsewhere: how much of the slopes is that of central differences.
#[inline(always)]
pub fn steepness<R: Real>(calmness: R) -> R {
    share(calmness, STRONGEST, NOT_STRONGEST)
}

/// From zero at `low` to one at `high`.
#[inline(always)]
pub fn share<R: Real>(calmness: R, low: f64, high: f64) -> R {
    let share = (calmness - low) * (1.0 / (high - low));
    share.max(calmness.like(0.0)).min(calmness.like(1.0))
}
