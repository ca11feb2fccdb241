//! Pair laws, one published model per file, and the passes that sum them.
//!
//! A pass treats one cluster of particles `i` in the lanes and broadcasts each neighbour `j`.

use aero_geometry::Vector;
use aero_geometry::kernel::QuinticSpline;
use pulp::Simd;

use super::lanes::Lane;
use super::records::Near;

pub mod artificial_conduction;
pub mod artificial_viscosity;
pub mod concentration;
pub mod density_diffusion;
pub mod exchange;
pub mod extrapolation;
pub mod rates;
pub mod renormalisation;
pub mod shield;
pub mod summation;
mod sums;

/// A vector per lane.
pub type LaneVector<S, const D: usize> = [Lane<S>; D];

/// The geometry of particle `i` in each lane.
#[derive(Clone, Copy)]
pub struct Target<S: Simd, const D: usize> {
    position: LaneVector<S, D>,
    half_h: Lane<S>,
    half_density: Lane<S>,
    /// Keeps squared distances off zero, so that a particle meets itself without dividing by zero;
    /// all terms of that pair carry a factor `r_ij` or a difference and vanish.
    least: Lane<S>,
}

impl<S: Simd, const D: usize> Target<S, D> {
    /// Loads the particles `near(l)`, one per lane.
    #[inline(always)]
    pub fn load<'a>(simd: S, near: impl Fn(usize) -> &'a Near<D>) -> Self {
        Self::new(
            simd,
            std::array::from_fn(|k| Lane::gather(simd, |l| near(l).position[k])),
            Lane::gather(simd, |l| near(l).half_h),
            Lane::gather(simd, |l| near(l).half_density),
        )
    }

    /// Points in space, half the smoothing length and half the density there.
    #[inline(always)]
    fn new(simd: S, position: LaneVector<S, D>, half_h: Lane<S>, half_density: Lane<S>) -> Self {
        Self {
            position,
            half_h,
            half_density,
            least: Lane::splat(simd, 1e-24) * half_h * half_h,
        }
    }
}

/// A pair `i, j`: what all laws need of it.
#[derive(Clone, Copy)]
pub struct Pair<S: Simd, const D: usize> {
    /// `r_ij = r_i - r_j`.
    pub separation: LaneVector<S, D>,
    /// `r_ij^2`; positive for the particle with itself.
    pub squared: Lane<S>,
    /// `1 / r_ij`.
    pub inverse_distance: Lane<S>,
    /// `h_ij`, the mean smoothing length.
    pub h: Lane<S>,
    /// `r_ij / h_ij`.
    pub ratio: Lane<S>,
    /// `F` in `grad_i W_ij = F r_ij`; never positive.
    pub gradient_factor: Lane<S>,
    /// `1 / rho_ij`, with the mean density.
    pub inverse_density: Lane<S>,
}

/// A pair's geometry before any law is applied.
struct Separation<S: Simd, const D: usize> {
    vector: LaneVector<S, D>,
    /// Squared distance, kept off zero by a part in 10^24 of `h^2`.
    squared: Lane<S>,
    h: Lane<S>,
}

impl<S: Simd, const D: usize> Separation<S, D> {
    #[inline(always)]
    fn new(simd: S, i: &Target<S, D>, j: &Near<D>) -> Self {
        let vector: LaneVector<S, D> =
            std::array::from_fn(|k| i.position[k] - Lane::splat(simd, j.position[k]));
        Self {
            vector,
            squared: dot_add(&vector, &vector, i.least),
            h: i.half_h + Lane::splat(simd, j.half_h),
        }
    }
}

impl<S: Simd, const D: usize> Pair<S, D> {
    /// The pair of the particles in `i` with `j`.
    #[inline(always)]
    pub fn new(simd: S, i: &Target<S, D>, j: &Near<D>) -> Self {
        let Separation { vector, squared, h } = Separation::new(simd, i, j);
        let density = i.half_density + Lane::splat(simd, j.half_density);
        let roots = squared.roots(h * density);
        let inverse_h = roots.inverse_other * density;
        let gradient_factor =
            gradient_factor::<S, D>(simd, roots.root, roots.inverse_root, inverse_h);
        Self {
            separation: vector,
            squared,
            inverse_distance: roots.inverse_root,
            h,
            ratio: roots.root * inverse_h,
            gradient_factor,
            inverse_density: roots.inverse_other * h,
        }
    }
}

/// `(dW/dr) / r` of the quintic spline.
#[inline(always)]
fn gradient_factor<S: Simd, const D: usize>(
    simd: S,
    distance: Lane<S>,
    inverse_distance: Lane<S>,
    inverse_h: Lane<S>,
) -> Lane<S> {
    let [a, b, c] = brackets(simd, distance * inverse_h);
    let six = Lane::splat(simd, -6.0);
    let fifteen = Lane::splat(simd, 15.0);
    let slope = fourth(c).mul_add(fifteen, fourth(b).mul_add(six, fourth(a)));
    let scale = Lane::splat(simd, -5.0 * QuinticSpline::<D>::NORMALISATION);
    scale * slope * inverse_distance * power::<S, D>(inverse_h) * inverse_h
}

/// Value of the quintic spline.
#[inline(always)]
fn kernel_value<S: Simd, const D: usize>(
    simd: S,
    distance: Lane<S>,
    inverse_h: Lane<S>,
) -> Lane<S> {
    let [a, b, c] = brackets(simd, distance * inverse_h);
    let six = Lane::splat(simd, -6.0);
    let fifteen = Lane::splat(simd, 15.0);
    let value = (fourth(c) * c).mul_add(fifteen, (fourth(b) * b).mul_add(six, fourth(a) * a));
    Lane::splat(simd, QuinticSpline::<D>::NORMALISATION) * value * power::<S, D>(inverse_h)
}

/// The positive parts of `3 - q`, `2 - q`, `1 - q`: beyond the support all are exactly zero.
#[inline(always)]
fn brackets<S: Simd>(simd: S, q: Lane<S>) -> [Lane<S>; 3] {
    let zero = Lane::splat(simd, 0.0);
    [3.0, 2.0, 1.0].map(|n| (Lane::splat(simd, n) - q).max(zero))
}

#[inline(always)]
fn fourth<S: Simd>(a: Lane<S>) -> Lane<S> {
    let squared = a * a;
    squared * squared
}

/// `a^D`.
#[inline(always)]
fn power<S: Simd, const D: usize>(a: Lane<S>) -> Lane<S> {
    match D {
        1 => a,
        2 => a * a,
        _ => a * a * a,
    }
}

/// Scalar product.
#[inline(always)]
pub fn dot<S: Simd, const D: usize>(a: &LaneVector<S, D>, b: &LaneVector<S, D>) -> Lane<S> {
    let mut sum = a[0] * b[0];
    for k in 1..D {
        sum = a[k].mul_add(b[k], sum);
    }
    sum
}

/// Scalar product, and what is added to it.
#[inline(always)]
pub fn dot_add<S: Simd, const D: usize>(
    a: &LaneVector<S, D>,
    b: &LaneVector<S, D>,
    addend: Lane<S>,
) -> Lane<S> {
    let mut sum = addend;
    for k in 0..D {
        sum = a[k].mul_add(b[k], sum);
    }
    sum
}

/// A vector of zeros.
#[inline(always)]
pub fn zeros<S: Simd, const D: usize>(simd: S) -> LaneVector<S, D> {
    [Lane::splat(simd, 0.0); D]
}

/// Lane `l` of a vector, from its components' arrays.
#[inline(always)]
fn unlane<const D: usize>(lanes: &[[f64; super::lanes::MAX_LANES]; D], l: usize) -> Vector<D> {
    Vector::from_fn(|k, _| lanes[k][l])
}
