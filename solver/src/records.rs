//! What the pair loops read of a neighbour: two packed records per particle, in slot order:
//! `[fluid | open | flow images | ghosts | ghost images]`.

use aero_geometry::Vector;

pub use super::record::{Diffusive, Matrix, Near, Number, Read, State, Symmetric};
pub use super::rounding::Rounded;

/// Numbers that records are kept in.
pub trait Kept: Number {
    /// The records in these numbers.
    fn of<const D: usize>(records: &Records<D>) -> Read<'_, D, Self>;
}

impl Kept for f64 {
    #[inline(always)]
    fn of<const D: usize>(records: &Records<D>) -> Read<'_, D, Self> {
        Read {
            near: &records.near,
            state: &records.state,
            shift: &records.shift,
            diffusive: &records.diffusive,
            per_length: 1.0,
            origin: Vector::zeros(),
        }
    }
}

impl Kept for f32 {
    #[inline(always)]
    fn of<const D: usize>(records: &Records<D>) -> Read<'_, D, Self> {
        records.rounded.read()
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
    /// What flows by viscosity and conduction; empty where the gas has neither.
    pub diffusive: Vec<Diffusive<D>>,
    /// Share of the second gas in each; empty where there is one.
    pub second: Vec<f64>,
    /// There are two gases.
    pub are_two: bool,
    /// The gas has viscosity and conduction.
    pub is_viscous: bool,
    /// The same in `f32`, where pairs are computed so; empty elsewhere.
    pub rounded: Rounded<D>,
    /// First slot of the segments fluid, open, flow images, ghosts, ghost images; then the end.
    pub start: [usize; 6],
}

impl<const D: usize> Default for Records<D> {
    fn default() -> Self {
        Self {
            near: Vec::new(),
            state: Vec::new(),
            shift: Vec::new(),
            diffusive: Vec::new(),
            second: Vec::new(),
            are_two: false,
            is_viscous: false,
            rounded: Rounded::default(),
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
        let state = State {
            half_sound: 0.0,
            energy: 0.0,
            pressure: 0.0,
            half_gradient: Vector::zeros(),
            strain: Symmetric::zeros(),
            energy_slope: Vector::zeros(),
            stress: Symmetric::zeros(),
        };
        self.state.resize(end, state);
        if self.are_two {
            self.second.resize(end, 0.0);
        }
        if self.is_viscous {
            self.diffusive.resize(end, Diffusive::zeros());
        }
    }

    /// Slots of one segment.
    pub fn segment(&self, segment: usize) -> std::ops::Range<usize> {
        self.start[segment]..self.start[segment + 1]
    }
}
