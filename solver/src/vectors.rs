//! The processor's vectors, of `f64` or of `f32`: what the pair loops compute in.

use std::any::Any;

use pulp::{NullaryFnOnce, Simd, WithSimd};

use super::records::{Number, Split};
use crate::scheme::Precision;

/// Most lanes of any instruction set and precision: eight `f64` with AVX-512, eight `f32` with AVX2.
pub const MAX_LANES: usize = 8;

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
        self.instructions.dispatch(InDouble(pass))
    }

    /// Runs `pass` in these vectors.
    pub fn dispatch<P: Pass>(self, pass: P) -> P::Output {
        if self.precision == Precision::Double {
            return self.dispatch_double(pass);
        }
        match self.instructions {
            // Half a vector of AVX-512, with all its instructions and registers.
            #[cfg(target_arch = "x86_64")]
            pulp::Arch::V4(simd) => simd.vectorize(InEights(pass, *simd)),
            #[cfg(target_arch = "x86_64")]
            pulp::Arch::V3(simd) => simd.vectorize(InEights(pass, simd)),
            #[cfg(target_arch = "x86_64")]
            _ => InSingle(pass).with_simd(pulp::Scalar),
            #[cfg(not(target_arch = "x86_64"))]
            instructions => instructions.dispatch(InSingle(pass)),
        }
    }
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

/// One instruction set at one precision.
pub trait Vectors: Copy + 'static {
    /// What the records of neighbours are made of.
    type Number: Number;
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

/// Vectors of `f64`.
#[derive(Clone, Copy)]
pub struct Double<S>(pub S);

/// Vectors of `f32`.
#[derive(Clone, Copy)]
pub struct Single<S>(pub S);

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
        for (l, slot) in buffer.iter_mut().enumerate().take(Self::LANES) {
            *slot = numbers(l);
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

impl<S: Simd> Vectors for Single<S> {
    type Number = f32;
    type Vector = S::f32s;
    type Places = [S::f32s; 2];
    const LANES: usize = S::F32_LANES;
    const LEAST: f64 = 1e-30;
    const LEAST_SQUARE: f64 = 1e-15;

    #[inline(always)]
    fn splat(self, value: f64) -> S::f32s {
        self.0.splat_f32s(value as f32)
    }

    #[inline(always)]
    fn broadcast(self, number: f32) -> S::f32s {
        self.0.splat_f32s(number)
    }

    #[inline(always)]
    fn gather(self, numbers: impl Fn(usize) -> f32) -> S::f32s {
        let mut buffer = [0.0_f32; MAX_LANES];
        for (l, slot) in buffer.iter_mut().enumerate().take(Self::LANES) {
            *slot = numbers(l);
        }
        let (vectors, _) = S::as_simd_f32s(&buffer);
        vectors[0]
    }

    #[inline(always)]
    fn store(self, vector: S::f32s) -> [f64; MAX_LANES] {
        let mut buffer = [0.0_f32; MAX_LANES];
        let (vectors, _) = S::as_mut_simd_f32s(&mut buffer);
        vectors[0] = vector;
        buffer.map(f64::from)
    }

    #[inline(always)]
    fn places(self, place: impl Fn(usize) -> Split) -> [S::f32s; 2] {
        [
            self.gather(|l| place(l).whole),
            self.gather(|l| place(l).rest),
        ]
    }

    /// The whole parts differ by an exact number, the rest by one that rounds alike from both sides.
    #[inline(always)]
    fn apart(self, [wholes, rests]: [S::f32s; 2], place: Split) -> S::f32s {
        let whole = self.0.sub_f32s(wholes, self.0.splat_f32s(place.whole));
        let rest = self.0.sub_f32s(rests, self.0.splat_f32s(place.rest));
        self.0.add_f32s(whole, rest)
    }

    arithmetic! {
        add = add_f32s(a, b);
        sub = sub_f32s(a, b);
        mul = mul_f32s(a, b);
        neg = neg_f32s(a);
        mul_add = mul_add_e_f32s(a, b, c);
        max = max_f32s(a, b);
        min = min_f32s(a, b);
        div = div_f32s(a, b);
        sqrt = sqrt_f32s(a);
    }

    /// None: divisions and roots of `f32` take less time than what would spare them.
    #[inline(always)]
    fn rough(self, _: Rough, _: S::f32s) -> Option<S::f32s> {
        None
    }
}
