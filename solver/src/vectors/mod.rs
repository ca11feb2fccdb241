//! The processor's vectors, of `f64` or of `f32`: what the pair loops compute in.

use super::records::{Kept, Number};

/// Writes the operations that vectors of either precision have under names of their own.
macro_rules! arithmetic {
    ($($name:ident = $method:ident($($operand:ident),*);)*) => {
        $(
            #[inline(always)]
            fn $name(self, $($operand: Self::Vector),*) -> Self::Vector {
                self.0.$method($($operand),*)
            }
        )*
    };
}

mod arch;
mod double;
mod single;

#[cfg(test)]
pub use arch::avx2;
pub use arch::{Arch, Pass, dispatch};
pub use double::Double;
pub use single::Single;

/// Most lanes of any instruction set and precision: eight `f64` with AVX-512, eight `f32` with AVX2.
pub const MAX_LANES: usize = 8;

/// One instruction set at one precision.
pub trait Vectors: Copy + 'static {
    /// What the records of neighbours are made of.
    type Number: Kept;
    /// One number per lane.
    type Vector: Copy;
    /// One coordinate per lane.
    type Places: Copy;
    /// Number of lanes.
    const LANES: usize;
    /// Next to nothing, but far from what numbers cannot hold, even divided by a hundred.
    const LEAST: f64;
    /// Part of a squared length that is less than the numbers' own spacing.
    const LEAST_SQUARE: f64;

    /// The same number in every lane.
    fn splat(self, value: f64) -> Self::Vector;
    /// The same of a neighbour's number.
    fn broadcast(self, number: Self::Number) -> Self::Vector;
    /// Lane `l` gets `numbers(l)`.
    fn gather(self, numbers: impl Fn(usize) -> Self::Number) -> Self::Vector;
    /// The lanes as numbers, the rest zero.
    fn store(self, vector: Self::Vector) -> [f64; MAX_LANES];
    /// Lane `l` gets `place(l)`.
    fn places(self, place: impl Fn(usize) -> Place<Self>) -> Self::Places;
    /// `places - place`.
    fn apart(self, places: Self::Places, place: Place<Self>) -> Self::Vector;
    /// `a + b`.
    fn add(self, a: Self::Vector, b: Self::Vector) -> Self::Vector;
    /// `a - b`.
    fn sub(self, a: Self::Vector, b: Self::Vector) -> Self::Vector;
    /// `a b`.
    fn mul(self, a: Self::Vector, b: Self::Vector) -> Self::Vector;
    /// `-a`.
    fn neg(self, a: Self::Vector) -> Self::Vector;
    /// `a b + c`, in one rounding where the processor can.
    fn mul_add(self, a: Self::Vector, b: Self::Vector, c: Self::Vector) -> Self::Vector;
    /// The larger of both.
    fn max(self, a: Self::Vector, b: Self::Vector) -> Self::Vector;
    /// The smaller of both.
    fn min(self, a: Self::Vector, b: Self::Vector) -> Self::Vector;
    /// `a / b`.
    fn div(self, a: Self::Vector, b: Self::Vector) -> Self::Vector;
    /// Square root.
    fn sqrt(self, a: Self::Vector) -> Self::Vector;
    /// A rough `1 / a` or `1 / sqrt(a)`, with a relative error below 2^-14, where it and a
    /// polynomial that makes it exact to an ulp or two take less time than a division.
    fn rough(self, what: Rough, a: Self::Vector) -> Option<Self::Vector>;
}

/// A coordinate in the records.
pub type Place<V> = <<V as Vectors>::Number as Number>::Place;

/// What [`Vectors::rough`] estimates.
#[derive(Clone, Copy)]
pub enum Rough {
    /// `1 / a`.
    Reciprocal,
    /// `1 / sqrt(a)`.
    ReciprocalRoot,
}
