//! The pieces of an outline: straight lines (possibly endless) and circular arcs.
//!
//! A piece is travelled so that the solid lies to the left. Not responsible for how pieces join.

use std::f64::consts::TAU;

use crate::{Bounds, Vector};

/// A piece of an outline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Piece {
    /// A straight piece, a ray, or a whole line.
    Line(Line),
    /// A circular arc.
    Arc(Arc),
}

/// A straight piece `origin + s * direction`, `s` in `from..=to`; either may be infinite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    pub(super) origin: Vector<2>,
    pub(super) direction: Vector<2>,
    pub(super) from: f64,
    pub(super) to: f64,
    pub(super) start: Vector<2>,
    pub(super) end: Vector<2>,
}

/// An arc of a circle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arc {
    pub(super) center: Vector<2>,
    pub(super) radius: f64,
    pub(super) start_angle: f64,
    pub(super) sweep: f64,
    pub(super) start: Vector<2>,
    pub(super) end: Vector<2>,
    /// Unit vector from the centre to the middle of the arc.
    pub(super) middle: Vector<2>,
    /// Cosine of half the sweep.
    pub(super) cos_half: f64,
}

/// `v` turned a quarter to the right: from a tangent to the normal out of the solid.
pub(crate) fn right_of(v: &Vector<2>) -> Vector<2> {
    Vector::<2>::new(v.y, -v.x)
}

/// The third component of the cross product.
pub(crate) fn cross(a: &Vector<2>, b: &Vector<2>) -> f64 {
    a.x * b.y - a.y * b.x
}

/// The unit vector at `angle` (radians) from the x axis.
pub(crate) fn unit(angle: f64) -> Vector<2> {
    let (sin, cos) = angle.sin_cos();
    Vector::<2>::new(cos, sin)
}

/// The point at parameter `s`, also where `s` is infinite and `direction` has a zero.
fn along(origin: &Vector<2>, direction: &Vector<2>, s: f64) -> Vector<2> {
    origin.zip_map(direction, |o, d| if d == 0.0 { o } else { o + s * d })
}

impl Piece {
    /// The straight piece from `start` to `end`.
    pub fn segment(start: Vector<2>, end: Vector<2>) -> Self {
        let length = (end - start).norm();
        Self::Line(Line {
            origin: start,
            direction: (end - start) / length,
            from: 0.0,
            to: length,
            start,
            end,
        })
    }

    /// The ray that starts at `start` and runs endlessly along `direction`.
    pub fn ray_from(start: Vector<2>, direction: Vector<2>) -> Self {
        let direction = direction.normalize();
        Self::Line(Line {
            origin: start,
            direction,
            from: 0.0,
            to: f64::INFINITY,
            start,
            end: along(&start, &direction, f64::INFINITY),
        })
    }

    /// The ray that comes from infinity along `direction` and stops at `end`.
    pub fn ray_to(end: Vector<2>, direction: Vector<2>) -> Self {
        let direction = direction.normalize();
        Self::Line(Line {
            origin: end,
            direction,
            from: f64::NEG_INFINITY,
            to: 0.0,
            start: along(&end, &direction, f64::NEG_INFINITY),
            end,
        })
    }

    /// The whole line through `point` along `direction`.
    pub fn whole_line(point: Vector<2>, direction: Vector<2>) -> Self {
        let direction = direction.normalize();
        Self::Line(Line {
            origin: point,
            direction,
            from: f64::NEG_INFINITY,
            to: f64::INFINITY,
            start: along(&point, &direction, f64::NEG_INFINITY),
            end: along(&point, &direction, f64::INFINITY),
        })
    }

    /// The arc about `center` that starts at `start_angle` (radians from the x axis) and turns by
    /// `sweep`: positive counter-clockwise (the solid bulges), negative clockwise (it is hollowed).
    pub fn arc(center: Vector<2>, radius: f64, start_angle: f64, sweep: f64) -> Self {
        let point = |angle: f64| center + radius * unit(angle);
        let start = point(start_angle);
        let closed = sweep.abs() >= TAU;
        let end = if closed {
            start
        } else {
            point(start_angle + sweep)
        };
        Self::arc_between(center, radius, [start_angle, sweep], [start, end])
    }

    /// The same arc with its end points given, so that neighbours share them to the last bit.
    pub(crate) fn arc_between(
        center: Vector<2>,
        radius: f64,
        [start_angle, sweep]: [f64; 2],
        [start, end]: [Vector<2>; 2],
    ) -> Self {
        let sweep = sweep.clamp(-TAU, TAU);
        Self::Arc(Arc {
            center,
            radius,
            start_angle,
            sweep,
            start,
            end,
            middle: unit(start_angle + 0.5 * sweep),
            cos_half: (0.5 * sweep).cos(),
        })
    }

    /// First point; infinite coordinates where the piece comes from infinity.
    pub fn start(&self) -> Vector<2> {
        match self {
            Self::Line(line) => line.start,
            Self::Arc(arc) => arc.start,
        }
    }

    /// Last point; infinite coordinates where the piece runs to infinity.
    pub fn end(&self) -> Vector<2> {
        match self {
            Self::Line(line) => line.end,
            Self::Arc(arc) => arc.end,
        }
    }

    /// Range of the arc length `s`: `0..=length`, but `-inf..=0` on a ray from infinity.
    pub fn range(&self) -> [f64; 2] {
        match self {
            Self::Line(line) => [line.from, line.to],
            Self::Arc(arc) => [0.0, arc.radius * arc.sweep.abs()],
        }
    }

    /// Length; infinite on a ray.
    pub fn length(&self) -> f64 {
        let [from, to] = self.range();
        to - from
    }

    /// The point at arc length `s` within [`Piece::range`].
    pub fn point(&self, s: f64) -> Vector<2> {
        match self {
            Self::Line(line) => line.origin + s * line.direction,
            Self::Arc(arc) => arc.center + arc.radius * unit(arc.angle(s)),
        }
    }

    /// Unit tangent at arc length `s`, in the direction of travel.
    pub fn tangent(&self, s: f64) -> Vector<2> {
        match self {
            Self::Line(line) => line.direction,
            Self::Arc(arc) => {
                let e = unit(arc.angle(s));
                Vector::<2>::new(-e.y, e.x) * arc.sweep.signum()
            }
        }
    }

    /// Unit normal at arc length `s`, out of the solid.
    pub fn normal(&self, s: f64) -> Vector<2> {
        right_of(&self.tangent(s))
    }

    /// Signed curvature: positive where the solid bulges, zero on lines.
    pub fn curvature(&self) -> f64 {
        match self {
            Self::Line(_) => 0.0,
            Self::Arc(arc) => arc.sweep.signum() / arc.radius,
        }
    }

    /// A box around the piece.
    pub fn bounds(&self) -> Bounds<2> {
        let (start, end) = (self.start(), self.end());
        let mut bounds = Bounds::new(start.inf(&end), start.sup(&end));
        if let Self::Arc(arc) = self {
            for (axis, sign) in [(0, -1.0), (0, 1.0), (1, -1.0), (1, 1.0)] {
                let mut direction = Vector::<2>::zeros();
                direction[axis] = sign;
                if direction.dot(&arc.middle) >= arc.cos_half {
                    let reach = arc.center[axis] + sign * arc.radius;
                    bounds.min[axis] = bounds.min[axis].min(reach);
                    bounds.max[axis] = bounds.max[axis].max(reach);
                }
            }
        }
        bounds
    }
}

impl Line {
    /// Point on the line at parameter zero.
    pub fn origin(&self) -> Vector<2> {
        self.origin
    }

    /// Unit vector of travel.
    pub fn direction(&self) -> Vector<2> {
        self.direction
    }
}

impl Arc {
    fn angle(&self, s: f64) -> f64 {
        self.start_angle + self.sweep.signum() * s / self.radius
    }

    /// Centre of the circle.
    pub fn center(&self) -> Vector<2> {
        self.center
    }

    /// Radius of the circle.
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// Angle of the first point about the centre, radians from the x axis.
    pub fn start_angle(&self) -> f64 {
        self.start_angle
    }

    /// Angle turned from start to end, radians; negative is clockwise.
    pub fn sweep(&self) -> f64 {
        self.sweep
    }

    /// True where `direction` (unit, from the centre) meets the arc.
    pub(crate) fn spans(&self, direction: &Vector<2>) -> bool {
        direction.dot(&self.middle) >= self.cos_half
    }
}
