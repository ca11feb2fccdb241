//! The closest point of one piece, and the side of it that a point lies on.

use super::piece::{Arc, Line, Piece, right_of};
use crate::Vector;

/// Where on a piece its closest point lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    Start,
    Within,
    End,
}

/// The closest point of one piece.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Foot {
    pub point: Vector<2>,
    pub distance_squared: f64,
    pub place: Place,
}

impl Piece {
    /// The closest point of this piece to `p`.
    #[inline]
    pub(crate) fn foot(&self, p: &Vector<2>) -> Foot {
        match self {
            Self::Line(line) => line.foot(p),
            Self::Arc(arc) => arc.foot(p),
        }
    }

    /// Signed distance from `p` to the line or circle that carries the piece (negative on the
    /// solid's side), and the unit normal at the foot of `p` there.
    #[inline]
    pub(crate) fn side(&self, p: &Vector<2>) -> (f64, Vector<2>) {
        match self {
            Self::Line(line) => {
                let normal = right_of(&line.direction);
                ((p - line.origin).dot(&normal), normal)
            }
            Self::Arc(arc) => {
                let sign = arc.sweep.signum();
                let d = p - arc.center;
                let r = d.norm();
                let radial = if r > 0.0 { d / r } else { arc.middle };
                (sign * (r - arc.radius), sign * radial)
            }
        }
    }
}

impl Line {
    #[inline]
    fn foot(&self, p: &Vector<2>) -> Foot {
        let s = (p - self.origin).dot(&self.direction);
        let (point, place) = if s <= self.from {
            (self.start, Place::Start)
        } else if s >= self.to {
            (self.end, Place::End)
        } else {
            (self.origin + s * self.direction, Place::Within)
        };
        Foot {
            point,
            distance_squared: (p - point).norm_squared(),
            place,
        }
    }
}

impl Arc {
    #[inline]
    fn foot(&self, p: &Vector<2>) -> Foot {
        let d = p - self.center;
        let r = d.norm();
        if d.dot(&self.middle) >= r * self.cos_half {
            let radial = if r > 0.0 { d / r } else { self.middle };
            return Foot {
                point: self.center + self.radius * radial,
                distance_squared: (r - self.radius) * (r - self.radius),
                place: Place::Within,
            };
        }
        let (to_start, to_end) = (
            (p - self.start).norm_squared(),
            (p - self.end).norm_squared(),
        );
        if to_start <= to_end {
            Foot {
                point: self.start,
                distance_squared: to_start,
                place: Place::Start,
            }
        } else {
            Foot {
                point: self.end,
                distance_squared: to_end,
                place: Place::End,
            }
        }
    }
}
