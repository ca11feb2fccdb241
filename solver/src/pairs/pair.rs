//! The geometry of a pair of particles, and the kernel there.

use aero_geometry::kernel::{QuinticSpline, shape, steepness};

use crate::each::each;
use crate::lanes::Lane;
use crate::records::{Near, Read};
use crate::vectors::{Place, Vectors};

/// A vector per lane.
pub type LaneVector<V, const D: usize> = [Lane<V>; D];

/// The geometry of particle `i` in each lane.
#[derive(Clone, Copy)]
pub struct Target<V: Vectors, const D: usize> {
    position: [V::Places; D],
    half_h: Lane<V>,
    /// Half the density.
    pub half_density: Lane<V>,
    /// Keeps squared distances off zero, so that a particle meets itself without dividing by zero;
    /// all terms of that pair carry a factor `r_ij` or a difference and vanish.
    least: Lane<V>,
}

impl<V: Vectors, const D: usize> Target<V, D> {
    /// Loads the particles at `slot(l)`, one per lane.
    #[inline(always)]
    pub fn load(vectors: V, read: Read<'_, D, V::Number>, slot: impl Fn(usize) -> usize) -> Self {
        let near = |l: usize| &read.near[slot(l)];
        Self::new(
            vectors,
            |l, k| near(l).position[k],
            Lane::gather(vectors, |l| near(l).half_h),
            Lane::gather(vectors, |l| near(l).half_density),
        )
    }

    /// Points in space `place(lane, axis)`, half the smoothing length and half the density there.
    #[inline(always)]
    pub fn new(
        vectors: V,
        place: impl Fn(usize, usize) -> Place<V>,
        half_h: Lane<V>,
        half_density: Lane<V>,
    ) -> Self {
        Self {
            position: each(|k| vectors.places(|l| place(l, k))),
            half_h,
            half_density,
            least: Lane::splat(vectors, V::LEAST_SQUARE) * half_h * half_h,
        }
    }
}

/// A pair's geometry before any law is applied.
#[derive(Clone, Copy)]
pub struct Separation<V: Vectors, const D: usize> {
    /// `r_ij = r_i - r_j`.
    pub vector: LaneVector<V, D>,
    /// Squared distance, kept off zero by less than the numbers' own spacing.
    squared: Lane<V>,
    h: Lane<V>,
}

impl<V: Vectors, const D: usize> Separation<V, D> {
    /// That of the particles in `i` from `j`.
    #[inline(always)]
    pub fn new(vectors: V, i: &Target<V, D>, j: &Near<D, V::Number>) -> Self {
        let vector: LaneVector<V, D> = each(|k| Lane::apart(vectors, i.position[k], j.position[k]));
        Self {
            vector,
            squared: dot_add(&vector, &vector, i.least),
            h: i.half_h + Lane::broadcast(vectors, j.half_h),
        }
    }

    /// Value `W_ij` of the kernel.
    #[inline(always)]
    pub fn kernel(&self, vectors: V) -> Lane<V> {
        let roots = self.squared.roots(self.h);
        let value = shape(roots.root * roots.inverse_other);
        let scale = Lane::splat(vectors, QuinticSpline::<D>::NORMALISATION);
        scale * value * power::<V, D>(roots.inverse_other)
    }
}

/// A pair `i, j`: what laws need of its geometry.
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

impl<V: Vectors, const D: usize> Pair<V, D> {
    /// The pair of the particles in `i` with `j`.
    #[inline(always)]
    pub fn new(vectors: V, i: &Target<V, D>, j: &Near<D, V::Number>) -> Self {
        let Separation { vector, squared, h } = Separation::new(vectors, i, j);
        let density = i.half_density + Lane::broadcast(vectors, j.half_density);
        let roots = squared.roots(h * density);
        let inverse_h = roots.inverse_other * density;
        let ratio = roots.root * inverse_h;
        let scale = Lane::splat(vectors, -5.0 * QuinticSpline::<D>::NORMALISATION);
        let gradient_factor =
            scale * steepness(ratio) * roots.inverse_root * power::<V, D>(inverse_h) * inverse_h;
        Self {
            separation: vector,
            squared,
            inverse_distance: roots.inverse_root,
            h,
            ratio,
            gradient_factor,
            inverse_density: roots.inverse_other * h,
        }
    }
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

/// Adds `factor` times `vector` to `sum`.
#[inline(always)]
pub fn accumulate<V: Vectors, const D: usize>(
    sum: &mut LaneVector<V, D>,
    factor: Lane<V>,
    vector: &LaneVector<V, D>,
) {
    for k in 0..D {
        sum[k] = factor.mul_add(vector[k], sum[k]);
    }
}
