//! The box of the flow and what bounds it, as a problem states it.

use aero_geometry::Bounds;

use crate::walls::WallKind;

/// Box of the flow and its sides.
#[derive(Clone, Debug)]
pub struct Domain<const D: usize> {
    /// The box in which particles are fluid.
    pub bounds: Bounds<D>,
    /// `[lower, upper]` side per axis.
    pub sides: [[Side; 2]; D],
}

impl<const D: usize> Domain<D> {
    /// True where one side is the axis of an axisymmetric flow.
    pub fn is_axisymmetric(&self) -> bool {
        self.has(|side| side == Side::Axis)
    }

    /// True where any side is as `is_sought` says.
    pub fn has(&self, is_sought: impl Fn(Side) -> bool) -> bool {
        self.sides.iter().flatten().any(|side| is_sought(*side))
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

    /// Axis, end, kind and face of every side.
    pub fn each_side(&self) -> impl Iterator<Item = (usize, usize, Side, f64)> {
        let ends = (0..D).flat_map(|axis| [(axis, 0), (axis, 1)]);
        ends.map(|(axis, end)| (axis, end, self.sides[axis][end], self.face(axis, end)))
    }
}

/// What bounds the domain on one side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Side {
    /// Buffer of free-stream particles that turn into fluid when they enter.
    Inlet,
    /// Particles that cross freeze their state, drift on and are removed.
    Outlet,
    /// Buffer of free-stream particles along a side that the flow does not disturb.
    FreeStream,
    /// Inlet at less than the speed of sound, from a reservoir at the free stream's stagnation state:
    /// the flow inside decides how fast the gas enters.
    Reservoir,
    /// Mirror plane.
    Symmetry,
    /// The axis that an axisymmetric flow is the same all around.
    Axis,
    /// Joined to the opposite side.
    Periodic,
    /// Plane wall.
    Wall {
        /// Slip or no slip.
        kind: WallKind,
        /// Velocity along the axis at the start.
        velocity: f64,
        /// Constant acceleration along the axis.
        acceleration: f64,
    },
    /// Closed by a body that covers it.
    Body,
}

impl Side {
    /// True where the flow beyond is the mirror image of the flow within.
    pub fn is_mirror(self) -> bool {
        matches!(self, Self::Symmetry | Self::Axis)
    }

    /// True of one that is joined to the opposite side.
    pub fn is_periodic(self) -> bool {
        self == Self::Periodic
    }

    /// True of one that lets gas in or out.
    pub fn is_open(self) -> bool {
        self.lets_in() || self == Self::Outlet
    }

    /// True of one that gas enters through, in a state that is prescribed or follows from a reservoir.
    pub fn lets_in(self) -> bool {
        matches!(self, Self::Inlet | Self::FreeStream | Self::Reservoir)
    }

    /// True of one that keeps the free stream up, whatever the flow inside does.
    pub fn keeps_free_stream(self) -> bool {
        matches!(self, Self::Inlet | Self::FreeStream)
    }

    /// True of a plane wall.
    pub fn is_wall(self) -> bool {
        matches!(self, Self::Wall { .. })
    }
}
