//! Vectors of `f64`.

use std::any::Any;

use pulp::Simd;

use super::{MAX_LANES, Rough, Vectors};

/// Vectors of `f64`.
#[derive(Clone, Copy)]
pub struct Double<S>(pub S);

impl<S: Simd> Vectors for Double<S> {
    type Number = f64;
    type Vector = S::f64s;
    type Places = S::f64s;
    const LANES: usize = S::F64_LANES;
    const LEAST: f64 = 1e-200;
    const LEAST_SQUARE: f64 = 1e-24;

    #[inline(always)]
    fn splat(self, value: f64) -> S::f64s {
        self.0.splat_f64s(value)
    }

    #[inline(always)]
    fn broadcast(self, number: f64) -> S::f64s {
        self.0.splat_f64s(number)
    }

    #[inline(always)]
    fn gather(self, numbers: impl Fn(usize) -> f64) -> S::f64s {
        let mut buffer = [0.0; MAX_LANES];
        let mut l = 0;
        while l < Self::LANES {
            buffer[l] = numbers(l);
            l += 1;
        }
        let (vectors, _) = S::as_simd_f64s(&buffer);
        vectors[0]
    }

    #[inline(always)]
    fn store(self, vector: S::f64s) -> [f64; MAX_LANES] {
        let mut buffer = [0.0; MAX_LANES];
        let (vectors, _) = S::as_mut_simd_f64s(&mut buffer);
        vectors[0] = vector;
        buffer
    }

    #[inline(always)]
    fn places(self, place: impl Fn(usize) -> f64) -> S::f64s {
        self.gather(place)
    }

    #[inline(always)]
    fn apart(self, places: S::f64s, place: f64) -> S::f64s {
        self.0.sub_f64s(places, self.splat(place))
    }

    arithmetic! {
        add = add_f64s(a, b);
        sub = sub_f64s(a, b);
        mul = mul_f64s(a, b);
        neg = neg_f64s(a);
        mul_add = mul_add_e_f64s(a, b, c);
        max = max_f64s(a, b);
        min = min_f64s(a, b);
        div = div_f64s(a, b);
        sqrt = sqrt_f64s(a);
    }

    #[inline(always)]
    #[allow(unused_variables)]
    fn rough(self, what: Rough, a: S::f64s) -> Option<S::f64s> {
        #[cfg(target_arch = "x86_64")]
        if let Some(simd) = (&self.0 as &dyn Any).downcast_ref::<pulp::x86::V4>() {
            let a = pulp::cast(*(&a as &dyn Any).downcast_ref::<pulp::f64x8>()?);
            let rough: pulp::f64x8 = pulp::cast(match what {
                Rough::Reciprocal => simd.avx512f._mm512_rcp14_pd(a),
                Rough::ReciprocalRoot => simd.avx512f._mm512_rsqrt14_pd(a),
            });
            return (&rough as &dyn Any).downcast_ref().copied();
        }
        None
    }
}
