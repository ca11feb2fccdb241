//! How steep the gas may be between two cells: limiters of the slope from one cell's middle to the next.
//!
//! All are functions `phi(a, b)` of two differences, the one beyond a cell and the one across a face: `b` where both are equal,
//! zero where they have opposite signs.

use super::real::Real;

/// Of van Leer, the harmonic mean `2 a b / (a + b)` [van Leer 1974, J. Comput. Phys. 14, 361-370].
#[inline(always)]
pub fn van_leer<R: Real>(a: R, b: R) -> R {
    let product = a * b;
    product.select(product * 2.0 / (a + b), a.like(0.0))
}

/// The smaller of both [Roe 1986, Annu. Rev. Fluid Mech. 18, 337-365].
#[inline(always)]
pub fn minmod<R: Real>(a: R, b: R) -> R {
    let smaller = a.select(a.min(b), a.max(b));
    (a * b).select(smaller, a.like(0.0))
}

/// The mean of both, at most twice the smaller [van Leer 1977, J. Comput. Phys. 23, 276-299].
#[inline(always)]
pub fn monotonized_central<R: Real>(a: R, b: R) -> R {
    let mean = (a + b) * 0.5;
    minmod(minmod(a, b) * 2.0, mean)
}
