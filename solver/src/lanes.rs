//! Arithmetic on as many particles at once as the processor's vectors hold. Width and precision are
//! chosen at run time ([`super::vectors`]), the formulas are written once.

use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

use aero_geometry::Real;

use super::vectors::{MAX_LANES, Place, Rough, Vectors};

/// One number per lane.
#[derive(Clone, Copy)]
pub struct Lane<V: Vectors> {
    vectors: V,
    value: V::Vector,
}

impl<V: Vectors> Lane<V> {
    #[inline(always)]
    fn with(self, value: V::Vector) -> Self {
        Self {
            vectors: self.vectors,
            value,
        }
    }

    /// The same number in every lane.
    #[inline(always)]
    pub fn splat(vectors: V, value: f64) -> Self {
        Self {
            vectors,
            value: vectors.splat(value),
        }
    }

    /// A neighbour's number in every lane.
    #[inline(always)]
    pub fn broadcast(vectors: V, number: V::Number) -> Self {
        Self {
            vectors,
            value: vectors.broadcast(number),
        }
    }

    /// Lane `l` gets `numbers(l)`; lanes that the instruction set lacks are not asked for.
    #[inline(always)]
    pub fn gather(vectors: V, numbers: impl Fn(usize) -> V::Number) -> Self {
        Self {
            vectors,
            value: vectors.gather(numbers),
        }
    }

    /// `places - place`.
    #[inline(always)]
    pub fn apart(vectors: V, places: V::Places, place: Place<V>) -> Self {
        Self {
            vectors,
            value: vectors.apart(places, place),
        }
    }

    /// The lanes as numbers; those beyond the instruction set's width are zero.
    #[inline(always)]
    pub fn to_array(self) -> [f64; MAX_LANES] {
        self.vectors.store(self.value)
    }

    /// `self * factor + addend` in one rounding.
    #[inline(always)]
    pub fn mul_add(self, factor: Self, addend: Self) -> Self {
        self.with(self.vectors.mul_add(self.value, factor.value, addend.value))
    }

    /// The larger of both, lane by lane.
    #[inline(always)]
    pub fn max(self, other: Self) -> Self {
        self.with(self.vectors.max(self.value, other.value))
    }

    /// The smaller of both, lane by lane.
    #[inline(always)]
    pub fn min(self, other: Self) -> Self {
        self.with(self.vectors.min(self.value, other.value))
    }

    /// Square root.
    #[inline(always)]
    pub fn sqrt(self) -> Self {
        self.with(self.vectors.sqrt(self.value))
    }

    /// `1 / self`, for positive or negative but no zero or infinite numbers.
    #[inline(always)]
    pub fn recip(self) -> Self {
        let one = Self::splat(self.vectors, 1.0);
        let Some(rough) = self.rough(Rough::Reciprocal) else {
            return self.with(self.vectors.div(one.value, self.value));
        };
        // 1 / (1 - e) = (1 + e) (1 + e^2) + O(e^4).
        let error = (-self).mul_add(rough, one);
        let better = rough.mul_add(error, rough);
        better.mul_add(error * error, better)
    }

    /// `sqrt(self)`, `1 / sqrt(self)` and `1 / other` of positive numbers.
    #[inline(always)]
    pub fn roots(self, other: Self) -> Roots<V> {
        let Some(rough) = self.rough(Rough::ReciprocalRoot) else {
            // One division serves both, and need not wait for the root.
            let root = self.sqrt();
            let both = (self * other).recip();
            return Roots {
                root,
                inverse_root: both * other * root,
                inverse_other: both * self,
            };
        };
        // (1 - e)^(-1/2) = 1 + e/2 + 3/8 e^2 + 5/16 e^3 + O(e^4).
        let error = (-(self * rough)).mul_add(rough, Self::splat(self.vectors, 1.0));
        let series = error.mul_add(
            Self::splat(self.vectors, 5.0 / 16.0),
            Self::splat(self.vectors, 3.0 / 8.0),
        );
        let series = series.mul_add(error, Self::splat(self.vectors, 0.5));
        let inverse_root = (rough * error).mul_add(series, rough);
        Roots {
            root: self * inverse_root,
            inverse_root,
            inverse_other: other.recip(),
        }
    }

    #[inline(always)]
    fn rough(self, what: Rough) -> Option<Self> {
        let value = self.vectors.rough(what, self.value)?;
        Some(self.with(value))
    }
}

/// What [`Lane::roots`] finds.
pub struct Roots<V: Vectors> {
    /// `sqrt(x)`.
    pub root: Lane<V>,
    /// `1 / sqrt(x)`.
    pub inverse_root: Lane<V>,
    /// `1 / y`.
    pub inverse_other: Lane<V>,
}

impl<V: Vectors> Add for Lane<V> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.with(self.vectors.add(self.value, other.value))
    }
}

impl<V: Vectors> Sub for Lane<V> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.with(self.vectors.sub(self.value, other.value))
    }
}

impl<V: Vectors> Mul for Lane<V> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.with(self.vectors.mul(self.value, other.value))
    }
}

impl<V: Vectors> Div for Lane<V> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        self.with(self.vectors.div(self.value, other.value))
    }
}

impl<V: Vectors> Neg for Lane<V> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.with(self.vectors.neg(self.value))
    }
}

impl<V: Vectors> AddAssign for Lane<V> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<V: Vectors> Real for Lane<V> {
    #[inline(always)]
    fn constant(self, value: f64) -> Self {
        Self::splat(self.vectors, value)
    }

    #[inline(always)]
    fn times_plus(self, factor: Self, addend: Self) -> Self {
        self.mul_add(factor, addend)
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
