//! Kernel sums for a few points at once, one per lane of the processor's vectors. The width is
//! chosen at run time; every point's sum has the same terms in the same order whatever it is.

use std::ops::Range;

use aero_geometry::Vector;
use aero_geometry::kernel::{QuinticSpline, SUPPORT, shape, steepness};
use pulp::{Simd, WithSimd};

use crate::wide::Wide;

/// Points that are worked on together: the lanes of the widest vectors.
pub(crate) const CLUSTER: usize = 8;

/// One number for each point of a cluster.
pub(crate) type Lanes = [f64; CLUSTER];

/// Which factor of the kernel is summed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Factor {
    /// `W`.
    Value,
    /// `(dW/dr) / r`.
    Slope,
    /// `(1 - r / R) / r` up to the support `R`: how much closer than `R` the points are.
    Closeness,
}

/// `Σ V f` and `Σ V f (r_i - r_j)` over the sources in `runs`.
pub(crate) struct KernelSum<'a, const D: usize> {
    /// Sources: positions and volumes.
    pub sorted: &'a [(Vector<D>, f64)],
    /// Runs of them that hold all within the support of any point.
    pub runs: &'a [Range<usize>],
    /// The points' coordinates, per axis.
    pub position: [Lanes; D],
    /// Smoothing length.
    pub smoothing: f64,
    /// The factor `f`.
    pub factor: Factor,
}

impl<const D: usize> WithSimd for KernelSum<'_, D> {
    type Output = (Lanes, [Lanes; D]);

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Self::Output {
        let mut sum = [0.0; CLUSTER];
        let mut moment = [[0.0; CLUSTER]; D];
        let reach = SUPPORT * self.smoothing;
        for group in 0..CLUSTER / S::F64_LANES {
            let point: [S::f64s; D] =
                std::array::from_fn(|k| S::as_simd_f64s(&self.position[k]).0[group]);
            let mut total = simd.splat_f64s(0.0);
            let mut moments = [simd.splat_f64s(0.0); D];
            for run in self.runs {
                for (source, volume) in &self.sorted[run.clone()] {
                    let mut squared = simd.splat_f64s(0.0);
                    let mut offset = [squared; D];
                    for k in 0..D {
                        offset[k] = simd.sub_f64s(point[k], simd.splat_f64s(source[k]));
                        squared = simd.add_f64s(squared, simd.mul_f64s(offset[k], offset[k]));
                    }
                    if simd.reduce_min_f64s(squared) >= reach * reach {
                        continue;
                    }
                    let r = simd.sqrt_f64s(squared);
                    let weight = match self.factor {
                        Factor::Value => value(simd, r, self.smoothing),
                        Factor::Slope => slope(simd, r, self.smoothing),
                        Factor::Closeness => closeness(simd, r, reach),
                    };
                    let weight = simd.mul_f64s(weight, simd.splat_f64s(*volume));
                    total = simd.add_f64s(total, weight);
                    for k in 0..D {
                        moments[k] = simd.add_f64s(moments[k], simd.mul_f64s(weight, offset[k]));
                    }
                }
            }
            let norm = QuinticSpline::<D>::NORMALISATION;
            let scale = simd.splat_f64s(match self.factor {
                Factor::Value => norm / self.smoothing.powi(D as i32),
                Factor::Slope => -5.0 * norm / self.smoothing.powi(D as i32 + 1),
                Factor::Closeness => 1.0,
            });
            S::as_mut_simd_f64s(&mut sum).0[group] = simd.mul_f64s(total, scale);
            for k in 0..D {
                S::as_mut_simd_f64s(&mut moment[k]).0[group] = simd.mul_f64s(moments[k], scale);
            }
        }
        (sum, moment)
    }
}

/// `(3-q)^5 - 6 (2-q)^5 + 15 (1-q)^5`, each bracket only where positive.
#[inline(always)]
fn value<S: Simd>(simd: S, r: S::f64s, smoothing: f64) -> S::f64s {
    let q = simd.mul_f64s(r, simd.splat_f64s(1.0 / smoothing));
    shape(Wide(simd, q)).1
}

/// `((3-q)^4 - 6 (2-q)^4 + 15 (1-q)^4) / r`, each bracket only where positive.
#[inline(always)]
fn slope<S: Simd>(simd: S, r: S::f64s, smoothing: f64) -> S::f64s {
    let q = simd.mul_f64s(r, simd.splat_f64s(1.0 / smoothing));
    let sum = steepness(Wide(simd, q)).1;
    simd.div_f64s(sum, simd.max_f64s(r, simd.splat_f64s(1e-12 * smoothing)))
}

/// `(1 - r / reach) / r`, only where positive.
#[inline(always)]
fn closeness<S: Simd>(simd: S, r: S::f64s, reach: f64) -> S::f64s {
    let part = simd.mul_f64s(r, simd.splat_f64s(1.0 / reach));
    let one = simd.splat_f64s(1.0);
    let part = simd.max_f64s(simd.sub_f64s(one, part), simd.splat_f64s(0.0));
    simd.div_f64s(part, simd.max_f64s(r, simd.splat_f64s(1e-12 * reach)))
}
