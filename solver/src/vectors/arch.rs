//! Which vectors the processor has, and work in them.

use pulp::{NullaryFnOnce, Simd, WithSimd};

use super::{Double, Single, Vectors};
use crate::scheme::Precision;

/// An instruction set, and the precision of what is done to each pair.
#[derive(Clone, Copy, Debug)]
pub struct Arch {
    /// The processor's.
    pub instructions: pulp::Arch,
    precision: Precision,
}

/// Work in vectors of any kind.
pub trait Pass {
    /// What it gives.
    type Output;

    /// Does it with `vectors`.
    fn run<V: Vectors>(self, vectors: V) -> Self::Output;
}

impl Arch {
    /// The widest instruction set that the processor has; `AERO_VECTORS` may ask for a narrower one, `avx2` or
    /// `plain`, to compare them.
    ///
    /// # Errors
    /// One that it does not have, or that there is not.
    pub fn of_processor(precision: Precision) -> Result<Self, String> {
        let Ok(wanted) = std::env::var("AERO_VECTORS") else {
            return Ok(Self::new(pulp::Arch::new(), precision));
        };
        let found = match wanted.as_str() {
            "plain" => Some(pulp::Arch::Scalar),
            "avx2" => avx2(),
            _ => None,
        };
        let instructions = found.ok_or_else(|| {
            format!(
                "the environment variable `AERO_VECTORS` is `{wanted}`, which this processor does not have; \
                 set it to `avx2` or `plain`, or leave it out for the widest vectors"
            )
        })?;
        Ok(Self::new(instructions, precision))
    }

    /// These instructions at this precision.
    pub fn new(instructions: pulp::Arch, precision: Precision) -> Self {
        Self {
            instructions,
            precision,
        }
    }

    /// The same instructions in `f64`.
    pub fn double(self) -> Self {
        Self::new(self.instructions, Precision::Double)
    }

    /// True where pairs are computed in `f32`.
    pub fn is_mixed(self) -> bool {
        self.precision == Precision::Mixed
    }

    /// Number of particles treated at once.
    pub fn lanes(self) -> usize {
        self.dispatch(Lanes)
    }

    /// Runs `pass` in these instructions' vectors of `f64`.
    pub fn dispatch_double<P: Pass>(self, pass: P) -> P::Output {
        dispatch(self.instructions, InDouble(pass))
    }

    /// Runs `pass` in these vectors.
    pub fn dispatch<P: Pass>(self, pass: P) -> P::Output {
        if self.precision == Precision::Double {
            return self.dispatch_double(pass);
        }
        match self.instructions {
            // Half a vector of AVX-512, with all its instructions and registers.
            #[cfg(all(target_arch = "x86_64", not(test)))]
            pulp::Arch::V4(simd) => simd.vectorize(InEights(pass, *simd)),
            #[cfg(target_arch = "x86_64")]
            pulp::Arch::V3(simd) => simd.vectorize(InEights(pass, simd)),
            #[cfg(all(target_arch = "x86_64", test))]
            pulp::Arch::V4(simd) => (*simd).vectorize(InEights(pass, *simd)),
            #[cfg(target_arch = "x86_64")]
            _ => InSingle(pass).with_simd(pulp::Scalar),
            #[cfg(not(target_arch = "x86_64"))]
            instructions => instructions.dispatch(InSingle(pass)),
        }
    }
}

/// Runs `work` in the vectors of `instructions`. Unit tests are compiled for no wider ones than AVX2: what they say of those the program's tests
/// compare with AVX-512, where the processor has it.
pub fn dispatch<W: WithSimd>(instructions: pulp::Arch, work: W) -> W::Output {
    #[cfg(all(target_arch = "x86_64", test))]
    return match instructions {
        pulp::Arch::V4(simd) => Simd::vectorize(*simd, work),
        pulp::Arch::V3(simd) => Simd::vectorize(simd, work),
        _ => Simd::vectorize(pulp::Scalar, work),
    };
    #[cfg(not(all(target_arch = "x86_64", test)))]
    instructions.dispatch(work)
}

/// Vectors of four `f64` or eight `f32`, where the processor has them.
pub fn avx2() -> Option<pulp::Arch> {
    #[cfg(target_arch = "x86_64")]
    return pulp::x86::V3::try_new().map(pulp::Arch::V3);
    #[cfg(not(target_arch = "x86_64"))]
    None
}

struct Lanes;

impl Pass for Lanes {
    type Output = usize;

    #[inline(always)]
    fn run<V: Vectors>(self, _: V) -> usize {
        V::LANES
    }
}

struct InDouble<P>(P);

impl<P: Pass> WithSimd for InDouble<P> {
    type Output = P::Output;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> P::Output {
        self.0.run(Double(simd))
    }
}

struct InSingle<P>(P);

impl<P: Pass> WithSimd for InSingle<P> {
    type Output = P::Output;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> P::Output {
        self.0.run(Single(simd))
    }
}

/// Eight `f32` at once.
#[cfg(target_arch = "x86_64")]
struct InEights<P>(P, pulp::x86::V3);

#[cfg(target_arch = "x86_64")]
impl<P: Pass> NullaryFnOnce for InEights<P> {
    type Output = P::Output;

    #[inline(always)]
    fn call(self) -> P::Output {
        self.0.run(Single(self.1))
    }
}
