//! Who sees whom in one step: takes out of the neighbour lists what lies across a thin part.

use aero_geometry::kernel::SUPPORT;
use aero_geometry::parallel::prelude::*;

use super::{FaceSet, Faces, NOWHERE, Sight};
use crate::neighbourhood::images::{Copies, Images};
use crate::neighbours::{GROWTH, Lists};
use crate::records::{GHOSTS, OPEN, Records};
use crate::walls::rigid::Pose;
use crate::walls::{Ghost, Walls};

/// Takes out of `lists`, those of the fluid and those around ghosts and their mirror points, the neighbours that are not seen
/// from where a particle is. `time` is now.
pub fn part_thin_sides<const D: usize>(
    faces: &Faces<D>,
    (walls, time): (&Walls<D>, f64),
    records: &Records<D>,
    copies: &Copies<D>,
    lists: [&mut Lists; 3],
) {
    let poses: Vec<Pose<D>> = (0..walls.body_count())
        .map(|body| walls.pose(body, time))
        .collect();
    let gas = faces_of_the_gas(faces, &poses, records, &copies.gas);
    let sights = sights(faces, &gas, &walls.ghosts, &copies.ghosts);
    let first = records.start[GHOSTS];
    let sees = |own: &FaceSet, slot: usize| sights[slot].is_seen_from(*own);
    let [fluid, near, mirror] = lists;
    fluid.restrict(|i| gas[i], sees);
    // A ghost's list serves to look for gas, whichever ghosts it holds.
    let is_seen = |own: &Sight, slot: usize| gas.get(slot).is_none_or(|&f| own.is_seen_from(f));
    for lists in [near, mirror] {
        lists.restrict(|g| sights[first + g], is_seen);
    }
}

/// The faces that each gas particle is in front of, by slot: fluid, open boundaries, images.
fn faces_of_the_gas<const D: usize>(
    faces: &Faces<D>,
    poses: &[Pose<D>],
    records: &Records<D>,
    images: &Images<D>,
) -> Vec<FaceSet> {
    let widest = records
        .near
        .iter()
        .fold(0.0, |h: f64, near| h.max(near.half_h));
    let reach = 2.0 * GROWTH * SUPPORT * widest;
    let originals = records.segment(OPEN).end;
    let mut gas: Vec<FaceSet> = records.near[..originals]
        .par_iter()
        .map(|near| faces.in_front_of(&near.position, poses, reach))
        .collect();
    for image in 0..images.len() {
        let (source, sign) = images.source(image);
        gas.push(faces.mirrored(gas[source], &sign));
    }
    gas
}

/// From where each record is seen, by slot.
fn sights<const D: usize>(
    faces: &Faces<D>,
    gas: &[FaceSet],
    ghosts: &[Ghost<D>],
    images: &Images<D>,
) -> Vec<Sight> {
    let mut sights: Vec<Sight> = gas
        .iter()
        .map(|&own| Sight {
            only: 0,
            hidden: faces.opposite(own),
        })
        .collect();
    let first = sights.len();
    sights.extend(ghosts.iter().map(|ghost| ghost.sight));
    for image in 0..images.len() {
        let (source, sign) = images.source(image);
        let original = sights[first + source];
        let mut sight = Sight {
            only: faces.mirrored(original.only, &sign),
            hidden: faces.mirrored(original.hidden, &sign),
        };
        if original.is_view() && !sight.is_view() {
            // Its face has no image; it must not be taken for a ghost.
            sight.only = NOWHERE;
        }
        sights.push(sight);
    }
    sights
}
