//! Renormalisation of the kernel's gradient, the density gradient and, where particles are shifted, the
//! gradient of their concentration.

use aero_geometry::Vector;
use rayon::prelude::*;

use super::super::lanes::Lane;
use super::super::neighbours::{Chunk, Lists};
use super::super::records::{Matrix, Near, Number, Read, Records};
use super::super::vectors::{Arch, Pass, Vectors};
use super::super::walls::even_renormalisation;
use super::concentration::repulsion;
use super::{LaneVector, Pair, Target, unlane, zeros};

/// Below this determinant, relative to that of a ball of the same trace, the neighbours lie too
/// nearly in a plane for the matrix to mean anything.
const SINGULAR: f64 = 0.1;

/// The mean moment of a full neighbourhood is one, at a free edge a half. Below this a particle has
/// hardly any neighbours, and the inverse would multiply their noise.
const SPARSE: f64 = 0.4;

/// Where the mean moment is less, the particle stands at a free edge and its concentration says nothing about
/// order (Lee et al. 2008: `div r < 1.5` in the plane, of 2 inside).
const SURROUNDED: f64 = 0.75;

/// Renormalisation matrix `L_i = [sum_j V_j (r_j - r_i) (x) grad_i W_ij]^-1` over gas and ghosts
/// [Villodi & Ramachandran 2024, eq. 7; Randles & Libersky 1996], and the density gradient
/// `L_i sum_j V_j (rho_j - rho_i) grad_i W_ij` [eq. 8]. The identity where neighbours are too few.
#[derive(Clone, Copy, Debug)]
pub struct Renormalisation<const D: usize> {
    /// `L_i`.
    pub matrix: Matrix<D>,
    /// Density gradient.
    pub density_gradient: Vector<D>,
    /// Gradient of the particles' concentration, which vanishes where they stand evenly; summed where
    /// particles are shifted only, and zero at free edges.
    pub concentration_gradient: Vector<D>,
    /// What ghosts add to it: it points into the wall.
    pub wall_gradient: Vector<D>,
}

impl<const D: usize> Default for Renormalisation<D> {
    fn default() -> Self {
        Self {
            matrix: Matrix::identity(),
            density_gradient: Vector::zeros(),
            concentration_gradient: Vector::zeros(),
            wall_gradient: Vector::zeros(),
        }
    }
}

/// The gradients to sum beside the matrix; the others are left zero.
#[derive(Clone, Copy, Debug)]
pub struct Gradients {
    /// Of the density, which the published scheme evolves.
    pub of_density: bool,
    /// Of the concentration, by which particles are shifted.
    pub of_concentration: bool,
}

/// Renormalises every listed particle.
pub fn renormalise<const D: usize>(
    arch: Arch,
    lists: &Lists,
    records: &Records<D>,
    gradients: Gradients,
    results: &mut [Renormalisation<D>],
) {
    let even = even_renormalisation();
    lists
        .chunks
        .par_iter()
        .zip(results.par_chunks_mut(lists.chunk_targets()))
        .for_each(|(chunk, results)| {
            arch.dispatch(Renormalise {
                chunk,
                records,
                even,
                gradients,
                results,
            });
        });
}

struct Renormalise<'a, const D: usize> {
    chunk: &'a Chunk,
    records: &'a Records<D>,
    /// That of a lattice.
    even: Matrix<D>,
    gradients: Gradients,
    results: &'a mut [Renormalisation<D>],
}

/// Running sums, one per lane.
struct Sums<V: Vectors, const D: usize> {
    /// On and above the diagonal.
    moments: [LaneVector<V, D>; D],
    slope: LaneVector<V, D>,
    concentration: LaneVector<V, D>,
}

impl<V: Vectors, const D: usize> Sums<V, D> {
    #[inline(always)]
    fn new(vectors: V) -> Self {
        Self {
            moments: [zeros(vectors); D],
            slope: zeros(vectors),
            concentration: zeros(vectors),
        }
    }

    #[inline(always)]
    fn add(
        &mut self,
        vectors: V,
        gradients: Gradients,
        target: &Target<V, D>,
        j: &Near<D, V::Number>,
    ) {
        let pair = Pair::new(vectors, target, j);
        let weight = pair.gradient_factor * Lane::splat(vectors, j.volume);
        if gradients.of_density {
            let difference = Lane::splat(vectors, j.half_density) - target.half_density;
            let rise = weight * difference;
            for a in 0..D {
                self.slope[a] = rise.mul_add(pair.separation[a], self.slope[a]);
            }
        }
        for a in 0..D {
            let column = weight * pair.separation[a];
            for b in a..D {
                self.moments[a][b] = column.mul_add(pair.separation[b], self.moments[a][b]);
            }
        }
        if gradients.of_concentration {
            let weight = weight * repulsion(vectors, &pair);
            for a in 0..D {
                self.concentration[a] = weight.mul_add(pair.separation[a], self.concentration[a]);
            }
        }
    }
}

impl<const D: usize> Pass for Renormalise<'_, D> {
    type Output = ();

    #[inline(always)]
    fn run<V: Vectors>(self, vectors: V) {
        let Read {
            near, per_length, ..
        } = V::Number::of(self.records);
        let mut results = self.results.iter_mut();
        for cluster in &self.chunk.clusters {
            if cluster.is_calm {
                for result in results.by_ref().take(cluster.targets.len()) {
                    *result = Renormalisation {
                        matrix: self.even,
                        ..Renormalisation::default()
                    };
                }
                continue;
            }
            let (first, last) = (cluster.targets.start, cluster.targets.end - 1);
            let target = Target::load(vectors, |l| &near[(first + l).min(last)]);
            let mut sums = Sums::new(vectors);
            for &j in &self.chunk.entries[cluster.gas.clone()] {
                sums.add(vectors, self.gradients, &target, &near[j as usize]);
            }
            let by_gas = sums.concentration;
            for &j in &self.chunk.entries[cluster.wall.clone()] {
                sums.add(vectors, self.gradients, &target, &near[j as usize]);
            }
            let moments = sums.moments.map(|row| row.map(Lane::to_array));
            let per_length = Lane::splat(vectors, per_length);
            let slope = sums.slope.map(|sum| (sum * per_length).to_array());
            let concentration = sums.concentration.map(|sum| (sum * per_length).to_array());
            let by_gas = by_gas.map(|sum| (sum * per_length).to_array());
            for (l, result) in results.by_ref().take(cluster.targets.len()).enumerate() {
                let matrix = Matrix::<D>::from_fn(|a, b| -moments[a.min(b)][a.max(b)][l]);
                result.matrix = inverse(&matrix);
                result.density_gradient = result.matrix * unlane(&slope, l) * 2.0;
                if self.gradients.of_concentration && matrix.trace() > SURROUNDED * D as f64 {
                    result.concentration_gradient = unlane(&concentration, l);
                    result.wall_gradient = result.concentration_gradient - unlane(&by_gas, l);
                } else {
                    result.concentration_gradient = Vector::zeros();
                    result.wall_gradient = Vector::zeros();
                }
            }
        }
    }
}

/// Inverse of a symmetric moment matrix, the identity where neighbours are few or nearly in a plane.
fn inverse<const D: usize>(matrix: &Matrix<D>) -> Matrix<D> {
    let mean = matrix.trace() / D as f64;
    let (determinant, adjugate) = adjugate(matrix);
    if mean > SPARSE && determinant > SINGULAR * mean.powi(D as i32) {
        adjugate / determinant
    } else {
        Matrix::identity()
    }
}

/// Determinant and adjugate of a 1 x 1, 2 x 2 or 3 x 3 matrix.
fn adjugate<const D: usize>(m: &Matrix<D>) -> (f64, Matrix<D>) {
    match D {
        1 => (m[(0, 0)], Matrix::identity()),
        2 => {
            let adjugate = Matrix::from_fn(|a, b| match (a, b) {
                (0, 0) => m[(1, 1)],
                (1, 1) => m[(0, 0)],
                _ => -m[(a, b)],
            });
            (m[(0, 0)] * m[(1, 1)] - m[(0, 1)] * m[(1, 0)], adjugate)
        }
        _ => {
            // Cofactor of the transposed place: rows and columns taken cyclically carry the sign.
            let adjugate = Matrix::from_fn(|a, b| {
                let (p, q) = ((b + 1) % 3, (b + 2) % 3);
                let (r, s) = ((a + 1) % 3, (a + 2) % 3);
                m[(p, r)] * m[(q, s)] - m[(p, s)] * m[(q, r)]
            });
            let determinant = (0..3).map(|k| m[(0, k)] * adjugate[(k, 0)]).sum();
            (determinant, adjugate)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_inverse_undoes_the_matrix_in_every_dimension() {
        let one = Matrix::<1>::new(0.7);
        assert!((one * inverse(&one) - Matrix::<1>::identity()).norm() < 1e-14);
        let two = Matrix::<2>::new(1.1, 0.2, 0.2, 0.9);
        assert!((two * inverse(&two) - Matrix::<2>::identity()).norm() < 1e-14);
        let three = Matrix::<3>::new(1.1, 0.2, -0.1, 0.2, 0.9, 0.3, -0.1, 0.3, 1.2);
        assert!((three * inverse(&three) - Matrix::<3>::identity()).norm() < 1e-14);
    }

    #[test]
    fn a_sparse_neighbourhood_falls_back_to_the_identity() {
        assert_eq!(
            inverse(&(Matrix::<3>::identity() * 0.05)),
            Matrix::<3>::identity()
        );
    }

    #[test]
    fn a_flat_neighbourhood_falls_back_to_the_identity() {
        let flat = Matrix::<2>::new(1.0, 0.0, 0.0, 1e-9);
        assert_eq!(inverse(&flat), Matrix::<2>::identity());
    }
}
