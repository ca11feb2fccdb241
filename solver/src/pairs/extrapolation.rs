//! State of the gas at ghosts, or at their mirror points.

use aero_geometry::Vector;
use nalgebra::{Matrix4, Vector4};

use super::law::{Basis, Law, Neighbour};
use super::pair::{LaneVector, Separation, Target, accumulate};
use crate::backend::Backend;
use crate::each::each;
use crate::lanes::Lane;
use crate::neighbours::{Lists, Seeker};
use crate::records::{Matrix, Number, Read, Records};
use crate::vectors::Vectors;

/// A mirror point with less than this share of a full neighbourhood's volume is short of
/// neighbours.
const LEAST_SHARE: f64 = 0.3;

/// Below this reciprocal condition estimate the first-order fit is not trusted.
const LEAST_CONDITION: f64 = 1e-3;

/// State of the gas interpolated at a point.
#[derive(Clone, Copy, Debug)]
pub struct Interpolated<const D: usize> {
    /// Velocity.
    pub velocity: Vector<D>,
    /// Rate of strain, by Shepard's sum in either case.
    pub strain: Matrix<D>,
    /// Pressure.
    pub pressure: f64,
    /// Specific internal energy.
    pub energy: f64,
    /// Smoothing length.
    pub smoothing_length: f64,
    /// Where the interpolation really looked, relative to the point: the kernel-weighted centroid of
    /// the neighbours for Shepard's, zero for a first-order consistent one.
    pub centroid: Vector<D>,
}

/// Order of consistency asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Consistency {
    /// Shepard interpolation, `f = sum f_j W_j / sum W_j` [Villodi & Ramachandran 2024, eq. 24].
    Shepard,
    /// First order, by the moments' inverse [eq. 25; Liu & Liu 2006]; none where neighbours are
    /// too few or badly placed.
    FirstOrder,
}

/// Interpolates the gas at every listed seeker, in double precision; none where no neighbour is in reach.
pub fn interpolate<const D: usize>(
    backend: &impl Backend,
    lists: &Lists,
    seeker: impl Fn(usize) -> Seeker<D> + Sync,
    records: &Records<D>,
    consistency: Consistency,
    results: &mut [Option<Interpolated<D>>],
) {
    backend.sweep_in_double(lists, records, &Points(seeker), &consistency, results);
}

/// Points that look for gas.
struct Points<F>(F);

/// The gas at a distance.
struct Seen<V: Vectors, const D: usize> {
    separation: LaneVector<V, D>,
    kernel: Lane<V>,
}

impl<F: Fn(usize) -> Seeker<D> + Sync, const D: usize> Basis<D> for Points<F> {
    type Own<V: Vectors> = Target<V, D>;
    type Pair<V: Vectors> = Seen<V, D>;
    type Site<'a>
        = ()
    where
        Self: 'a;
    type Result = Option<Interpolated<D>>;

    #[inline(always)]
    fn load<V: Vectors>(
        &self,
        vectors: V,
        read: Read<'_, D, V::Number>,
        slot: impl Fn(usize) -> usize,
    ) -> Target<V, D> {
        let seeker = |l| (self.0)(slot(l));
        let half_h = |l| V::Number::rounded(seeker(l).half_h * read.per_length);
        Target::new(
            vectors,
            |l, k| read.place(seeker(l).position[k], k),
            Lane::gather(vectors, half_h),
            Lane::splat(vectors, 0.0),
        )
    }

    #[inline(always)]
    fn meet<V: Vectors>(
        &self,
        vectors: V,
        own: &Target<V, D>,
        read: Read<'_, D, V::Number>,
        j: usize,
    ) -> Seen<V, D> {
        let separation = Separation::new(vectors, own, &read.near[j]);
        Seen {
            separation: separation.vector,
            kernel: separation.kernel(vectors),
        }
    }

    fn rest(&self, _: usize, result: &mut Self::Result) {
        *result = None;
    }

    #[inline(always)]
    fn open(&self, _: usize, _: &mut Self::Result) {}

    #[inline(always)]
    fn close(&self, (): (), _: &mut Self::Result) {}
}

impl<F: Fn(usize) -> Seeker<D> + Sync, const D: usize> Law<Points<F>, D> for Consistency {
    type Own<V: Vectors> = ();
    /// As in [`Moments`].
    type Sums<V: Vectors> = (
        (Lane<V>, LaneVector<V, D>, [LaneVector<V, D>; D]),
        (LaneVector<V, D>, [LaneVector<V, D>; D]),
        ([Lane<V>; 3], [LaneVector<V, D>; 3]),
        [LaneVector<V, D>; D],
    );
    type Number = Moments<D>;

    #[inline(always)]
    fn load<V: Vectors>(
        &self,
        _: V,
        _: Read<'_, D, V::Number>,
        _: impl Fn(usize) -> usize + Copy,
    ) -> Self::Own<V> {
    }

    #[inline(always)]
    fn add<V: Vectors>(
        &self,
        _: (&Target<V, D>, &()),
        seen: &mut Seen<V, D>,
        j: Neighbour<'_, V, D>,
        sums: &mut Self::Sums<V>,
    ) {
        let (near, state) = (&j.read.near[j.slot], &j.read.state[j.slot]);
        let lane = |number| Lane::broadcast(j.vectors, number);
        let is_first_order = *self == Self::FirstOrder;
        let weight = if is_first_order {
            seen.kernel * lane(near.volume)
        } else {
            seen.kernel
        };
        let ((weights, first, second), (velocity_sum, velocities), (scalar_sums, scalars), strain) =
            sums;
        for a in 0..D {
            for b in a..D {
                strain[a][b] = weight.mul_add(lane(state.strain.get(a, b)), strain[a][b]);
            }
        }
        *weights += weight;
        // r_j - r = -r_ij.
        let arm: LaneVector<V, D> = each(|k| -(weight * seen.separation[k]));
        let velocity: LaneVector<V, D> = each(|k| lane(near.velocity[k]));
        let half_h = lane(near.half_h);
        let fields = [lane(state.pressure), lane(state.energy), half_h + half_h];
        for a in 0..D {
            first[a] += arm[a];
        }
        accumulate(velocity_sum, weight, &velocity);
        accumulate(scalar_sums, weight, &fields);
        if is_first_order {
            for a in 0..D {
                for b in 0..D {
                    second[a][b] += -(arm[a] * seen.separation[b]);
                    velocities[a][b] = arm[b].mul_add(velocity[a], velocities[a][b]);
                }
                for s in 0..3 {
                    scalars[s][a] = arm[a].mul_add(fields[s], scalars[s][a]);
                }
            }
        }
    }

    #[inline(always)]
    fn finish(
        &self,
        moments: Moments<D>,
        _: Moments<D>,
        (): &mut (),
        result: &mut Option<Interpolated<D>>,
    ) {
        *result = match self {
            Self::Shepard => shepard(&moments),
            Self::FirstOrder => first_order(&moments),
        };
    }
}

/// Sums over the gas with the weights `w = W V` for first order, `W` for Shepard: `sum w`, `sum w (r_j - r)` and `sum w (r_j - r) (x)
/// (r_j - r)`; of the velocity, `sum w f_j` and `sum w f_j (r_j - r)`; the same of pressure, energy and smoothing length; and `sum w
/// E_j`, on and above the diagonal.
type Moments<const D: usize> = (
    (f64, [f64; D], [[f64; D]; D]),
    ([f64; D], [[f64; D]; D]),
    ([f64; 3], [[f64; D]; 3]),
    [[f64; D]; D],
);

fn mean_strain<const D: usize>(((weight, ..), .., strain): &Moments<D>) -> Matrix<D> {
    Matrix::from_fn(|a, b| strain[a.min(b)][a.max(b)] / weight)
}

fn shepard<const D: usize>(moments: &Moments<D>) -> Option<Interpolated<D>> {
    let ((weight, first, _), (velocity, _), (scalars, _), _) = *moments;
    (weight > 0.0).then(|| Interpolated {
        velocity: Vector::from(velocity) / weight,
        strain: mean_strain(moments),
        pressure: scalars[0] / weight,
        energy: scalars[1] / weight,
        smoothing_length: scalars[2] / weight,
        centroid: Vector::from(first) / weight,
    })
}

/// Solves the moment equations for the corrected weights' coefficients `(a, b)`, with which
/// `f = sum_j f_j w_j (a + b.(r_j - r))` is exact for linear fields.
fn first_order<const D: usize>(moments: &Moments<D>) -> Option<Interpolated<D>> {
    let ((weight, first, second), (velocity_sum, velocities), (scalar_sums, scalars), _) = moments;
    if *weight < LEAST_SHARE {
        return None;
    }
    // Scaled by the mean second moment so that the matrix is of order one throughout; the
    // axes beyond D are padded with the identity.
    let mean = (0..D).map(|k| second[k][k]).sum::<f64>() / D as f64;
    let scale = (weight / mean).sqrt();
    let mut matrix = Matrix4::<f64>::identity();
    matrix[(0, 0)] = 1.0;
    for a in 0..D {
        matrix[(0, a + 1)] = first[a] * scale / weight;
        matrix[(a + 1, 0)] = matrix[(0, a + 1)];
        for b in 0..D {
            matrix[(a + 1, b + 1)] = second[a][b] * scale * scale / weight;
        }
    }
    let inverse = matrix.try_inverse()?;
    if 1.0 / (matrix.norm() * inverse.norm()) < LEAST_CONDITION {
        return None;
    }
    let coefficients: Vector4<f64> = inverse.column(0) / *weight;
    let slope = Vector::<D>::from_fn(|k, _| coefficients[k + 1] * scale);
    let value = |sum: f64, arm: [f64; D]| coefficients[0] * sum + slope.dot(&Vector::from(arm));
    let scalar = |s: usize| value(scalar_sums[s], scalars[s]);
    let interpolated = Interpolated {
        velocity: Vector::from_fn(|a, _| value(velocity_sum[a], velocities[a])),
        strain: mean_strain(moments),
        pressure: scalar(0),
        energy: scalar(1),
        smoothing_length: scalar(2),
        centroid: Vector::zeros(),
    };
    // As for the pressure, which may be less than nothing in a liquid: whoever knows the gas has to see.
    let sound = interpolated.energy > 0.0 && interpolated.smoothing_length > 0.0;
    sound.then_some(interpolated)
}
