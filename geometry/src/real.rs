//! Numbers that formulas are written for once: an `f64`, or as many as a processor's vectors hold.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A real number, or one per lane of a vector.
pub trait Real:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The same constant in as many lanes as `self` has.
    #[must_use]
    fn constant(self, value: f64) -> Self;
    /// `self * factor + addend`, in one rounding where the processor's vectors can.
    #[must_use]
    fn times_plus(self, factor: Self, addend: Self) -> Self;
    /// The larger of both.
    #[must_use]
    fn at_least(self, other: Self) -> Self;
    /// Square root.
    #[must_use]
    fn root(self) -> Self;
}

impl Real for f64 {
    #[inline(always)]
    fn constant(self, value: f64) -> Self {
        value
    }

    /// In two roundings: one would be a call of the mathematical library on processors without the instruction.
    #[inline(always)]
    fn times_plus(self, factor: Self, addend: Self) -> Self {
        self * factor + addend
    }

    #[inline(always)]
    fn at_least(self, other: Self) -> Self {
        self.max(other)
    }

    #[inline(always)]
    fn root(self) -> Self {
        self.sqrt()
    }
}
