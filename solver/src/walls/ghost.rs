//! What a ghost is.

use aero_geometry::Vector;
use serde::{Deserialize, Serialize};

use crate::faces::Sight;
use crate::records::Matrix;

/// A ghost: a fixed volume of a body or wall that takes its state from the gas.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Ghost<const D: usize> {
    /// Position now.
    pub position: Vector<D>,
    /// Normal now, into the gas.
    pub normal: Vector<D>,
    /// Where it is at time zero, which the motion of its body starts from.
    pub origin: Origin<D>,
    /// Depth below the surface, positive.
    pub depth: f64,
    /// Volume; constant unless the experiment without constant volume is asked for.
    pub volume: f64,
    /// Mass that the experiment without constant volume holds constant instead.
    pub reference_mass: f64,
    /// The mirror point lies in the gas at the same distance from the same wall; false near
    /// tips and edges, where it falls across them.
    pub has_mirror: bool,
    /// Number of the body: scene order, wall sides after.
    pub body: u32,
    /// Layer, 0 at the wall.
    pub layer: u32,
    /// From where it is seen.
    pub sight: Sight,
    /// What the wall does above it now.
    pub wall: WallAbove<D>,
    /// What it shows the gas.
    pub shown: Shown<D>,
}

/// Where a ghost is at time zero.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Origin<const D: usize> {
    /// Position.
    pub position: Vector<D>,
    /// Normal, into the gas.
    pub normal: Vector<D>,
    /// Shape operator of the surface here.
    pub curvature: Matrix<D>,
}

/// What a wall does where a ghost has its foot.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct WallAbove<const D: usize> {
    /// Velocity.
    pub velocity: Vector<D>,
    /// Velocity of the surface along itself beside that, of what gas sticks to.
    pub slide: Vector<D>,
    /// Acceleration.
    pub acceleration: Vector<D>,
    /// Shape operator: gas that slides at `u` is accelerated by `-u.K u` along the normal.
    pub curvature: Matrix<D>,
    /// Twice normal times angular velocity: gas that slides at `u` over a turning wall is accelerated by its
    /// scalar product with `u` along the normal.
    pub coriolis: Vector<D>,
}

/// The state that a ghost shows the gas.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Shown<const D: usize> {
    /// Velocity.
    pub velocity: Vector<D>,
    /// Rate of strain.
    pub strain: Matrix<D>,
    /// Pressure.
    pub pressure: f64,
    /// Pressure at the surface above.
    pub wall_pressure: f64,
    /// Specific internal energy.
    pub energy: f64,
    /// Density, from the equation of state.
    pub density: f64,
    /// Gradient of the gas's density across the layer at the wall, by what its pressure does there.
    pub density_gradient: Vector<D>,
    /// Smoothing length.
    pub smoothing_length: f64,
    /// Share of the second gas.
    pub second: f64,
}

impl<const D: usize> WallAbove<D> {
    /// A plane wall at rest.
    pub fn at_rest() -> Self {
        Self {
            velocity: Vector::zeros(),
            slide: Vector::zeros(),
            acceleration: Vector::zeros(),
            curvature: Matrix::zeros(),
            coriolis: Vector::zeros(),
        }
    }
}

impl<const D: usize> Ghost<D> {
    /// Mirror point in the gas.
    pub fn mirror(&self) -> Vector<D> {
        self.position + self.normal * (2.0 * self.depth)
    }

    /// Closest point of the surface.
    pub fn foot(&self) -> Vector<D> {
        self.position + self.normal * self.depth
    }
}
