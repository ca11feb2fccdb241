//! The two packed records of a particle, in whatever numbers.

use aero_geometry::Vector;
use nalgebra::{SMatrix, SVector, Scalar};

use super::gas::Gas;

/// A `D x D` matrix.
pub type Matrix<const D: usize> = SMatrix<f64, D, D>;

/// What records are made of: `f64`, or `f32` for what is done pair by pair.
pub trait Number: Scalar + Copy {
    /// A coordinate.
    type Place: Scalar + Copy;

    /// The nearest of these numbers.
    fn rounded(value: f64) -> Self;

    /// The nearest of these coordinates.
    fn place(value: f64) -> Self::Place;
}

/// Records in one kind of number.
#[derive(Clone, Copy, Debug)]
pub struct Read<'a, const D: usize, N: Number> {
    /// Geometry.
    pub near: &'a [Near<D, N>],
    /// State.
    pub state: &'a [State<D, N>],
    /// Shift of the gas, up to the first ghost.
    pub shift: &'a [SVector<N, D>],
    /// What flows by viscosity and conduction, of viscous gas.
    pub diffusive: &'a [Diffusive<D, N>],
    /// The inverse of what lengths are measured in.
    pub per_length: f64,
    /// From where places are measured.
    pub origin: Vector<D>,
}

impl<const D: usize, N: Number> Read<'_, D, N> {
    /// The coordinate `value` along `axis` as the records have it.
    #[inline(always)]
    pub fn place(&self, value: f64, axis: usize) -> N::Place {
        N::place((value - self.origin[axis]) * self.per_length)
    }
}

impl Number for f64 {
    type Place = Self;

    #[inline(always)]
    fn rounded(value: f64) -> Self {
        value
    }

    #[inline(always)]
    fn place(value: f64) -> Self {
        value
    }
}

/// Geometry and motion of a neighbour: enough for lists, summation density and renormalisation.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct Near<const D: usize, N: Number = f64> {
    /// Position.
    pub position: SVector<N::Place, D>,
    /// Half the smoothing length: two halves add to `h_ij`.
    pub half_h: N,
    /// Volume `V_j = m_j / rho_j`; a ghost's own, constant.
    pub volume: N,
    /// Mass; `rho V` for a ghost.
    pub mass: N,
    /// Half the density: two halves add to `rho_ij`.
    pub half_density: N,
    /// Velocity.
    pub velocity: SVector<N, D>,
}

/// State of a neighbour: what the rates need on top.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct State<const D: usize, N: Number = f64> {
    /// Half the speed of sound: two halves add to `c_ij`.
    pub half_sound: N,
    /// Specific internal energy.
    pub energy: N,
    /// Pressure.
    pub pressure: N,
    /// Half the density gradient.
    pub half_gradient: SVector<N, D>,
    /// Rate of strain.
    pub strain: Symmetric<D, N>,
    /// Slope of the energy that conduction leaves alone.
    pub energy_slope: SVector<N, D>,
    /// `V p L`.
    pub stress: Symmetric<D, N>,
}

/// Fluxes of a particle, and the gradients that they come from.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct Diffusive<const D: usize, N: Number = f64> {
    /// Half the gradient of the velocity, `du_a / dx_b`.
    pub half_gradient: SMatrix<N, D, D>,
    /// `V tau L`.
    pub stress: SMatrix<N, D, D>,
    /// Half the dynamic viscosity.
    pub half_viscosity: N,
    /// Half the gradient of the specific internal energy.
    pub half_slope: SVector<N, D>,
    /// `V kappa L grad e`, of the conductivity `kappa` by energy.
    pub flux: SVector<N, D>,
    /// Half of `kappa`.
    pub half_conductivity: N,
}

/// A symmetric `D x D` matrix without its lower triangle.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct Symmetric<const D: usize, N: Number = f64> {
    diagonal: SVector<N, D>,
    /// Above the diagonal, row by row: at most as many as on it.
    above: SVector<N, D>,
}

impl<const D: usize, N: Number> Symmetric<D, N> {
    /// Component `a, b`.
    #[inline(always)]
    pub fn get(&self, a: usize, b: usize) -> N {
        if a == b {
            self.diagonal[a]
        } else {
            self.above[a + b - 1]
        }
    }
}

impl<const D: usize> Symmetric<D> {
    /// The upper triangle of `matrix`.
    pub fn new(matrix: &Matrix<D>) -> Self {
        let mut above = Vector::zeros();
        for a in 0..D {
            for b in a + 1..D {
                above[a + b - 1] = matrix[(a, b)];
            }
        }
        Self {
            diagonal: matrix.diagonal(),
            above,
        }
    }

    /// All zero.
    pub fn zeros() -> Self {
        Self {
            diagonal: Vector::zeros(),
            above: Vector::zeros(),
        }
    }

    /// The mirror image where `sign` is -1 along the axes that turn round.
    pub fn reflected(mut self, sign: &Vector<D>) -> Self {
        for a in 0..D {
            for b in a + 1..D {
                self.above[a + b - 1] *= sign[a] * sign[b];
            }
        }
        self
    }

    /// `factor` times this, rounded.
    pub(super) fn rounded(&self, factor: f64) -> Symmetric<D, f32> {
        let round = |vector: &Vector<D>| vector.map(|x| (x * factor) as f32);
        Symmetric {
            diagonal: round(&self.diagonal),
            above: round(&self.above),
        }
    }
}

impl<const D: usize> Near<D> {
    /// Smoothing length.
    pub fn smoothing_length(&self) -> f64 {
        2.0 * self.half_h
    }

    /// Density.
    pub fn density(&self) -> f64 {
        2.0 * self.half_density
    }
}

impl<const D: usize> State<D> {
    /// State without gradients; they follow from the renormalisation pass.
    pub fn new(pressure: f64, density: f64, energy: f64, gas: &Gas) -> Self {
        Self {
            half_sound: 0.5 * gas.sound_speed_at(density, pressure),
            energy,
            pressure,
            half_gradient: Vector::zeros(),
            strain: Symmetric::zeros(),
            energy_slope: Vector::zeros(),
            stress: Symmetric::zeros(),
        }
    }

    /// Sets the density gradient and the stress that follows from the renormalisation `matrix`.
    pub fn renormalise(&mut self, matrix: &Matrix<D>, gradient: &Vector<D>, volume: f64) {
        self.half_gradient = 0.5 * gradient;
        self.stress = Symmetric::new(&(matrix * (volume * self.pressure)));
    }
}
