//! The particle method: takes a [`Case`], advances it step by step, hands out snapshots.

use crate::case::Case;
use crate::frame::{Frame, Load, SurfaceFrame, Totals};

/// A run in progress.
#[derive(Debug)]
pub struct Simulation<const D: usize> {
    case: Case<D>,
}

/// Why a run stopped before its end.
#[derive(Clone, Debug, thiserror::Error)]
#[error("{reason} (particle {particle} at {position:?}, step {step}, time {time})")]
pub struct Failure {
    /// What happened and what may help.
    pub reason: String,
    /// Number of the particle.
    pub particle: u64,
    /// Where it was.
    pub position: [f64; 3],
    /// Step.
    pub step: u64,
    /// Time.
    pub time: f64,
}

/// Counts and extremes since the start.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Statistics {
    /// Particles that move by the equations now.
    pub fluid: usize,
    /// Ghosts of bodies and walls.
    pub ghost: usize,
    /// Fluid particles advanced one full step, summed over all steps.
    pub particle_updates: u64,
    /// Mean number of neighbours within the support.
    pub neighbours_mean: f64,
    /// Fluid particles inside a body or behind a wall now.
    pub leaked: usize,
    /// Ghosts whose mirror was short of neighbours, at the last evaluation.
    pub mirror_fallbacks: usize,
    /// Smallest density met.
    pub min_density: f64,
    /// Smallest specific internal energy met.
    pub min_energy: f64,
}

impl<const D: usize> Simulation<D> {
    /// Sets up the particles of `case`.
    pub fn new(case: Case<D>) -> Result<Self, String> {
        Ok(Self { case })
    }

    /// The case that runs.
    pub fn case(&self) -> &Case<D> {
        &self.case
    }

    /// Advances by one time step, no further than `limit`; returns the step taken.
    pub fn step(&mut self, _limit: f64) -> Result<f64, Failure> {
        todo!()
    }

    /// Time reached.
    pub fn time(&self) -> f64 {
        todo!()
    }

    /// Steps taken.
    pub fn steps(&self) -> u64 {
        todo!()
    }

    /// All particles now.
    pub fn frame(&self) -> Frame {
        todo!()
    }

    /// State on the surfaces now.
    pub fn surface(&self) -> SurfaceFrame {
        todo!()
    }

    /// Loads on the bodies, in scene order; then on wall sides.
    pub fn loads(&self) -> Vec<Load> {
        todo!()
    }

    /// Conserved totals of the fluid now.
    pub fn totals(&self) -> Totals {
        todo!()
    }

    /// What entered minus what left through open boundaries, plus what walls gave (their
    /// impulse and work), since the start.
    pub fn inflow(&self) -> Totals {
        todo!()
    }

    /// Counts and extremes.
    pub fn statistics(&self) -> Statistics {
        todo!()
    }
}
