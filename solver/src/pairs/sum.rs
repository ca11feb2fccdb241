//! What a law sums, whatever it is made of: lanes, arrays and tuples of them.

use crate::each::each;
use crate::lanes::Lane;
use crate::vectors::{MAX_LANES, Vectors};

/// Running sums of all lanes.
pub trait Sum<V: Vectors>: Copy {
    /// The same in memory.
    type Lanes: Copy;
    /// That of one lane.
    type Number: Copy;

    /// All zero.
    fn zero(vectors: V) -> Self;
    /// `factor` times this.
    #[must_use]
    fn scaled(self, factor: Lane<V>) -> Self;
    /// To memory.
    fn lanes(self) -> Self::Lanes;
    /// Lane `l`.
    fn number(lanes: &Self::Lanes, l: usize) -> Self::Number;
}

impl<V: Vectors> Sum<V> for Lane<V> {
    type Lanes = [f64; MAX_LANES];
    type Number = f64;

    #[inline(always)]
    fn zero(vectors: V) -> Self {
        Self::splat(vectors, 0.0)
    }

    #[inline(always)]
    fn scaled(self, factor: Lane<V>) -> Self {
        self * factor
    }

    #[inline(always)]
    fn lanes(self) -> Self::Lanes {
        self.to_array()
    }

    #[inline(always)]
    fn number(lanes: &Self::Lanes, l: usize) -> f64 {
        lanes[l]
    }
}

impl<V: Vectors, S: Sum<V>, const N: usize> Sum<V> for [S; N] {
    type Lanes = [S::Lanes; N];
    type Number = [S::Number; N];

    #[inline(always)]
    fn zero(vectors: V) -> Self {
        [S::zero(vectors); N]
    }

    #[inline(always)]
    fn scaled(self, factor: Lane<V>) -> Self {
        each(|k| self[k].scaled(factor))
    }

    #[inline(always)]
    fn lanes(self) -> Self::Lanes {
        each(|k| self[k].lanes())
    }

    #[inline(always)]
    fn number(lanes: &Self::Lanes, l: usize) -> Self::Number {
        each(|k| S::number(&lanes[k], l))
    }
}

/// Writes [`Sum`] for tuples, element by element.
macro_rules! tuples {
    ($(($($name:ident $place:tt),*);)*) => {
        $(
            impl<V: Vectors, $($name: Sum<V>),*> Sum<V> for ($($name,)*) {
                type Lanes = ($($name::Lanes,)*);
                type Number = ($($name::Number,)*);

                #[inline(always)]
                #[allow(unused_variables, clippy::unused_unit)]
                fn zero(vectors: V) -> Self {
                    ($($name::zero(vectors),)*)
                }

                #[inline(always)]
                #[allow(unused_variables, clippy::unused_unit)]
                fn scaled(self, factor: Lane<V>) -> Self {
                    ($(self.$place.scaled(factor),)*)
                }

                #[inline(always)]
                #[allow(clippy::unused_unit)]
                fn lanes(self) -> Self::Lanes {
                    ($(self.$place.lanes(),)*)
                }

                #[inline(always)]
                #[allow(unused_variables, clippy::unused_unit)]
                fn number(lanes: &Self::Lanes, l: usize) -> Self::Number {
                    ($($name::number(&lanes.$place, l),)*)
                }
            }
        )*
    };
}

tuples! {
    ();
    (A 0, B 1);
    (A 0, B 1, C 2);
    (A 0, B 1, C 2, E 3);
}
