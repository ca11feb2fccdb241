//! The records rounded to `f32`, for pair loops in mixed precision. State and rates of the particles stay `f64`.
//!
//! Lengths are measured in about a spacing, so that powers of them stay far from what `f32` cannot hold.

use std::ops::Range;

use aero_geometry::Vector;
use aero_geometry::parallel::prelude::*;
use nalgebra::SVector;

use super::record::{Near, Number, Read, State};
use crate::problem::Problem;

/// A coordinate as a whole number of lengths and the rest, at most half of one: differences are as good as those of
/// numbers of 48 bits, wherever in space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Split {
    /// A whole number.
    pub whole: f32,
    /// What is missing.
    pub rest: f32,
}

impl Split {
    fn new(place: f64) -> Self {
        let whole = place.round();
        Self {
            whole: whole as f32,
            rest: (place - whole) as f32,
        }
    }
}

/// The records in `f32`.
#[derive(Clone, Debug)]
pub struct Rounded<const D: usize> {
    /// Geometry.
    pub near: Vec<Near<D, f32>>,
    /// State.
    pub state: Vec<State<D, f32>>,
    /// Shift of the gas, renormalised.
    pub shift: Vec<SVector<f32, D>>,
    /// What lengths are measured in: a power of two, so that it rounds nothing.
    length: f64,
    /// From where places are measured.
    origin: Vector<D>,
    /// From which velocities are measured, so that a fast stream does not lose its differences.
    velocity: Vector<D>,
}

impl<const D: usize> Default for Rounded<D> {
    fn default() -> Self {
        Self {
            near: Vec::new(),
            state: Vec::new(),
            shift: Vec::new(),
            length: 1.0,
            origin: Vector::zeros(),
            velocity: Vector::zeros(),
        }
    }
}

impl Number for f32 {
    type Place = Split;

    #[inline(always)]
    fn rounded(value: f64) -> Self {
        value as Self
    }

    #[inline(always)]
    fn place(value: f64) -> Split {
        Split::new(value)
    }
}

impl<const D: usize> Rounded<D> {
    /// The records as pair loops read them.
    #[inline(always)]
    pub fn read(&self) -> Read<'_, D, f32> {
        let Rounded {
            near,
            state,
            shift,
            length,
            origin,
            ..
        } = self;
        Read {
            near,
            state,
            shift,
            // Its pass is in `f64`.
            diffusive: &[],
            per_length: 1.0 / length,
            origin: *origin,
        }
    }

    /// Records yet to be written, in lengths of about the spacing of `problem`.
    pub fn new(problem: &Problem<D>) -> Self {
        Self {
            length: problem.resolution.lattice().log2().floor().exp2(),
            origin: problem.domain.bounds.min,
            velocity: problem.free_stream.velocity,
            ..Self::default()
        }
    }

    /// Rounds the geometry.
    pub fn round_near(&mut self, near: &[Near<D>]) {
        let (per_length, per_volume) = (1.0 / self.length, self.length.powi(-(D as i32)));
        let (origin, velocity) = (self.origin, self.velocity);
        near.par_iter()
            .with_min_len(BLOCK)
            .map(|near| Near {
                position: (near.position - origin).map(|x| Split::new(x * per_length)),
                half_h: (near.half_h * per_length) as f32,
                volume: (near.volume * per_volume) as f32,
                mass: (near.mass * per_volume) as f32,
                half_density: near.half_density as f32,
                velocity: (near.velocity - velocity).map(|u| u as f32),
            })
            .collect_into_vec(&mut self.near);
    }

    /// Rounds the state.
    pub fn round_state(&mut self, state: &[State<D>]) {
        let length = self.length;
        state
            .par_iter()
            .with_min_len(BLOCK)
            .map(|state| rounded(state, length))
            .collect_into_vec(&mut self.state);
    }

    /// Rounds the state in these slots alone, where the others are not asked for.
    pub fn round_state_in(&mut self, slots: Range<usize>, state: &[State<D>]) {
        if self.state.len() != state.len() {
            return self.round_state(state);
        }
        let length = self.length;
        self.state[slots.clone()]
            .par_iter_mut()
            .zip(&state[slots])
            .for_each(|(own, state)| *own = rounded(state, length));
    }

    /// Rounds the shifts, which are velocities.
    pub fn round_shift(&mut self, shift: &[Vector<D>]) {
        self.shift.clear();
        self.shift
            .extend(shift.iter().map(|shift| shift.map(|u| u as f32)));
    }
}

/// A state in lengths of this size.
fn rounded<const D: usize>(state: &State<D>, length: f64) -> State<D, f32> {
    State {
        half_sound: state.half_sound as f32,
        energy: state.energy as f32,
        pressure: state.pressure as f32,
        half_gradient: state.half_gradient.map(|x| (x * length) as f32),
        strain: state.strain.rounded(length),
        energy_slope: state.energy_slope.map(|x| (x * length) as f32),
        stress: state.stress.rounded(length.powi(-(D as i32))),
    }
}

/// Records that a task rounds at once.
const BLOCK: usize = 1024;
