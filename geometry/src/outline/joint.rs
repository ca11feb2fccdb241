//! Where two pieces of an outline meet.

use std::f64::consts::PI;

use super::piece::{Piece, cross, right_of};
use crate::Vector;

/// A crease of an outline: two smooth faces meet here at an angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corner {
    /// Where.
    pub point: Vector<2>,
    /// The piece that ends here and the one that starts here.
    pub pieces: [usize; 2],
    /// Angle inside the solid, radians: below pi at a tip, above pi at a re-entrant corner.
    pub interior_angle: f64,
    /// Unit bisector, out of the solid.
    pub bisector: Vector<2>,
}

/// The meeting of two pieces, smooth or not.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Joint {
    pub point: Vector<2>,
    /// Angle by which the tangent turns left, in `-pi..=pi`; positive where the solid bulges.
    pub turn: f64,
    /// Unit bisector of the two normals, out of the solid.
    pub bisector: Vector<2>,
    /// The piece that ends here and the one that starts here; the same where a meridian meets its mirror image.
    pub pieces: [usize; 2],
}

impl Joint {
    /// The joint of `pieces` at `point`, where the tangent changes from `before` to `after`.
    pub fn new(
        point: Vector<2>,
        before: &Vector<2>,
        after: &Vector<2>,
        pieces: [usize; 2],
    ) -> Self {
        let mut turn = cross(before, after).atan2(before.dot(after));
        if turn <= -PI {
            // A needle tip, not a slit, is what bodies have.
            turn = PI;
        }
        let (sin, cos) = (0.5 * turn).sin_cos();
        let n = right_of(before);
        Self {
            point,
            turn,
            bisector: Vector::<2>::new(cos * n.x - sin * n.y, sin * n.x + cos * n.y),
            pieces,
        }
    }

    /// The joint between two consecutive pieces of `all`.
    pub fn between(all: &[Piece], [before, after]: [usize; 2]) -> Self {
        Self::new(
            all[after].start(),
            &all[before].tangent(all[before].range()[1]),
            &all[after].tangent(all[after].range()[0]),
            [before, after],
        )
    }

    /// The piece on whose side of the bisector `offset` (from the joint) lies, given that the joint is the closest point:
    /// both are equally near then, and a body that is its own mirror image must be seen as one.
    pub fn nearer(&self, offset: &Vector<2>) -> usize {
        self.pieces[usize::from(cross(&self.bisector, offset) > 0.0)]
    }

    /// Which side of the surface `offset` (from the joint) lies on, given that the joint is the
    /// closest point: 1 outside, -1 inside.
    pub fn sign(&self, offset: &Vector<2>) -> f64 {
        // Points closest to a joint lie within half the turn of the bisector: the projection
        // decides, except at sharp tips, where it gets close to zero but only one side exists.
        if self.turn.abs() > 1.0 {
            self.turn.signum()
        } else if offset.dot(&self.bisector) >= 0.0 {
            1.0
        } else {
            -1.0
        }
    }
}
