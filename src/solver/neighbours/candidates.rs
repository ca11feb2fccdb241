//! Sets of particles that can be neighbours.

use std::ops::Range;

use aero_geometry::{Bounds, Pencils, Vector};

use crate::solver::records::{GHOSTS, Near, Records};

/// A set of particles that can be neighbours.
#[derive(Clone, Copy, Debug)]
pub struct Candidates<'a, const D: usize> {
    pub(super) pencils: &'a Pencils<D>,
    /// First slot in the records.
    pub(super) first: usize,
    pub(super) near: &'a [Near<D>],
    pub(super) half_h_max: f64,
    velocity: Bounds<D>,
    /// Ghosts, listed after the gas.
    wall: bool,
}

impl<'a, const D: usize> Candidates<'a, D> {
    /// The particles of one segment of `records`, sorted by `pencils`.
    pub fn new(pencils: &'a Pencils<D>, records: &'a Records<D>, segment: usize) -> Self {
        Self::over(
            pencils,
            records,
            records.segment(segment),
            segment >= GHOSTS,
        )
    }

    /// The ghosts at `slots`, sorted by `pencils`.
    pub fn ghosts(pencils: &'a Pencils<D>, records: &'a Records<D>, slots: Range<usize>) -> Self {
        Self::over(pencils, records, slots, true)
    }

    fn over(
        pencils: &'a Pencils<D>,
        records: &'a Records<D>,
        slots: Range<usize>,
        wall: bool,
    ) -> Self {
        let near = &records.near[slots.clone()];
        let nowhere = Vector::<D>::repeat(f64::INFINITY);
        let mut velocity = Bounds::new(nowhere, -nowhere);
        for near in near {
            velocity.min = velocity.min.inf(&near.velocity);
            velocity.max = velocity.max.sup(&near.velocity);
        }
        let half_h_max = near
            .iter()
            .fold(0.0, |most: f64, near| most.max(near.half_h));
        Self {
            pencils,
            first: slots.start,
            near,
            half_h_max,
            velocity,
            wall,
        }
    }

    /// True of ghosts.
    pub fn is_wall(&self) -> bool {
        self.wall
    }

    /// Upper bound of the speed of any member relative to `velocity`.
    pub(super) fn fastest_relative_to(&self, velocity: &Vector<D>) -> f64 {
        let below = (velocity - self.velocity.min).abs();
        let above = (self.velocity.max - velocity).abs();
        below.sup(&above).norm()
    }
}
