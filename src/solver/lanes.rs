//! Arithmetic on as many particles at once as the processor's vectors hold. The width is chosen
//! at run time (`pulp`), the formulas are written once.

use std::any::Any;
use std::ops::{Add, AddAssign, Mul, Neg, Sub};

use pulp::{Arch, Simd};

/// Most lanes of any instruction set: eight `f64` with AVX-512.
pub const MAX_LANES: usize = 8;

/// The widest instruction set that the processor has; `AERO_VECTORS` may ask for a narrower one, `avx2` or
/// `plain`, to compare them.
///
/// # Errors
/// One that it does not have, or that there is not.
pub fn processor() -> Result<Arch, String> {
    let Ok(wanted) = std::env::var("AERO_VECTORS") else {
        return Ok(Arch::new());
    };
    let found = match wanted.as_str() {
        "plain" => Some(Arch::Scalar),
        "avx2" => avx2(),
        _ => None,
    };
    found.ok_or_else(|| {
        format!(
            "the environment variable `AERO_VECTORS` is `{wanted}`, which this processor does not have; \
             set it to `avx2` or `plain`, or leave it out for the widest vectors"
        )
    })
}

/// Vectors of four `f64`, where the processor has them.
pub fn avx2() -> Option<Arch> {
    #[cfg(target_arch = "x86_64")]
    return pulp::x86::V3::try_new().map(Arch::V3);
    #[cfg(not(target_arch = "x86_64"))]
    None
}

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

    /// Square root.
    #[inline(always)]
    pub fn sqrt(self) -> Self {
        Self {
            simd: self.simd,
            value: self.simd.sqrt_f64s(self.value),
        }
    }

    /// `1 / self`, for positive or negative but no zero or infinite numbers.
    #[inline(always)]
    pub fn recip(self) -> Self {
        let one = Self::splat(self.simd, 1.0);
        let Some(rough) = self.rough(Rough::Reciprocal) else {
            return Self {
                simd: self.simd,
                value: self.simd.div_f64s(one.value, self.value),
            };
        };
        // 1 / (1 - e) = (1 + e) (1 + e^2) + O(e^4).
        let error = (-self).mul_add(rough, one);
        let better = rough.mul_add(error, rough);
        better.mul_add(error * error, better)
    }

    /// `sqrt(self)`, `1 / sqrt(self)` and `1 / other` of positive numbers.
    #[inline(always)]
    pub fn roots(self, other: Self) -> Roots<S> {
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
        let error = (-(self * rough)).mul_add(rough, Self::splat(self.simd, 1.0));
        let series = error.mul_add(
            Self::splat(self.simd, 5.0 / 16.0),
            Self::splat(self.simd, 3.0 / 8.0),
        );
        let series = series.mul_add(error, Self::splat(self.simd, 0.5));
        let inverse_root = (rough * error).mul_add(series, rough);
        Roots {
            root: self * inverse_root,
            inverse_root,
            inverse_other: other.recip(),
        }
    }

    /// An estimate with a relative error below 2^-14, where the instruction set has one for `f64`: a
    /// polynomial makes it exact to an ulp or two in less time than a division takes.
    #[inline(always)]
    #[allow(unused_variables)]
    fn rough(self, what: Rough) -> Option<Self> {
        #[cfg(target_arch = "x86_64")]
        if let Some(simd) = (&self.simd as &dyn Any).downcast_ref::<pulp::x86::V4>() {
            let value = pulp::cast(*(&self.value as &dyn Any).downcast_ref::<pulp::f64x8>()?);
            let rough: pulp::f64x8 = pulp::cast(match what {
                Rough::Reciprocal => simd.avx512f._mm512_rcp14_pd(value),
                Rough::ReciprocalRoot => simd.avx512f._mm512_rsqrt14_pd(value),
            });
            let &value = (&rough as &dyn Any).downcast_ref()?;
            return Some(Self {
                simd: self.simd,
                value,
            });
        }
        None
    }
}

/// What [`Lane::rough`] estimates.
#[derive(Clone, Copy)]
enum Rough {
    Reciprocal,
    ReciprocalRoot,
}

/// What [`Lane::roots`] finds.
pub struct Roots<S: Simd> {
    /// `sqrt(x)`.
    pub root: Lane<S>,
    /// `1 / sqrt(x)`.
    pub inverse_root: Lane<S>,
    /// `1 / y`.
    pub inverse_other: Lane<S>,
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
