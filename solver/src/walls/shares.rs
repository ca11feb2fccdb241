//! Which of two gases ghosts show.

use aero_geometry::kernel::QuinticSpline;

use super::Ghost;
use crate::neighbours::Lists;
use crate::records::Records;

/// Gives every ghost the share that the second gas has of what it sees; one that sees none keeps its last.
pub(super) fn read<const D: usize>(lists: &Lists, records: &Records<D>, ghosts: &mut [Ghost<D>]) {
    let run = lists.all();
    for cluster in run.clusters {
        let gas = &run.entries[cluster.gas.clone()];
        for g in cluster.targets.clone() {
            let ghost = &mut ghosts[g];
            let (mut all, mut second) = (0.0, 0.0);
            for &j in gas {
                let j = j as usize;
                let near = &records.near[j];
                let h = 0.5 * ghost.shown.smoothing_length + near.half_h;
                let distance = (ghost.position - near.position).norm();
                let weight = near.volume * QuinticSpline::<D>::value(distance, h);
                all += weight;
                second += weight * records.second[j];
            }
            if all > 0.0 {
                ghost.shown.second = second / all;
            }
        }
    }
}
