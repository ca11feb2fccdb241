//! Arithmetic on as many particles at once as the processor's vectors hold. The width is chosen
//! at run time (`pulp`), the formulas are written once.

use std::ops::{Add, AddAssign, Mul, Neg, Sub};

use pulp::Simd;

/// Most lanes of any instruction set: eight `f64` with AVX-512.
pub const MAX_LANES: usize = 8;

/// One `f64` per lane.
#[derive(Clone, Copy)]
pub struct Lane<S: Simd> {
    simd: S,
    value: S::f64s,
}

impl<S: Simd> Lane<S> {
    /// The same number in every lane.
    #[inline(always)]
    pub fn splat(simd: S, value: f64) -> Self {
        Self {
            simd,
            value: simd.splat_f64s(value),
        }
    }

    /// Lane `l` gets `values(l)`; lanes that the instruction set lacks are not asked for.
    #[inline(always)]
    pub fn gather(simd: S, values: impl Fn(usize) -> f64) -> Self {
        let mut buffer = [0.0; MAX_LANES];
        for (l, slot) in buffer.iter_mut().enumerate().take(S::F64_LANES) {
            *slot = values(l);
        }
        let (vectors, _) = S::as_simd_f64s(&buffer);
        Self {
            simd,
            value: vectors[0],
        }
    }

    /// The lanes as numbers; those beyond the instruction set's width are zero.
    #[inline(always)]
    pub fn to_array(self) -> [f64; MAX_LANES] {
        let mut buffer = [0.0; MAX_LANES];
        let (vectors, _) = S::as_mut_simd_f64s(&mut buffer);
        vectors[0] = self.value;
        buffer
    }

    /// `self * factor + addend` in one rounding.
    #[inline(always)]
    pub fn mul_add(self, factor: Self, addend: Self) -> Self {
        Self {
            simd: self.simd,
            value: self
                .simd
                .mul_add_e_f64s(self.value, factor.value, addend.value),
        }
    }

    /// The larger of both, lane by lane.
    #[inline(always)]
    pub fn max(self, other: Self) -> Self {
        Self {
            simd: self.simd,
            value: self.simd.max_f64s(self.value, other.value),
        }
    }

    /// The smaller of both, lane by lane.
    #[inline(always)]
    pub fn min(self, other: Self) -> Self {
        Self {
            simd: self.simd,
            value: self.simd.min_f64s(self.value, other.value),
        }
    }

    /// True where `self < other` in any lane.
    #[inline(always)]
    pub fn any_less(self, other: Self) -> bool {
        let less = self.simd.less_than_f64s(self.value, other.value);
        self.simd.first_true_m64s(less) < S::F64_LANES
    }

    /// Square root.
    #[inline(always)]
    pub fn sqrt(self) -> Self {
        Self {
            simd: self.simd,
            value: self.simd.sqrt_f64s(self.value),
        }
    }

    /// `1 / self`.
    #[inline(always)]
    pub fn recip(self) -> Self {
        let one = self.simd.splat_f64s(1.0);
        Self {
            simd: self.simd,
            value: self.simd.div_f64s(one, self.value),
        }
    }
}

impl<S: Simd> Add for Lane<S> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self {
            simd: self.simd,
            value: self.simd.add_f64s(self.value, other.value),
        }
    }
}

impl<S: Simd> Sub for Lane<S> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self {
            simd: self.simd,
            value: self.simd.sub_f64s(self.value, other.value),
        }
    }
}

impl<S: Simd> Mul for Lane<S> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self {
            simd: self.simd,
            value: self.simd.mul_f64s(self.value, other.value),
        }
    }
}

impl<S: Simd> Neg for Lane<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self {
            simd: self.simd,
            value: self.simd.neg_f64s(self.value),
        }
    }
}

impl<S: Simd> AddAssign for Lane<S> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}
