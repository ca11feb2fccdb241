//! Sets of particles that can be neighbours.

use std::ops::Range;

use aero_geometry::{Bounds, Pencils, Vector};

use super::rough::{LOSS, Rough};

/// A set of particles that can be neighbours.
#[derive(Clone, Copy, Debug)]
pub struct Candidates<'a, const D: usize> {
    pub(super) pencils: &'a Pencils<D>,
    /// First slot in the records.
    pub(super) first: usize,
    pub(super) rough: &'a Rough<D>,
    /// How far any of them sees, half of the support.
    pub(super) furthest: f64,
    velocity: Bounds<D>,
    /// Ghosts, listed after the gas.
    wall: bool,
}

impl<'a, const D: usize> Candidates<'a, D> {
    /// The gas at `slots`, sorted by `pencils`.
    pub fn gas(pencils: &'a Pencils<D>, rough: &'a Rough<D>, slots: Range<usize>) -> Self {
        Self::new(pencils, rough, slots, false)
    }

    /// The ghosts at `slots`, sorted by `pencils`.
    pub fn ghosts(pencils: &'a Pencils<D>, rough: &'a Rough<D>, slots: Range<usize>) -> Self {
        Self::new(pencils, rough, slots, true)
    }

    fn new(pencils: &'a Pencils<D>, rough: &'a Rough<D>, slots: Range<usize>, wall: bool) -> Self {
        let extent = rough.extent(slots.clone());
        Self {
            pencils,
            first: slots.start,
            rough,
            furthest: f64::from(extent.sight) * (1.0 + LOSS),
            velocity: Bounds::new(
                Vector::from_fn(|k, _| f64::from(extent.slowest[k])),
                Vector::from_fn(|k, _| f64::from(extent.fastest[k])),
            ),
            wall,
        }
    }

    /// The same particles, which are ghosts.
    pub fn of_ghosts(self) -> Self {
        Self { wall: true, ..self }
    }

    /// True of ghosts.
    pub fn is_wall(&self) -> bool {
        self.wall
    }

    /// Upper bound, but for what single precision loses, of the speed of any member relative to `velocity`.
    pub(super) fn fastest_relative_to(&self, velocity: &Vector<D>) -> f64 {
        let below = (velocity - self.velocity.min).abs();
        let above = (self.velocity.max - velocity).abs();
        below.sup(&above).norm()
    }
}
