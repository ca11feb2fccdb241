//! The processor's vectors as real numbers, for formulas that are written once.

use std::ops::{Add, Div, Mul, Neg, Sub};

use aero_geometry::Real;
use pulp::Simd;

/// One number per lane.
#[derive(Clone, Copy)]
pub(crate) struct Wide<S: Simd>(pub S, pub S::f64s);

/// Writes an operator that the vectors have.
macro_rules! operator {
    ($($trait:ident $name:ident $method:ident;)*) => {
        $(
            impl<S: Simd> $trait for Wide<S> {
                type Output = Self;

                #[inline(always)]
                fn $name(self, other: Self) -> Self {
                    Self(self.0, self.0.$method(self.1, other.1))
                }
            }
        )*
    };
}

operator! {
    Add add add_f64s;
    Sub sub sub_f64s;
    Mul mul mul_f64s;
    Div div div_f64s;
}

impl<S: Simd> Neg for Wide<S> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self(self.0, self.0.neg_f64s(self.1))
    }
}

impl<S: Simd> Real for Wide<S> {
    #[inline(always)]
    fn constant(self, value: f64) -> Self {
        Self(self.0, self.0.splat_f64s(value))
    }

    /// In two roundings, so that ghosts lie alike on all processors.
    #[inline(always)]
    fn times_plus(self, factor: Self, addend: Self) -> Self {
        self * factor + addend
    }

    #[inline(always)]
    fn at_least(self, other: Self) -> Self {
        Self(self.0, self.0.max_f64s(self.1, other.1))
    }

    #[inline(always)]
    fn root(self) -> Self {
        Self(self.0, self.0.sqrt_f64s(self.1))
    }
}
