//! The quintic spline and what a lattice makes of it, written down once more.

use std::f64::consts::PI;

use aero_geometry::Vector;

/// Smoothing lengths per spacing.
pub const RATIO: f64 = 1.5;

/// `W(r, h) = s_D / h^D [(3-q)^5 - 6 (2-q)^5 + 15 (1-q)^5]`, `q = r / h` [Morris, Fox & Zhu 1997, eq. 11].
pub fn value<const D: usize>(r: f64, h: f64) -> f64 {
    scale::<D>(h) * sum(r / h, |x| x.powi(5))
}

/// `dW/dr / r`, zero at the origin, where it is always multiplied with zero.
pub fn slope_over_r<const D: usize>(r: f64, h: f64) -> f64 {
    if r == 0.0 {
        return 0.0;
    }
    -scale::<D>(h) * 5.0 * sum(r / h, |x| x.powi(4)) / (h * r)
}

fn scale<const D: usize>(h: f64) -> f64 {
    match D {
        1 => 1.0 / (120.0 * h),
        2 => 7.0 / (478.0 * PI * h * h),
        _ => 1.0 / (120.0 * PI * h * h * h),
    }
}

fn sum(q: f64, power: impl Fn(f64) -> f64) -> f64 {
    let part = |end: f64| if q < end { power(end - q) } else { 0.0 };
    part(3.0) - 6.0 * part(2.0) + 15.0 * part(1.0)
}

/// `sum W` over a lattice of spacing one, and the factor `l` of its renormalisation matrix `l I`.
pub fn lattice<const D: usize>() -> (f64, f64) {
    let (mut weight, mut moment) = (0.0, 0.0);
    let reach = 5_i32;
    let count = (2 * reach + 1).pow(D as u32);
    for number in 0..count {
        let mut rest = number;
        let offset = Vector::<D>::from_fn(|_, _| {
            let index = rest % (2 * reach + 1) - reach;
            rest /= 2 * reach + 1;
            f64::from(index)
        });
        let r = offset.norm();
        weight += value::<D>(r, RATIO);
        moment -= slope_over_r::<D>(r, RATIO) * offset[0] * offset[0];
    }
    (weight, 1.0 / moment)
}
