//! The numbers that face laws are written in: one face, or as many as the processor's vectors hold.
//!
//! No law fuses a product with a sum, so that each lane rounds as a plain `f64` does: the bits are the same
//! on any processor.

use std::ops::{Add, Div, Mul, Neg, Sub};

use pulp::Simd;

/// Most lanes of any processor.
pub const MAX_LANES: usize = 8;

/// A real number, or one per lane.
pub trait Real:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + Add<f64, Output = Self>
    + Sub<f64, Output = Self>
    + Mul<f64, Output = Self>
{
    /// `value`, in every lane.
    fn like(self, value: f64) -> Self;
    /// Square root.
    fn sqrt(self) -> Self;
    /// The smaller of two.
    fn min(self, other: Self) -> Self;
    /// The larger of two.
    fn max(self, other: Self) -> Self;
    /// `positive` where this number is above zero, `other` elsewhere and where it is none.
    fn select(self, positive: Self, other: Self) -> Self;
    /// What `value` makes of this number and another, lane by lane: of what is no formula.
    fn each(self, other: Self, value: impl Fn(f64, f64) -> f64) -> Self;
}

impl Real for f64 {
    #[inline(always)]
    fn like(self, value: f64) -> Self {
        value
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Self::sqrt(self)
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        if self < other { self } else { other }
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        if self > other { self } else { other }
    }

    #[inline(always)]
    fn select(self, positive: Self, other: Self) -> Self {
        if self > 0.0 { positive } else { other }
    }

    #[inline(always)]
    fn each(self, other: Self, value: impl Fn(f64, f64) -> f64) -> Self {
        value(self, other)
    }
}

/// A vector of the processor with the proof that it has such vectors.
#[derive(Clone, Copy, Debug)]
pub struct Lane<S: Simd>(pub S, pub S::f64s);

macro_rules! operator {
    ($trait:ident, $name:ident, $operation:ident) => {
        impl<S: Simd> $trait for Lane<S> {
            type Output = Self;

            #[inline(always)]
            fn $name(self, other: Self) -> Self {
                Self(self.0, self.0.$operation(self.1, other.1))
            }
        }
    };
}

operator!(Add, add, add_f64s);
operator!(Sub, sub, sub_f64s);
operator!(Mul, mul, mul_f64s);
operator!(Div, div, div_f64s);

macro_rules! with_number {
    ($trait:ident, $name:ident, $operation:ident) => {
        impl<S: Simd> $trait<f64> for Lane<S> {
            type Output = Self;

            #[inline(always)]
            fn $name(self, other: f64) -> Self {
                Self(self.0, self.0.$operation(self.1, self.0.splat_f64s(other)))
            }
        }
    };
}

with_number!(Add, add, add_f64s);
with_number!(Sub, sub, sub_f64s);
with_number!(Mul, mul, mul_f64s);

impl<S: Simd> Neg for Lane<S> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self(self.0, self.0.neg_f64s(self.1))
    }
}

impl<S: Simd> Real for Lane<S> {
    #[inline(always)]
    fn like(self, value: f64) -> Self {
        Self(self.0, self.0.splat_f64s(value))
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0, self.0.sqrt_f64s(self.1))
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        let is_less = self.0.less_than_f64s(self.1, other.1);
        Self(self.0, self.0.select_f64s(is_less, self.1, other.1))
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        let is_more = self.0.greater_than_f64s(self.1, other.1);
        Self(self.0, self.0.select_f64s(is_more, self.1, other.1))
    }

    #[inline(always)]
    fn select(self, positive: Self, other: Self) -> Self {
        let zero = self.0.splat_f64s(0.0);
        let is_positive = self.0.greater_than_f64s(self.1, zero);
        Self(self.0, self.0.select_f64s(is_positive, positive.1, other.1))
    }

    #[inline(always)]
    fn each(self, other: Self, value: impl Fn(f64, f64) -> f64) -> Self {
        let (mut own, mut others) = ([0.0; MAX_LANES], [0.0; MAX_LANES]);
        S::as_mut_simd_f64s(&mut own).0[0] = self.1;
        S::as_mut_simd_f64s(&mut others).0[0] = other.1;
        for (own, other) in own.iter_mut().zip(&others).take(S::F64_LANES) {
            *own = value(*own, *other);
        }
        Self(self.0, S::as_simd_f64s(&own).0[0])
    }
}
