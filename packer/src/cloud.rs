//! The particles while they are being arranged.

use aero_geometry::Vector;

/// How a particle may move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Lock {
    /// Wherever its neighbours push it.
    Free,
    /// Wherever its neighbours push it on its side of the surface; for thin parts.
    Thin,
    /// Not at all: it stands in the middle of a thin part.
    Row,
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

    /// Keeps the particles whose position is `wanted`.
    pub fn retain(&mut self, mut wanted: impl FnMut(&Vector<D>) -> bool) {
        let all = std::mem::take(self);
        for n in (0..all.len()).filter(|&n| wanted(&all.position[n])) {
            self.push(all.position[n], all.layer[n], all.lock[n], all.volume[n]);
        }
    }

    /// Positions and volumes.
    pub fn particles(&self) -> impl Iterator<Item = (Vector<D>, f64)> {
        self.position
            .iter()
            .copied()
            .zip(self.volume.iter().copied())
    }

    /// Number of particles.
    pub fn len(&self) -> usize {
        self.position.len()
    }
}
