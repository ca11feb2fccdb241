//! The equations of an ideal gas, term by term.

use aero_geometry::Vector;
use aero_solver::problem::Added;

/// The terms of one equation: `unsteady + carried + pressed` is what it lacks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Share<T> {
    /// Derivative by time.
    pub unsteady: T,
    /// What the gas carries past.
    pub carried: T,
    /// What pressure or the divergence of the velocity does.
    pub pressed: T,
}

/// What viscosity and heat conduction do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rubbed<const D: usize> {
    /// `mu lap u / rho`, m/s^2.
    pub strained: Vector<D>,
    /// `mu grad div u / (3 rho)`, m/s^2.
    pub dilated: Vector<D>,
    /// `(grad u + grad u^T - 2/3 div u) grad mu / rho`, m/s^2.
    pub thickened: Vector<D>,
    /// `tau : grad u / rho`, J/(kg s).
    pub dissipated: f64,
    /// `div (k grad T) / rho`, J/(kg s).
    pub conducted: f64,
}

impl<const D: usize> Rubbed<D> {
    /// Of gas without viscosity.
    pub fn none() -> Self {
        Self {
            strained: Vector::zeros(),
            dilated: Vector::zeros(),
            thickened: Vector::zeros(),
            dissipated: 0.0,
            conducted: 0.0,
        }
    }
}

/// What the terms of the equations come to for a solution, at a place and time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Terms<const D: usize> {
    /// `rho_t`, `u.grad rho`, `rho div u`, kg/(m^3 s).
    pub density: Share<f64>,
    /// Sum of the sizes of the parts of `rho div u`, which may cancel.
    pub dilation: f64,
    /// `u_t`, `u.grad u`, `grad p / rho`, m/s^2.
    pub velocity: Share<Vector<D>>,
    /// `e_t`, `u.grad e`, `p div u / rho`, J/(kg s).
    pub energy: Share<f64>,
    /// What viscosity and heat conduction do.
    pub rubbed: Rubbed<D>,
}

impl<const D: usize> Terms<D> {
    /// The sources: `S_rho = rho_t + div(rho u)`, `S_u = u_t + u.grad u + grad p / rho`, `S_e = e_t + u.grad e + p div u / rho`, less
    /// what viscosity and heat conduction do.
    pub fn added(&self) -> Added<D> {
        let [density, heating] =
            [self.density, self.energy].map(|share| share.unsteady + share.carried + share.pressed);
        let Share {
            unsteady,
            carried,
            pressed,
        } = self.velocity;
        let Rubbed {
            strained,
            dilated,
            thickened,
            dissipated,
            conducted,
        } = self.rubbed;
        Added {
            density,
            acceleration: unsteady + carried + pressed - strained - dilated - thickened,
            heating: heating - dissipated - conducted,
        }
    }
}
