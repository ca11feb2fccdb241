//! Vectors of `f32`.

use pulp::Simd;

use super::{MAX_LANES, Rough, Vectors};
use crate::rounding::Split;

/// Vectors of `f32`.
#[derive(Clone, Copy)]
pub struct Single<S>(pub S);

impl<S: Simd> Vectors for Single<S> {
    type Number = f32;
    type Vector = S::f32s;
    type Places = [S::f32s; 2];
    const LANES: usize = S::F32_LANES;
    const LEAST: f64 = 1e-30;
    const LEAST_SQUARE: f64 = 1e-15;

    #[inline(always)]
    fn splat(self, value: f64) -> S::f32s {
        self.0.splat_f32s(value as f32)
    }

    #[inline(always)]
    fn broadcast(self, number: f32) -> S::f32s {
        self.0.splat_f32s(number)
    }

    #[inline(always)]
    fn gather(self, numbers: impl Fn(usize) -> f32) -> S::f32s {
        let mut buffer = [0.0_f32; MAX_LANES];
        let mut l = 0;
        while l < Self::LANES {
            buffer[l] = numbers(l);
            l += 1;
        }
        let (vectors, _) = S::as_simd_f32s(&buffer);
        vectors[0]
    }

    #[inline(always)]
    fn store(self, vector: S::f32s) -> [f64; MAX_LANES] {
        let mut buffer = [0.0_f32; MAX_LANES];
        let (vectors, _) = S::as_mut_simd_f32s(&mut buffer);
        vectors[0] = vector;
        buffer.map(f64::from)
    }

    #[inline(always)]
    fn places(self, place: impl Fn(usize) -> Split) -> [S::f32s; 2] {
        [
            self.gather(|l| place(l).whole),
            self.gather(|l| place(l).rest),
        ]
    }

    /// The whole parts differ by an exact number, the rest by one that rounds alike from both sides.
    #[inline(always)]
    fn apart(self, [wholes, rests]: [S::f32s; 2], place: Split) -> S::f32s {
        let whole = self.0.sub_f32s(wholes, self.0.splat_f32s(place.whole));
        let rest = self.0.sub_f32s(rests, self.0.splat_f32s(place.rest));
        self.0.add_f32s(whole, rest)
    }

    arithmetic! {
        add = add_f32s(a, b);
        sub = sub_f32s(a, b);
        mul = mul_f32s(a, b);
        neg = neg_f32s(a);
        mul_add = mul_add_e_f32s(a, b, c);
        max = max_f32s(a, b);
        min = min_f32s(a, b);
        div = div_f32s(a, b);
        sqrt = sqrt_f32s(a);
    }

    /// None: divisions and roots of `f32` take less time than what would spare them.
    #[inline(always)]
    fn rough(self, _: Rough, _: S::f32s) -> Option<S::f32s> {
        None
    }
}
