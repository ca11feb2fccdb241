//! The particles while they are being arranged.

use aero_geometry::Vector;

/// How a particle may move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Lock {
    /// Wherever its neighbours push it.
    Free,
    /// Along a level of the signed distance.
    Level(f64),
    /// Not at all.
    Frozen,
}

/// Particles of the packed part of space (above all mirror planes); arrays of equal length.
#[derive(Clone, Debug, Default)]
pub(crate) struct Cloud<const D: usize> {
    /// Positions.
    pub position: Vec<Vector<D>>,
    /// Layer, counted from the wall.
    pub layer: Vec<u32>,
    /// How each may move.
    pub lock: Vec<Lock>,
    /// Volumes.
    pub volume: Vec<f64>,
}

impl<const D: usize> Cloud<D> {
    /// Adds one particle.
    pub fn push(&mut self, position: Vector<D>, layer: u32, lock: Lock, volume: f64) {
        self.position.push(position);
        self.layer.push(layer);
        self.lock.push(lock);
        self.volume.push(volume);
    }

    /// Number of particles.
    pub fn len(&self) -> usize {
        self.position.len()
    }
}
