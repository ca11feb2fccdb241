//! Pairs of two gases.

use crate::lanes::Lane;
use crate::records::Number;
use crate::vectors::Vectors;

/// Share of the second gas in each lane, of all in `second`; none where that is empty.
#[inline(always)]
pub fn share<V: Vectors>(vectors: V, second: &[f64], slot: impl Fn(usize) -> usize) -> Lane<V> {
    if second.is_empty() {
        Lane::splat(vectors, 0.0)
    } else {
        Lane::gather(vectors, |l| V::Number::rounded(second[slot(l)]))
    }
}

/// One where a lane's gas, whose `share` is of the second, is another than that of a neighbour; zero where it is the same.
#[inline(always)]
pub fn unlike<V: Vectors>(vectors: V, share: Lane<V>, theirs: f64) -> Lane<V> {
    let apart = share - Lane::splat(vectors, theirs);
    apart * apart
}
