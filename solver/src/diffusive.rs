//! What the pass over diffusion reads of a neighbour, beside its geometry and state.

use aero_geometry::Vector;
use serde::{Deserialize, Serialize};

use crate::gas::TransportCoefficients;
use crate::record::{Diffusive, Matrix};

/// Gradients at a particle.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Gradients<const D: usize> {
    /// Of the velocity, `du_a / dx_b`.
    pub velocity: Matrix<D>,
    /// Of the specific internal energy.
    pub energy: Vector<D>,
}

impl<const D: usize> Gradients<D> {
    /// Those of an even stream.
    pub fn zeros() -> Self {
        Self {
            velocity: Matrix::zeros(),
            energy: Vector::zeros(),
        }
    }
}

impl<const D: usize> Diffusive<D> {
    /// Nothing flows.
    pub fn zeros() -> Self {
        Self {
            half_gradient: Matrix::zeros(),
            stress: Matrix::zeros(),
            half_viscosity: 0.0,
            half_slope: Vector::zeros(),
            flux: Vector::zeros(),
            half_conductivity: 0.0,
        }
    }

    /// That of a particle with the renormalisation `matrix` and these `coefficients`.
    pub fn new(
        gradients: &Gradients<D>,
        (volume, matrix): (f64, &Matrix<D>),
        coefficients: TransportCoefficients,
    ) -> Self {
        let TransportCoefficients {
            viscosity,
            conductivity,
        } = coefficients;
        let carried = matrix * volume;
        Self {
            half_gradient: gradients.velocity * 0.5,
            stress: stress(viscosity, &gradients.velocity) * carried,
            half_viscosity: 0.5 * viscosity,
            half_slope: gradients.energy * 0.5,
            flux: carried * gradients.energy * conductivity,
            half_conductivity: 0.5 * conductivity,
        }
    }

    /// Heat of friction per volume, `tau : grad u`, where the velocity has this gradient.
    pub fn friction(&self, gradient: &Matrix<D>) -> f64 {
        stress(2.0 * self.half_viscosity, gradient).dot(gradient)
    }

    /// The gradients.
    pub fn gradients(&self) -> Gradients<D> {
        Gradients {
            velocity: self.half_gradient * 2.0,
            energy: self.half_slope * 2.0,
        }
    }

    /// The mirror image where `sign` is -1 along the axes that turn round.
    #[must_use]
    pub fn reflected(&self, sign: &Vector<D>) -> Self {
        let tensor = |of: &Matrix<D>| Matrix::from_fn(|a, b| of[(a, b)] * sign[a] * sign[b]);
        Self {
            half_gradient: tensor(&self.half_gradient),
            stress: tensor(&self.stress),
            half_slope: sign.component_mul(&self.half_slope),
            flux: sign.component_mul(&self.flux),
            ..*self
        }
    }
}

/// `mu (grad u + grad u^T - 2/3 div u)` [Stokes 1845].
pub fn stress<const D: usize>(viscosity: f64, gradient: &Matrix<D>) -> Matrix<D> {
    let volume = Matrix::identity() * (gradient.trace() * 2.0 / 3.0);
    (gradient + gradient.transpose() - volume) * viscosity
}
