//! What the pair loops read of a neighbour: two packed records per particle, in slot order:
//! `[fluid | open | flow images | ghosts | ghost images]`.

use aero_geometry::Vector;
use nalgebra::SMatrix;

/// A `D x D` matrix.
pub type Matrix<const D: usize> = SMatrix<f64, D, D>;

/// Geometry and motion of a neighbour: enough for lists, summation density and renormalisation.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct Near<const D: usize> {
    /// Position.
    pub position: Vector<D>,
    /// Half the smoothing length: two halves add to `h_ij`.
    pub half_h: f64,
    /// Volume `V_j = m_j / rho_j`; a ghost's own, constant.
    pub volume: f64,
    /// Mass; `rho V` for a ghost.
    pub mass: f64,
    /// Half the density: two halves add to `rho_ij`.
    pub half_density: f64,
    /// Velocity.
    pub velocity: Vector<D>,
}

/// State of a neighbour: what the rates need on top.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct State<const D: usize> {
    /// Half the speed of sound: two halves add to `c_ij`.
    pub half_sound: f64,
    /// Specific internal energy.
    pub energy: f64,
    /// Pressure.
    pub pressure: f64,
    /// Half the density gradient.
    pub half_gradient: Vector<D>,
    /// Rate of strain.
    pub strain: Symmetric<D>,
    /// Slope of the energy that conduction leaves alone.
    pub energy_slope: Vector<D>,
    /// `V p L`.
    pub stress: Symmetric<D>,
}

/// A symmetric `D x D` matrix without its lower triangle.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct Symmetric<const D: usize> {
    diagonal: Vector<D>,
    /// Above the diagonal, row by row: at most as many as on it.
    above: Vector<D>,
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

    /// Component `a, b`.
    #[inline(always)]
    pub fn get(&self, a: usize, b: usize) -> f64 {
        if a == b {
            self.diagonal[a]
        } else {
            self.above[a + b - 1]
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
    pub fn new(pressure: f64, density: f64, energy: f64, gamma: f64) -> Self {
        Self {
            half_sound: 0.5 * (gamma * pressure / density).sqrt(),
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

/// Both records of all particles, and where each segment starts.
#[derive(Clone, Debug)]
pub struct Records<const D: usize> {
    /// Geometry.
    pub near: Vec<Near<D>>,
    /// State.
    pub state: Vec<State<D>>,
    /// Shift of the gas, renormalised, up to the first ghost; empty where particles are not shifted.
    pub shift: Vec<Vector<D>>,
    /// First slot of the segments fluid, open, flow images, ghosts, ghost images; then the end.
    pub start: [usize; 6],
}

impl<const D: usize> Default for Records<D> {
    fn default() -> Self {
        Self {
            near: Vec::new(),
            state: Vec::new(),
            shift: Vec::new(),
            start: [0; 6],
        }
    }
}

/// Number of the segment of the fluid.
pub const FLUID: usize = 0;
/// Number of the segment of open-boundary particles.
pub const OPEN: usize = 1;
/// Number of the segment of flow images.
pub const FLOW_IMAGES: usize = 2;
/// Number of the segment of ghosts.
pub const GHOSTS: usize = 3;
/// Number of the segment of ghost images.
pub const GHOST_IMAGES: usize = 4;

impl<const D: usize> Records<D> {
    /// Makes room for segments of these lengths.
    pub fn lay_out(&mut self, lengths: [usize; 5]) {
        for (k, length) in lengths.iter().enumerate() {
            self.start[k + 1] = self.start[k] + length;
        }
        let end = self.start[5];
        let near = Near {
            position: Vector::zeros(),
            half_h: 0.0,
            volume: 0.0,
            mass: 0.0,
            half_density: 0.0,
            velocity: Vector::zeros(),
        };
        self.near.resize(end, near);
        self.state.resize(end, State::new(0.0, 1.0, 0.0, 1.0));
    }

    /// Slots of one segment.
    pub fn segment(&self, segment: usize) -> std::ops::Range<usize> {
        self.start[segment]..self.start[segment + 1]
    }
}
