//! Thin parts of bodies: which face of a plate, a fin or a sharp tip the gas is in front of, so that gas on one
//! side feels neither the gas on the other nor ghosts that show it.
//!
//! Where a body is thinner than the kernel, the ghosts behind one face reach those behind the opposite one. Gas there is
//! told apart by the face nearest to it: gas in front of opposite faces does not meet, and every ghost between them has a
//! *view* for the other face: a second record at the same place, mirrored about that face and seen from there alone.
//! Further views continue the body beyond the opposite face, so that the kernel is full on either side. Bodies
//! without thin parts have no views, and nothing here is ever called for them.

mod across;
mod numbers;
mod sights;
mod views;

use std::sync::Arc;

use aero_geometry::{Bounds, Shape, Vector};
use serde::{Deserialize, Serialize};

use super::walls::rigid::Pose;
use numbers::Numbers;

use across::beneath;
pub use across::{Foot, foot_on, is_edge};
pub use sights::part_thin_sides;
pub use views::{ThinParts, View, thin_parts};

/// A set of faces of thin parts, one bit each.
pub type FaceSet = u64;

/// In front of this face there never is any gas.
const NOWHERE: FaceSet = 1 << (FaceSet::BITS - 1);

/// From where a ghost is seen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Sight {
    /// Of a view: only gas in front of one of these faces sees it. Empty for a ghost itself.
    pub only: FaceSet,
    /// Gas in front of one of these does not.
    pub hidden: FaceSet,
}

impl Sight {
    /// True where gas in front of `faces` sees it.
    pub fn is_seen_from(&self, faces: FaceSet) -> bool {
        (self.only == 0 || self.only & faces != 0) && self.hidden & faces == 0
    }

    /// True for a view, false for a ghost itself.
    pub fn is_view(&self) -> bool {
        self.only != 0
    }
}

/// The faces of all thin parts.
#[derive(Clone, Debug)]
pub struct Faces<const D: usize> {
    bodies: Vec<ThinBody<D>>,
    /// By bit: the faces opposite.
    opposite: Vec<FaceSet>,
    /// By axis and bit: the face's mirror image in the symmetry plane across the axis; none where
    /// the image is no face of the body.
    mirrored: [Vec<FaceSet>; D],
    spacing: f64,
}

/// A body that has thin parts.
#[derive(Clone, Debug)]
struct ThinBody<const D: usize> {
    number: usize,
    shape: Arc<dyn Shape<D>>,
    /// Box around the thin parts at time zero.
    bounds: Bounds<D>,
    numbers: Numbers<D>,
}

impl<const D: usize> Faces<D> {
    /// The faces that gas at `position` is in front of, one per body; none off the thin parts, by more than `reach`,
    /// and beyond edges and tips, from where both sides are seen. `poses` are those of all bodies.
    pub fn in_front_of(&self, position: &Vector<D>, poses: &[Pose<D>], reach: f64) -> FaceSet {
        let mut faces = 0;
        for body in &self.bodies {
            let origin = poses[body.number].origin(position);
            if !body.bounds.grown(reach).contains(&origin) {
                continue;
            }
            let seen = beneath(body.shape.as_ref(), &origin, self.spacing);
            let face = body.numbers.set(seen.face, &seen.normal);
            if face != 0 && !(seen.distance > 0.0 && is_edge(&body.shape, &seen, self.spacing)) {
                faces |= face;
            }
        }
        faces
    }

    /// The faces opposite to any of `faces`.
    fn opposite(&self, faces: FaceSet) -> FaceSet {
        union(faces, &self.opposite)
    }

    /// The faces whose gas sees a ghost of `own` as it is seen from `from`: those opposite to `own` that are not
    /// opposite to `from`.
    fn beside(&self, own: FaceSet, from: FaceSet) -> FaceSet {
        self.opposite(own) & !self.opposite(from)
    }

    /// Mirror images of `faces` in the planes across those axes where `sign` is negative.
    fn mirrored(&self, mut faces: FaceSet, sign: &Vector<D>) -> FaceSet {
        for (axis, images) in self.mirrored.iter().enumerate() {
            if sign[axis] < 0.0 {
                faces = union(faces, images);
            }
        }
        faces
    }
}

/// All that `sets` hold for the members of `faces`.
fn union(mut faces: FaceSet, sets: &[FaceSet]) -> FaceSet {
    let mut sum = 0;
    while faces != 0 {
        sum |= sets[faces.trailing_zeros() as usize];
        faces &= faces - 1;
    }
    sum
}
