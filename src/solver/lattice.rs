//! The square lattice on which the gas starts.

use aero_geometry::Vector;

/// Position of lattice point `index`: cell centres of a grid whose first corner is `corner`.
pub fn position<const D: usize>(corner: &Vector<D>, spacing: f64, index: &[i64; D]) -> Vector<D> {
    Vector::from_fn(|k, _| corner[k] + (index[k] as f64 + 0.5) * spacing)
}

/// All indices with `first <= index < last` on every axis, the last axis running fastest.
pub fn points<const D: usize>(first: [i64; D], last: [i64; D]) -> impl Iterator<Item = [i64; D]> {
    let lengths: [i64; D] = std::array::from_fn(|k| (last[k] - first[k]).max(0));
    let total: i64 = lengths.iter().product();
    (0..total).map(move |number| {
        let mut rest = number;
        let mut index = first;
        for k in (0..D).rev() {
            index[k] += rest % lengths[k];
            rest /= lengths[k];
        }
        index
    })
}
