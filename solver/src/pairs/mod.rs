//! Pair laws, one published model per file, and the passes that sum them.
//!
//! A pass treats one cluster of particles `i` in the lanes and broadcasts each neighbour `j`. Laws do not ask in what numbers
//! the lanes are ([`super::vectors`]).

use super::lanes::Lane;
use super::records::Near;
use super::vectors::{MAX_LANES, Place, Vectors};
use aero_geometry::Vector;
use aero_geometry::kernel::QuinticSpline;

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
pub type LaneVector<V, const D: usize> = [Lane<V>; D];

/// The geometry of particle `i` in each lane.
#[derive(Clone, Copy)]
pub struct Target<V: Vectors, const D: usize> {
    position: [V::Places; D],
    half_h: Lane<V>,
    half_density: Lane<V>,
    /// Keeps squared distances off zero, so that a particle meets itself without dividing by zero;
    /// all terms of that pair carry a factor `r_ij` or a difference and vanish.
    least: Lane<V>,
}

impl<V: Vectors, const D: usize> Target<V, D> {
    /// Loads the particles `near(l)`, one per lane.
    #[inline(always)]
    pub fn load<'a>(vectors: V, near: impl Fn(usize) -> &'a Near<D, V::Number>) -> Self {
        Self::new(
            vectors,
            |l, k| near(l).position[k],
            Lane::gather(vectors, |l| near(l).half_h),
            Lane::gather(vectors, |l| near(l).half_density),
        )
    }

    /// Points in space `place(lane, axis)`, half the smoothing length and half the density there.
    #[inline(always)]
    fn new(
        vectors: V,
        place: impl Fn(usize, usize) -> Place<V>,
        half_h: Lane<V>,
        half_density: Lane<V>,
    ) -> Self {
        Self {
            position: std::array::from_fn(|k| vectors.places(|l| place(l, k))),
            half_h,
            half_density,
            least: Lane::splat(vectors, V::LEAST_SQUARE) * half_h * half_h,
        }
    }
}

/// A pair `i, j`: what all laws need of it.
#[derive(Clone, Copy)]
pub struct Pair<V: Vectors, const D: usize> {
    /// `r_ij = r_i - r_j`.
    pub separation: LaneVector<V, D>,
    /// `r_ij^2`; positive for the particle with itself.
    pub squared: Lane<V>,
    /// `1 / r_ij`.
    pub inverse_distance: Lane<V>,
    /// `h_ij`, the mean smoothing length.
    pub h: Lane<V>,
    /// `r_ij / h_ij`.
    pub ratio: Lane<V>,
    /// `F` in `grad_i W_ij = F r_ij`; never positive.
    pub gradient_factor: Lane<V>,
    /// `1 / rho_ij`, with the mean density.
    pub inverse_density: Lane<V>,
}

/// A pair's geometry before any law is applied.
struct Separation<V: Vectors, const D: usize> {
    vector: LaneVector<V, D>,
    /// Squared distance, kept off zero by less than the numbers' own spacing.
    squared: Lane<V>,
    h: Lane<V>,
}

impl<V: Vectors, const D: usize> Separation<V, D> {
    #[inline(always)]
    fn new(vectors: V, i: &Target<V, D>, j: &Near<D, V::Number>) -> Self {
        let vector: LaneVector<V, D> =
            std::array::from_fn(|k| Lane::apart(vectors, i.position[k], j.position[k]));
        Self {
            vector,
            squared: dot_add(&vector, &vector, i.least),
            h: i.half_h + Lane::splat(vectors, j.half_h),
        }
    }
}

impl<V: Vectors, const D: usize> Pair<V, D> {
    /// The pair of the particles in `i` with `j`.
    #[inline(always)]
    pub fn new(vectors: V, i: &Target<V, D>, j: &Near<D, V::Number>) -> Self {
        let Separation { vector, squared, h } = Separation::new(vectors, i, j);
        let density = i.half_density + Lane::splat(vectors, j.half_density);
        let roots = squared.roots(h * density);
        let inverse_h = roots.inverse_other * density;
        let gradient_factor =
            gradient_factor::<V, D>(vectors, roots.root, roots.inverse_root, inverse_h);
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
fn gradient_factor<V: Vectors, const D: usize>(
    vectors: V,
    distance: Lane<V>,
    inverse_distance: Lane<V>,
    inverse_h: Lane<V>,
) -> Lane<V> {
    let [a, b, c] = brackets(vectors, distance * inverse_h);
    let six = Lane::splat(vectors, -6.0);
    let fifteen = Lane::splat(vectors, 15.0);
    let slope = fourth(c).mul_add(fifteen, fourth(b).mul_add(six, fourth(a)));
    let scale = Lane::splat(vectors, -5.0 * QuinticSpline::<D>::NORMALISATION);
    scale * slope * inverse_distance * power::<V, D>(inverse_h) * inverse_h
}

/// Value of the quintic spline.
#[inline(always)]
fn kernel_value<V: Vectors, const D: usize>(
    vectors: V,
    distance: Lane<V>,
    inverse_h: Lane<V>,
) -> Lane<V> {
    let [a, b, c] = brackets(vectors, distance * inverse_h);
    let six = Lane::splat(vectors, -6.0);
    let fifteen = Lane::splat(vectors, 15.0);
    let value = (fourth(c) * c).mul_add(fifteen, (fourth(b) * b).mul_add(six, fourth(a) * a));
    Lane::splat(vectors, QuinticSpline::<D>::NORMALISATION) * value * power::<V, D>(inverse_h)
}

/// The positive parts of `3 - q`, `2 - q`, `1 - q`: beyond the support all are exactly zero.
#[inline(always)]
fn brackets<V: Vectors>(vectors: V, q: Lane<V>) -> [Lane<V>; 3] {
    let zero = Lane::splat(vectors, 0.0);
    [3.0, 2.0, 1.0].map(|n| (Lane::splat(vectors, n) - q).max(zero))
}

#[inline(always)]
fn fourth<V: Vectors>(a: Lane<V>) -> Lane<V> {
    let squared = a * a;
    squared * squared
}

/// `a^D`.
#[inline(always)]
fn power<V: Vectors, const D: usize>(a: Lane<V>) -> Lane<V> {
    match D {
        1 => a,
        2 => a * a,
        _ => a * a * a,
    }
}

/// Scalar product.
#[inline(always)]
pub fn dot<V: Vectors, const D: usize>(a: &LaneVector<V, D>, b: &LaneVector<V, D>) -> Lane<V> {
    let mut sum = a[0] * b[0];
    for k in 1..D {
        sum = a[k].mul_add(b[k], sum);
    }
    sum
}

/// Scalar product, and what is added to it.
#[inline(always)]
pub fn dot_add<V: Vectors, const D: usize>(
    a: &LaneVector<V, D>,
    b: &LaneVector<V, D>,
    addend: Lane<V>,
) -> Lane<V> {
    let mut sum = addend;
    for k in 0..D {
        sum = a[k].mul_add(b[k], sum);
    }
    sum
}

/// A vector of zeros.
#[inline(always)]
pub fn zeros<V: Vectors, const D: usize>(vectors: V) -> LaneVector<V, D> {
    [Lane::splat(vectors, 0.0); D]
}

/// Lane `l` of a vector, from its components' arrays.
#[inline(always)]
fn unlane<const D: usize>(lanes: &[[f64; MAX_LANES]; D], l: usize) -> Vector<D> {
    Vector::from_fn(|k, _| lanes[k][l])
}
