//! Renormalisation of the kernel's gradient.

use aero_geometry::Vector;
use aero_geometry::kernel::SMOOTHING_RATIO;

use super::law::{Basis, Law, Neighbour};
use super::pair::{LaneVector, Pair, Target};
use crate::lanes::Lane;
use crate::lattice;
use crate::records::{Matrix, Read};
use crate::vectors::Vectors;

/// Below this determinant, relative to that of a ball of the same trace, the neighbours lie too
/// nearly in a plane for the matrix to mean anything.
const SINGULAR: f64 = 0.1;

/// The mean moment of a full neighbourhood is one, at a free edge a half. Below this a particle has
/// hardly any neighbours, and the inverse would multiply their noise.
const SPARSE: f64 = 0.4;

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

impl<const D: usize> Renormalisation<D> {
    /// What it is to those who do without: the density gradient is then [`Self::density_gradient`] as the kernel alone has it.
    pub fn leave_out(&mut self) {
        if let Some(inverse) = self.matrix.try_inverse() {
            self.density_gradient = inverse * self.density_gradient;
        }
        self.matrix = Matrix::identity();
    }
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

/// Renormalisation matrix of ghosts.
pub fn even_renormalisation<const D: usize>() -> Matrix<D> {
    Matrix::identity() * lattice::renormalisation::<D>(SMOOTHING_RATIO)
}

/// Where neighbours are, whatever their state.
pub struct Neighbourhoods<const D: usize> {
    /// Matrix of a lattice.
    even: Matrix<D>,
}

impl<const D: usize> Default for Neighbourhoods<D> {
    fn default() -> Self {
        Self {
            even: even_renormalisation(),
        }
    }
}

/// A pair, and how its gradient is weighed.
#[derive(Clone, Copy)]
pub struct Weighed<V: Vectors, const D: usize> {
    /// Its geometry.
    pub pair: Pair<V, D>,
    /// `V_j F`.
    pub weight: Lane<V>,
}

/// Mean moment of a neighbourhood, one where it is full: left by the [`Moments`].
#[derive(Clone, Copy, Debug, Default)]
pub struct Moment {
    /// Sum over the axes.
    pub trace: f64,
}

/// The moments `sum_j V_j (r_j - r_i) (x) grad_i W_ij` and their inverse.
#[derive(Clone, Copy, Debug)]
pub struct Moments;

impl<const D: usize> Basis<D> for Neighbourhoods<D> {
    type Own<V: Vectors> = Target<V, D>;
    type Pair<V: Vectors> = Weighed<V, D>;
    type Site<'a>
        = Moment
    where
        Self: 'a;
    type Result = Renormalisation<D>;

    #[inline(always)]
    fn load<V: Vectors>(
        &self,
        vectors: V,
        read: Read<'_, D, V::Number>,
        slot: impl Fn(usize) -> usize,
    ) -> Target<V, D> {
        Target::load(vectors, read, slot)
    }

    #[inline(always)]
    fn meet<V: Vectors>(
        &self,
        vectors: V,
        own: &Target<V, D>,
        read: Read<'_, D, V::Number>,
        j: usize,
    ) -> Weighed<V, D> {
        let near = &read.near[j];
        let pair = Pair::new(vectors, own, near);
        let weight = pair.gradient_factor * Lane::broadcast(vectors, near.volume);
        Weighed { pair, weight }
    }

    fn rest(&self, _: usize, result: &mut Renormalisation<D>) {
        *result = Renormalisation {
            matrix: self.even,
            ..Renormalisation::default()
        };
    }

    #[inline(always)]
    fn open(&self, _: usize, result: &mut Renormalisation<D>) -> Moment {
        // Field by field: a whole written first and then copied waits for its own bytes.
        let Renormalisation {
            matrix,
            density_gradient,
            concentration_gradient,
            wall_gradient,
        } = result;
        matrix.fill_with_identity();
        for vector in [density_gradient, concentration_gradient, wall_gradient] {
            vector.fill(0.0);
        }
        Moment::default()
    }

    #[inline(always)]
    fn close(&self, _: Moment, _: &mut Renormalisation<D>) {}
}

impl<const D: usize> Law<Neighbourhoods<D>, D> for Moments {
    type Own<V: Vectors> = ();
    /// On and above the diagonal.
    type Sums<V: Vectors> = [LaneVector<V, D>; D];
    type Number = [[f64; D]; D];

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
        met: &mut Weighed<V, D>,
        _: Neighbour<'_, V, D>,
        moments: &mut Self::Sums<V>,
    ) {
        let separation = &met.pair.separation;
        for a in 0..D {
            let column = met.weight * separation[a];
            for b in a..D {
                moments[a][b] = column.mul_add(separation[b], moments[a][b]);
            }
        }
    }

    /// They have no unit.
    #[inline(always)]
    fn in_metres<V: Vectors>(&self, moments: Self::Sums<V>, _: Lane<V>) -> Self::Sums<V> {
        moments
    }

    #[inline(always)]
    fn finish(
        &self,
        _: Self::Number,
        moments: Self::Number,
        site: &mut Moment,
        result: &mut Renormalisation<D>,
    ) {
        let matrix = Matrix::<D>::from_fn(|a, b| -moments[a.min(b)][a.max(b)]);
        site.trace = matrix.trace();
        result.matrix = inverse(&matrix);
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
