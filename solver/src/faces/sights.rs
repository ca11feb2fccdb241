//! Who sees whom in one step: takes out of the neighbour lists what lies across a thin part.

use aero_geometry::kernel::SUPPORT;
use rayon::prelude::*;

use super::{FaceSet, Faces, NOWHERE, Sight};
use crate::Simulation;
use crate::neighbours::{GROWTH, Lists};
use crate::records::{FLOW_IMAGES, GHOST_IMAGES, GHOSTS, OPEN};
use crate::rigid::Pose;
use crate::walls::WallLists;

impl<const D: usize> Simulation<D> {
    /// Takes out of all lists the neighbours that are not seen from where a particle is.
    pub(crate) fn part_thin_sides(&mut self) {
        let Some(faces) = self.walls.faces() else {
            return;
        };
        let gas = self.faces_of_the_gas(faces);
        let sights = self.sights(faces, &gas);
        let first = self.records.start[GHOSTS];
        let sees = |own: &FaceSet, slot: usize| sights[slot].is_seen_from(*own);
        self.lists.restrict(|i| gas[i], sees);
        // A ghost's list serves to look for gas, whichever ghosts it holds.
        let is_seen = |own: &Sight, slot: usize| gas.get(slot).is_none_or(|&f| own.is_seen_from(f));
        let restrict = |lists: &mut Lists| lists.restrict(|g| sights[first + g], is_seen);
        let WallLists { near, mirror } = &mut self.wall_lists;
        restrict(near);
        restrict(mirror);
    }

    /// The faces that each gas particle is in front of, by slot: fluid, open boundaries, images.
    fn faces_of_the_gas(&self, faces: &Faces<D>) -> Vec<FaceSet> {
        let records = &self.records;
        let widest = records
            .near
            .iter()
            .fold(0.0, |h: f64, near| h.max(near.half_h));
        let reach = 2.0 * GROWTH * SUPPORT * widest;
        let poses: Vec<Pose<D>> = (0..self.walls.body_count())
            .map(|body| self.walls.pose(body, self.time))
            .collect();
        let originals = records.segment(OPEN).end;
        let mut gas: Vec<FaceSet> = records.near[..originals]
            .par_iter()
            .map(|near| faces.in_front_of(&near.position, &poses, reach))
            .collect();
        for image in 0..records.segment(FLOW_IMAGES).len() {
            let (source, sign) = self.flow_images.source(image);
            gas.push(faces.mirrored(gas[source], &sign));
        }
        gas
    }

    /// From where each record is seen, by slot.
    fn sights(&self, faces: &Faces<D>, gas: &[FaceSet]) -> Vec<Sight> {
        let mut sights: Vec<Sight> = gas
            .iter()
            .map(|&own| Sight {
                only: 0,
                hidden: faces.opposite(own),
            })
            .collect();
        sights.extend(self.walls.ghosts.iter().map(|ghost| ghost.sight));
        let first = self.records.start[GHOSTS];
        for image in 0..self.records.segment(GHOST_IMAGES).len() {
            let (source, sign) = self.ghost_images.source(image);
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
}
