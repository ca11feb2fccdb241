//! State of the gas at ghosts, or at their mirror points.

use aero_geometry::Vector;
use nalgebra::{Matrix4, Vector4};
use pulp::{Simd, WithSimd};
use rayon::prelude::*;

use super::super::lanes::Lane;
use super::super::neighbours::{Chunk, Lists, Seeker};
use super::super::records::{Matrix, Records};
use super::super::vectors::{Arch, Double, MAX_LANES, Vectors};
use super::{LaneVector, Separation, Target, kernel_value, unlane, zeros};

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
    arch: Arch,
    lists: &Lists,
    seeker: impl Fn(usize) -> Seeker<D> + Sync,
    records: &Records<D>,
    consistency: Consistency,
    results: &mut [Option<Interpolated<D>>],
) {
    lists
        .chunks
        .par_iter()
        .zip(results.par_chunks_mut(lists.chunk_targets()))
        .for_each(|(chunk, results)| {
            arch.instructions.dispatch(Pass {
                chunk,
                seeker: &seeker,
                records,
                consistency,
                results,
            });
        });
}

struct Pass<'a, F, const D: usize> {
    chunk: &'a Chunk,
    seeker: &'a F,
    records: &'a Records<D>,
    consistency: Consistency,
    results: &'a mut [Option<Interpolated<D>>],
}

/// Moments of the fields, one per lane.
struct Moments<V: Vectors, const D: usize> {
    /// `sum w`, `w = W V` for first order, `W` for Shepard.
    weight: Lane<V>,
    /// `sum w (r_j - r)`.
    first: LaneVector<V, D>,
    /// `sum w (r_j - r) (x) (r_j - r)`.
    second: [LaneVector<V, D>; D],
    /// Velocity, pressure, energy and smoothing length: `sum w f_j` and `sum w f_j (r_j - r)`.
    velocity: [LaneVector<V, D>; D],
    velocity_sum: LaneVector<V, D>,
    scalars: [LaneVector<V, D>; 3],
    scalar_sums: [Lane<V>; 3],
    /// `sum w E_j`, on and above the diagonal.
    strain: [LaneVector<V, D>; D],
}

impl<F: Fn(usize) -> Seeker<D>, const D: usize> WithSimd for Pass<'_, F, D> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let vectors = Double(simd);
        let first_order = self.consistency == Consistency::FirstOrder;
        let mut results = self.results.iter_mut();
        for cluster in &self.chunk.clusters {
            let neighbours = &self.chunk.entries[cluster.gas.clone()];
            if neighbours.is_empty() {
                results
                    .by_ref()
                    .take(cluster.targets.len())
                    .for_each(|result| *result = None);
                continue;
            }
            let seekers: [Seeker<D>; MAX_LANES] = std::array::from_fn(|l| {
                (self.seeker)((cluster.targets.start + l).min(cluster.targets.end - 1))
            });
            let target = Target::new(
                vectors,
                |l, k| seekers[l].position[k],
                Lane::gather(vectors, |l| seekers[l].half_h),
                Lane::splat(vectors, 0.0),
            );
            let zero = Lane::splat(vectors, 0.0);
            let mut moments = Moments::<Double<S>, D> {
                weight: zero,
                first: zeros(vectors),
                second: [zeros(vectors); D],
                velocity: [zeros(vectors); D],
                velocity_sum: zeros(vectors),
                scalars: [zeros(vectors); 3],
                scalar_sums: [zero; 3],
                strain: [zeros(vectors); D],
            };
            for &j in neighbours {
                let near = &self.records.near[j as usize];
                let state = &self.records.state[j as usize];
                let separation = Separation::new(vectors, &target, near);
                let roots = separation.squared.roots(separation.h);
                let mut weight =
                    kernel_value::<Double<S>, D>(vectors, roots.root, roots.inverse_other);
                if first_order {
                    weight = weight * Lane::splat(vectors, near.volume);
                }
                let scalars = [state.pressure, state.energy, near.smoothing_length()];
                for a in 0..D {
                    for b in a..D {
                        let strain = Lane::splat(vectors, state.strain.get(a, b));
                        moments.strain[a][b] = weight.mul_add(strain, moments.strain[a][b]);
                    }
                }
                moments.add(
                    vectors,
                    weight,
                    &separation.vector,
                    &near.velocity,
                    scalars,
                    first_order,
                );
            }
            let numbers = Numbers::from(&moments);
            for (l, result) in results.by_ref().take(cluster.targets.len()).enumerate() {
                *result = if first_order {
                    numbers.first_order(l)
                } else {
                    numbers.shepard(l)
                };
            }
        }
    }
}

impl<V: Vectors, const D: usize> Moments<V, D> {
    #[inline(always)]
    fn add(
        &mut self,
        vectors: V,
        weight: Lane<V>,
        separation: &LaneVector<V, D>,
        velocity: &Vector<D>,
        scalars: [f64; 3],
        first_order: bool,
    ) {
        self.weight += weight;
        // r_j - r = -r_ij.
        let arm: LaneVector<V, D> = std::array::from_fn(|k| -(weight * separation[k]));
        let velocity: LaneVector<V, D> = std::array::from_fn(|k| Lane::splat(vectors, velocity[k]));
        let scalars = scalars.map(|scalar| Lane::splat(vectors, scalar));
        for a in 0..D {
            self.first[a] += arm[a];
            self.velocity_sum[a] = weight.mul_add(velocity[a], self.velocity_sum[a]);
        }
        for s in 0..3 {
            self.scalar_sums[s] = weight.mul_add(scalars[s], self.scalar_sums[s]);
        }
        if first_order {
            for a in 0..D {
                for b in 0..D {
                    self.second[a][b] += -(arm[a] * separation[b]);
                    self.velocity[a][b] = arm[b].mul_add(velocity[a], self.velocity[a][b]);
                }
                for s in 0..3 {
                    self.scalars[s][a] = arm[a].mul_add(scalars[s], self.scalars[s][a]);
                }
            }
        }
    }
}

type Lanes = [f64; MAX_LANES];

/// The moments as numbers.
struct Numbers<const D: usize> {
    weight: Lanes,
    first: [Lanes; D],
    second: [[Lanes; D]; D],
    velocity: [[Lanes; D]; D],
    velocity_sum: [Lanes; D],
    scalars: [[Lanes; D]; 3],
    scalar_sums: [Lanes; 3],
    strain: [[Lanes; D]; D],
}

impl<const D: usize> Numbers<D> {
    #[inline(always)]
    fn from<V: Vectors>(moments: &Moments<V, D>) -> Self {
        Self {
            weight: moments.weight.to_array(),
            first: moments.first.map(Lane::to_array),
            second: moments.second.map(|row| row.map(Lane::to_array)),
            velocity: moments.velocity.map(|row| row.map(Lane::to_array)),
            velocity_sum: moments.velocity_sum.map(Lane::to_array),
            scalars: moments.scalars.map(|row| row.map(Lane::to_array)),
            scalar_sums: moments.scalar_sums.map(Lane::to_array),
            strain: moments.strain.map(|row| row.map(Lane::to_array)),
        }
    }

    fn strain(&self, l: usize) -> Matrix<D> {
        Matrix::from_fn(|a, b| self.strain[a.min(b)][a.max(b)][l] / self.weight[l])
    }

    fn shepard(&self, l: usize) -> Option<Interpolated<D>> {
        let weight = self.weight[l];
        (weight > 0.0).then(|| Interpolated {
            velocity: unlane(&self.velocity_sum, l) / weight,
            strain: self.strain(l),
            pressure: self.scalar_sums[0][l] / weight,
            energy: self.scalar_sums[1][l] / weight,
            smoothing_length: self.scalar_sums[2][l] / weight,
            centroid: unlane(&self.first, l) / weight,
        })
    }

    /// Solves the moment equations for the corrected weights' coefficients `(a, b)`, with which
    /// `f = sum_j f_j w_j (a + b.(r_j - r))` is exact for linear fields.
    fn first_order(&self, l: usize) -> Option<Interpolated<D>> {
        if self.weight[l] < LEAST_SHARE {
            return None;
        }
        // Scaled by the mean second moment so that the matrix is of order one throughout; the
        // axes beyond D are padded with the identity.
        let mean = (0..D).map(|k| self.second[k][k][l]).sum::<f64>() / D as f64;
        let scale = (self.weight[l] / mean).sqrt();
        let mut matrix = Matrix4::<f64>::identity();
        matrix[(0, 0)] = 1.0;
        for a in 0..D {
            matrix[(0, a + 1)] = self.first[a][l] * scale / self.weight[l];
            matrix[(a + 1, 0)] = matrix[(0, a + 1)];
            for b in 0..D {
                matrix[(a + 1, b + 1)] = self.second[a][b][l] * scale * scale / self.weight[l];
            }
        }
        let inverse = matrix.try_inverse()?;
        if 1.0 / (matrix.norm() * inverse.norm()) < LEAST_CONDITION {
            return None;
        }
        let coefficients: Vector4<f64> = inverse.column(0) / self.weight[l];
        let slope = Vector::<D>::from_fn(|k, _| coefficients[k + 1] * scale);
        let value = |sum: f64, arm: Vector<D>| coefficients[0] * sum + slope.dot(&arm);
        let scalar = |s: usize| value(self.scalar_sums[s][l], unlane(&self.scalars[s], l));
        let interpolated = Interpolated {
            velocity: Vector::from_fn(|a, _| {
                value(self.velocity_sum[a][l], unlane(&self.velocity[a], l))
            }),
            strain: self.strain(l),
            pressure: scalar(0),
            energy: scalar(1),
            smoothing_length: scalar(2),
            centroid: Vector::zeros(),
        };
        // Across a strong shock a linear fit may undershoot to what no gas can be.
        let sound = interpolated.pressure > 0.0
            && interpolated.energy > 0.0
            && interpolated.smoothing_length > 0.0;
        sound.then_some(interpolated)
    }
}
