//! Single-precision copies of the records, for the search alone: a list may hold what is a hair too far away, because the
//! kernel is zero there, but never miss a neighbour.

use std::ops::Range;

use aero_geometry::Vector;
use aero_geometry::parallel::prelude::*;

use super::REACH;
use crate::each::each;
use crate::records::Near;

/// Records per block: as many as the widest vectors hold.
pub const BLOCK: usize = 16;

/// Bound of what single precision loses of a distance, over the numbers that it comes from.
pub const LOSS: f64 = 1.0 / (1 << 20) as f64;

/// Nothing is faster, not even where a run goes wrong: a sum of infinite velocities would be no number, and nobody's
/// neighbour.
const FASTEST: f32 = 1e18;

/// Records side by side.
#[derive(Clone, Copy, Debug)]
pub struct Block<const D: usize> {
    /// Positions relative to the origin, axis by axis.
    pub position: [[f32; BLOCK]; D],
    /// Velocities, axis by axis.
    pub velocity: [[f32; BLOCK]; D],
    /// How far the record sees, half of the support.
    pub sight: [f32; BLOCK],
}

/// Bounds of the records in a run of slots.
#[derive(Clone, Copy, Debug)]
pub struct Extent<const D: usize> {
    /// Smallest velocities, axis by axis.
    pub slowest: [f32; D],
    /// Largest velocities.
    pub fastest: [f32; D],
    /// The furthest sight.
    pub sight: f32,
}

/// Copies of all records, in slot order.
#[derive(Clone, Debug)]
pub struct Rough<const D: usize> {
    /// Where positions are counted from.
    pub origin: Vector<D>,
    /// The records; the last block may be filled in part.
    pub blocks: Vec<Block<D>>,
}

impl<const D: usize> Default for Rough<D> {
    fn default() -> Self {
        Self {
            origin: Vector::zeros(),
            blocks: Vec::new(),
        }
    }
}

impl<const D: usize> Rough<D> {
    /// Copies `records`, each of which moves at the velocity `motion(slot)`.
    pub fn copy(&mut self, records: &[Near<D>], motion: impl Fn(usize) -> Vector<D> + Sync) {
        if let Some(first) = records.first() {
            self.origin = first.position;
        }
        let origin = self.origin;
        let block = |(number, near): (usize, &[Near<D>])| {
            let mut block = Block {
                position: [[f32::INFINITY; BLOCK]; D],
                velocity: [[0.0; BLOCK]; D],
                sight: [0.0; BLOCK],
            };
            for (l, near) in near.iter().enumerate() {
                let velocity = motion(number * BLOCK + l);
                for k in 0..D {
                    block.position[k][l] = (near.position[k] - origin[k]) as f32;
                    block.velocity[k][l] = (velocity[k] as f32).clamp(-FASTEST, FASTEST);
                }
                block.sight[l] = (REACH * near.half_h) as f32;
            }
            block
        };
        let blocks = records.par_chunks(BLOCK).enumerate().map(block);
        blocks.collect_into_vec(&mut self.blocks);
    }
    /// What bounds the records at `slots`.
    pub fn extent(&self, slots: Range<usize>) -> Extent<D> {
        let nothing = Extent {
            slowest: [f32::INFINITY; D],
            fastest: [f32::NEG_INFINITY; D],
            sight: 0.0,
        };
        let extent = |number: usize| {
            let (first, block) = (number * BLOCK, &self.blocks[number]);
            let lanes = slots.start.max(first) - first..slots.end.min(first + BLOCK) - first;
            let (u, lanes) = (&block.velocity, || lanes.clone());
            Extent {
                slowest: each(|k| lanes().fold(f32::INFINITY, |least, l| least.min(u[k][l]))),
                fastest: each(|k| lanes().fold(f32::NEG_INFINITY, |most, l| most.max(u[k][l]))),
                sight: lanes().fold(0.0, |most, l| most.max(block.sight[l])),
            }
        };
        let either = |a: Extent<D>, b: Extent<D>| Extent {
            slowest: each(|k| a.slowest[k].min(b.slowest[k])),
            fastest: each(|k| a.fastest[k].max(b.fastest[k])),
            sight: a.sight.max(b.sight),
        };
        let blocks = slots.start / BLOCK..slots.end.div_ceil(BLOCK);
        blocks
            .into_par_iter()
            .map(extent)
            .reduce(|| nothing, either)
    }
}
