//! How wide a kernel may grow in rarefied gas, so that it never looks through the ghosts of a wall, past
//! the buffer of an open side or twice at the same particle.

use aero_geometry::Vector;
use aero_geometry::kernel::{SMOOTHING_RATIO, SUPPORT};
use rayon::prelude::*;

use super::Simulation;
use super::layers::GHOSTS;
use super::open::is_open;
use crate::problem::Side;

/// Largest smoothing length at a wall, relative to that of the starting lattice. A wider kernel would
/// look through the five layers of ghosts, and a lone particle in rarefied gas would no longer feel
/// the wall: at 1.5 the layers still hold 99 % of the kernel behind a wall.
const AT_WALLS: f64 = 1.5;

/// Layers of ghosts behind a wall, and what a buffer of an open side holds at least, in spacings.
pub const LAYERS: f64 = GHOSTS as f64;

/// Largest smoothing length anywhere, relative to that of the starting lattice, by dimension: every
/// search for neighbours reaches as far as the widest kernel.
const ANYWHERE: [f64; 3] = [1000.0, 4.0, 2.5];

impl<const D: usize> Simulation<D> {
    /// The largest smoothing length of each fluid particle, from this step's neighbour lists.
    ///
    /// A distance `d` in front of a wall the ghosts behind it fill a support of `d + 5 dx`.
    pub(super) fn widest(&self) -> Vec<f64> {
        let spacing = self.problem.spacing;
        let lattice = SMOOTHING_RATIO * spacing;
        let near = &self.records.near;
        let mut widest = vec![ANYWHERE[D - 1] * lattice; self.fluid.len()];
        self.lists
            .par_runs()
            .zip(widest.par_chunks_mut(self.lists.run_targets()))
            .for_each(|(run, widest)| {
                let first = run.clusters.first().map_or(0, |c| c.targets.start);
                for cluster in run.clusters {
                    let ghosts = &run.entries[cluster.wall.clone()];
                    for i in cluster.targets.clone() {
                        let own = &near[i].position;
                        let nearest = ghosts
                            .iter()
                            .map(|&j| (own - near[j as usize].position).norm_squared())
                            .fold(f64::INFINITY, f64::min)
                            .sqrt();
                        // The first layer lies half a spacing behind the wall.
                        let free = (nearest - 0.5 * spacing).min(self.room(own));
                        let fits = (free + LAYERS * spacing) / SUPPORT;
                        let widest = &mut widest[i - first];
                        *widest = widest.min(fits.max(AT_WALLS * lattice));
                    }
                }
            });
        widest
    }

    /// Distance to the nearest open side, and what keeps a kernel clear of its own image.
    fn room(&self, position: &Vector<D>) -> f64 {
        let mut room = self.open_side_distance(position);
        for axis in 0..D {
            if self.problem.domain.sides[axis][0] == Side::Periodic {
                let half = 0.5 * self.problem.domain.bounds.size()[axis];
                room = room.min((half - LAYERS * self.problem.spacing).max(0.0));
            }
        }
        room
    }

    /// Distance to the nearest open side, zero beyond it; infinite where there is none.
    pub(super) fn open_side_distance(&self, position: &Vector<D>) -> f64 {
        let bounds = &self.problem.domain.bounds;
        let mut distance = f64::INFINITY;
        for axis in 0..D {
            let [low, high] = self.problem.domain.sides[axis];
            if is_open(low) {
                distance = distance.min((position[axis] - bounds.min[axis]).max(0.0));
            }
            if is_open(high) {
                distance = distance.min((bounds.max[axis] - position[axis]).max(0.0));
            }
        }
        distance
    }
}
