//! Copies of a piece: travelled the other way, mirrored, or placed elsewhere.

use std::f64::consts::PI;

use super::piece::{Line, Piece, unit};
use crate::{Placement, Vector};

impl Piece {
    /// The same piece travelled the other way.
    #[must_use]
    pub fn reversed(&self) -> Self {
        match self {
            Self::Line(line) => line.copied(|p| *p, -line.direction(), true),
            Self::Arc(arc) => Self::arc_between(
                arc.center(),
                arc.radius(),
                [arc.start_angle() + arc.sweep(), -arc.sweep()],
                [self.end(), self.start()],
            ),
        }
    }

    /// The mirror image about the plane `(axis, position)`, travelled so that the solid's image
    /// stays to the left.
    #[must_use]
    pub fn mirrored(&self, (axis, position): (usize, f64)) -> Self {
        let image = |p: &Vector<2>| {
            let mut q = *p;
            q[axis] = 2.0 * position - q[axis];
            q
        };
        match self {
            Self::Line(line) => {
                let mut direction = -line.direction();
                direction[axis] = -direction[axis];
                line.copied(image, direction, true)
            }
            Self::Arc(arc) => {
                let last = arc.start_angle() + arc.sweep();
                let start_angle = if axis == 0 { PI - last } else { -last };
                Self::arc_between(
                    image(&arc.center()),
                    arc.radius(),
                    [start_angle, arc.sweep()],
                    [image(&self.end()), image(&self.start())],
                )
            }
        }
    }

    /// The piece after scaling, turning and moving.
    #[must_use]
    pub fn placed(&self, placement: &Placement<2>) -> Self {
        match self {
            Self::Line(line) => line.copied(
                |p| placement.point(p),
                placement.direction(&line.direction()),
                false,
            ),
            Self::Arc(arc) => {
                let start = placement.direction(&unit(arc.start_angle()));
                Self::arc_between(
                    placement.point(&arc.center()),
                    placement.scale() * arc.radius(),
                    [start.y.atan2(start.x), arc.sweep()],
                    [placement.point(&self.start()), placement.point(&self.end())],
                )
            }
        }
    }
}

impl Line {
    /// The line with its points moved by `image`, along `direction`, its ends exchanged where it
    /// runs `backwards`.
    fn copied(
        &self,
        image: impl Fn(&Vector<2>) -> Vector<2>,
        direction: Vector<2>,
        backwards: bool,
    ) -> Piece {
        let piece = Piece::Line(*self);
        let (mut start, mut end) = (piece.start(), piece.end());
        let [mut from, mut to] = piece.range();
        if backwards {
            (start, end) = (end, start);
            (from, to) = (-to, -from);
        }
        let origin = image(&self.origin());
        match (from.is_finite(), to.is_finite()) {
            (true, true) => Piece::segment(image(&start), image(&end)),
            (true, false) => Piece::ray_from(origin, direction),
            (false, true) => Piece::ray_to(origin, direction),
            (false, false) => Piece::whole_line(origin, direction),
        }
    }
}
