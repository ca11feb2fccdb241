//! The box of the flow and what bounds it, as a problem states it.

use aero_geometry::{Bounds, Vector};

use super::opening::Opening;
use super::side::Side;

/// Names of the axes.
pub const AXES: [&str; 3] = ["x", "y", "z"];

/// Name of the side at `end`, 0 the lower and 1 the upper one, of `axis`, as scenes write it: `x_min`.
pub fn side_name(axis: usize, end: usize) -> String {
    format!("{}_{}", AXES[axis], ["min", "max"][end])
}

/// Box of the flow and its sides.
#[derive(Clone, Debug)]
pub struct Domain<const D: usize> {
    /// The box in which particles are fluid.
    pub bounds: Bounds<D>,
    /// `[lower, upper]` side per axis.
    pub sides: [[Side; 2]; D],
    /// Parts of sides that are others, and gas beyond sides that is not the free stream.
    pub openings: Vec<Opening<D>>,
}

impl<const D: usize> Domain<D> {
    /// A box whose sides are whole, with nothing but the free stream beyond those that are open.
    pub const fn new(bounds: Bounds<D>, sides: [[Side; 2]; D]) -> Self {
        Self {
            bounds,
            sides,
            openings: Vec::new(),
        }
    }

    /// True where one side is the axis of an axisymmetric flow.
    pub fn is_axisymmetric(&self) -> bool {
        self.has(|side| side == Side::Axis)
    }

    /// True where any side, or part of one, is as `is_sought` says.
    pub fn has(&self, is_sought: impl Fn(Side) -> bool) -> bool {
        let mut parts = self.openings.iter().map(|opening| opening.side);
        self.sides.iter().flatten().any(|side| is_sought(*side)) || parts.any(is_sought)
    }

    /// True of a place beyond a mirror, or beyond a plane wall at rest.
    pub fn is_walled_off(&self, place: &Vector<D>) -> bool {
        (0..D).any(|axis| {
            let out = [
                self.bounds.min[axis] - place[axis],
                place[axis] - self.bounds.max[axis],
            ];
            let is_shut = |side: &Side| match side {
                Side::Wall {
                    velocity,
                    acceleration,
                    ..
                } => *velocity == 0.0 && *acceleration == 0.0,
                side => side.is_mirror(),
            };
            (0..2).any(|end| out[end] > 0.0 && is_shut(&self.sides[axis][end]))
        })
    }

    /// Parts of the side at `end` of `axis`.
    pub fn parts(&self, axis: usize, end: usize) -> impl Iterator<Item = &Opening<D>> {
        let is_own = move |opening: &&Opening<D>| {
            (opening.axis, opening.end) == (axis, end) && opening.part.is_some()
        };
        self.openings.iter().filter(is_own)
    }

    /// The part of the side at `end` of `axis` that `place` lies in front of, or behind.
    pub fn part_at(&self, axis: usize, end: usize, place: &Vector<D>) -> Option<&Opening<D>> {
        self.parts(axis, end).find(|part| part.faces(place))
    }

    /// What the side at `end` of `axis` is where `place` lies in front of it, or behind.
    pub fn side_at(&self, axis: usize, end: usize, place: &Vector<D>) -> Side {
        let part = self.part_at(axis, end, place);
        part.map_or(self.sides[axis][end], |part| part.side)
    }

    /// True where gas crosses the side at `end` of `axis`, if only through a part of it.
    pub fn opens(&self, axis: usize, end: usize) -> bool {
        let mut parts = self.parts(axis, end);
        self.sides[axis][end].is_open() || parts.any(|part| part.side.is_open())
    }

    /// The face of side `end`, 0 the lower and 1 the upper one, of `axis`.
    pub fn face(&self, axis: usize, end: usize) -> f64 {
        let corner = if end == 0 {
            &self.bounds.min
        } else {
            &self.bounds.max
        };
        corner[axis]
    }

    /// How far `place` lies within the side at `end` of `axis`; negative beyond it.
    pub fn depth_within(&self, axis: usize, end: usize, place: &Vector<D>) -> f64 {
        let way = if end == 0 { 1.0 } else { -1.0 };
        (place[axis] - self.face(axis, end)) * way
    }

    /// End and place of the symmetry plane across `axis` that halves a body of this `extent`; none where a body goes on through both
    /// planes of the axis: with its images that is a row without end, and no plane has the half of it.
    pub fn plane_through(&self, axis: usize, extent: &Bounds<D>) -> Option<(usize, f64)> {
        let cuts = |&end: &usize| {
            let plane = self.face(axis, end);
            let is_plane = self.sides[axis][end] == Side::Symmetry;
            is_plane && extent.min[axis] < plane && plane < extent.max[axis]
        };
        let mut ends = [0, 1].into_iter().filter(cuts);
        match (ends.next(), ends.next()) {
            (Some(end), None) => Some((end, self.face(axis, end))),
            _ => None,
        }
    }

    /// Axis, end, kind and face of every side.
    pub fn each_side(&self) -> impl Iterator<Item = (usize, usize, Side, f64)> {
        let ends = (0..D).flat_map(|axis| [(axis, 0), (axis, 1)]);
        ends.map(|(axis, end)| (axis, end, self.sides[axis][end], self.face(axis, end)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::problem::WallKind;

    #[test]
    fn mirrors_and_walls_at_rest_shut_what_is_beyond_them_off() {
        let moving = Side::Wall {
            kind: WallKind::Slip,
            velocity: 0.1,
            acceleration: 0.0,
        };
        let bounds = Bounds::new([0.0, 0.0].into(), [1.0, 2.0].into());
        let domain = Domain::new(bounds, [[Side::WALL, moving], [Side::Axis, Side::Outlet]]);
        let is_off = |x: f64, y: f64| domain.is_walled_off(&[x, y].into());
        assert!(is_off(-0.1, 1.0) && is_off(-0.1, 2.1) && is_off(0.5, -0.1));
        assert!(!is_off(0.5, 1.0) && !is_off(1.1, 1.0) && !is_off(0.5, 2.1));
    }
}
