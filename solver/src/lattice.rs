//! The square lattice on which the gas starts.

use aero_geometry::Vector;
use aero_geometry::kernel::QuinticSpline;

/// Position of lattice point `index`: cell centres of a grid whose first corner is `corner`.
pub fn position<const D: usize>(corner: &Vector<D>, spacing: f64, index: &[i64; D]) -> Vector<D> {
    Vector::from_fn(|k, _| corner[k] + (index[k] as f64 + 0.5) * spacing)
}

/// All indices with `first <= index < last` on every axis, the last axis running fastest.
pub fn points<const D: usize>(first: [i64; D], last: [i64; D]) -> impl Iterator<Item = [i64; D]> {
    (0..count(&first, &last) as usize).map(move |number| at(first, last, number))
}

/// That with a `number` of [`points`], from 0.
pub fn at<const D: usize>(first: [i64; D], last: [i64; D], number: usize) -> [i64; D] {
    let mut rest = number as i64;
    let mut index = first;
    for k in (0..D).rev() {
        let length = last[k] - first[k];
        index[k] += rest % length;
        rest /= length;
    }
    index
}

/// The number of `index` among [`points`], if it is one of them.
pub fn number<const D: usize>(first: [i64; D], last: [i64; D], index: &[i64; D]) -> Option<usize> {
    (0..D).try_fold(0, |number, k| {
        let is_among = (first[k]..last[k]).contains(&index[k]);
        is_among.then(|| number * (last[k] - first[k]) as usize + (index[k] - first[k]) as usize)
    })
}

/// Number of indices with `first <= index < last` on every axis.
pub fn count<const D: usize>(first: &[i64; D], last: &[i64; D]) -> u64 {
    let lengths = first.iter().zip(last);
    lengths
        .map(|(first, last)| (last - first).max(0) as u64)
        .product()
}

/// Offsets of all lattice points within the support of a particle, in spacings.
fn neighbourhood<const D: usize>(ratio: f64) -> impl Iterator<Item = Vector<D>> {
    let reach = (3.0 * ratio).ceil() as i64;
    points([-reach; D], [reach + 1; D]).map(|index| Vector::from_fn(|k, _| index[k] as f64))
}

/// `V sum_j W(r_ij)` over an endless lattice with `h / dx` = `ratio`: 1 but for the kernel's
/// quadrature error.
pub fn density_sum<const D: usize>(ratio: f64) -> f64 {
    neighbourhood::<D>(ratio)
        .map(|r| QuinticSpline::<D>::value(r.norm(), ratio))
        .sum()
}

/// The factor `l` of a lattice particle's renormalisation matrix `l I`.
pub fn renormalisation<const D: usize>(ratio: f64) -> f64 {
    let moment: f64 = neighbourhood::<D>(ratio)
        .map(|r| -QuinticSpline::<D>::gradient_factor(r.norm(), ratio) * r[0] * r[0])
        .sum();
    1.0 / moment
}

/// A displacement with components in -1..1 that depends on the index alone (`SplitMix64`, Steele,
/// Lea & Flood 2014).
pub fn displacement<const D: usize>(index: &[i64; D]) -> Vector<D> {
    let mut state = index.iter().fold(0_u64, |seed, &i| {
        seed.wrapping_mul(0x0010_0000_01b3).wrapping_add(i as u64)
    });
    Vector::from_fn(|_, _| {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^= z >> 31;
        (z >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    })
}
