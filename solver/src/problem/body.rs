//! Bodies as a problem states them: shape, wall, motion, packed ghosts.

use std::sync::Arc;

use aero_geometry::{Shape, Vector};
use aero_packer::{Ghosts, PackReport};

use super::WallKind;

/// A rigid body with its packed ghosts.
#[derive(Clone, Debug)]
pub struct Body<const D: usize> {
    /// Name, unique in the scene.
    pub name: String,
    /// The surface, at time zero.
    pub shape: Arc<dyn Shape<D>>,
    /// Slip or no slip.
    pub wall: WallKind,
    /// Its motion.
    pub motion: Motion<D>,
    /// Packed ghosts, at time zero.
    pub ghosts: Ghosts<D>,
    /// Fluid around it at time zero, in place of the lattice.
    pub packed_fluid: Option<PackedFluid<D>>,
    /// Quality of the packing.
    pub report: PackReport,
    /// Area (3D) or length (2D) to which force coefficients refer.
    pub reference_area: f64,
    /// Length to which moment coefficients refer.
    pub reference_length: f64,
    /// Point to which moments refer.
    pub moment_centre: Vector<D>,
}

impl<const D: usize> Body<D> {
    /// Signed distance at which the lattice of the fluid begins.
    pub fn starting_distance(&self, spacing: f64) -> f64 {
        // The lattice may touch the half spacing exactly; round-off must not decide.
        let bare = 0.5 * spacing * (1.0 - 1e-6);
        self.packed_fluid
            .as_ref()
            .map_or(bare, |packed| packed.lattice_begins)
    }
}

/// Fluid that conforms to a body's surface.
#[derive(Clone, Debug, PartialEq)]
pub struct PackedFluid<const D: usize> {
    /// Positions.
    pub position: Vec<Vector<D>>,
    /// It takes the place of all lattice points up to this signed distance.
    pub lattice_begins: f64,
}

/// Rigid motion: prescribed, or from here on left to the gas; all zero for a body at rest.
#[derive(Clone, Debug, PartialEq)]
pub struct Motion<const D: usize> {
    /// Velocity of the pivot at time zero.
    pub velocity: Vector<D>,
    /// Constant acceleration of the pivot; of a free body, what is not the gas's.
    pub acceleration: Vector<D>,
    /// Angular velocity about the pivot; of a free body, that at time zero.
    pub turning: Turning,
    /// Pivot at time zero; of a free body its centre of mass, or the hinge that holds it.
    pub pivot: Vector<D>,
    /// What the gas moves it by; none of a body that moves as prescribed.
    pub free: Option<Freedom>,
}

/// Of a body that the gas moves. Axes are those of space; missing ones are held.
#[derive(Clone, Debug, PartialEq)]
pub struct Freedom {
    /// Mass, kg; to a metre of depth in the plane, of the whole body where a symmetry plane cuts it.
    pub mass: f64,
    /// Moments of inertia about the pivot at time zero, kg m^2; in the plane to a metre of depth, and `zz` alone counts.
    pub inertia: nalgebra::Matrix3<f64>,
    /// Axes that the pivot does not move along.
    pub is_held: [bool; 3],
    /// Axes that the body does not turn about.
    pub keeps_turn: [bool; 3],
}

/// Angular velocity over time, rad/s, about an axis that keeps its direction: `z` component in 2D, vector
/// in 3D, unused in 1D.
#[derive(Clone, Debug, PartialEq)]
pub enum Turning {
    /// Constant.
    Steady(nalgebra::Vector3<f64>),
    /// `amplitude cos(2 pi t / period + phase)`.
    Cosine {
        /// Greatest angular velocity.
        amplitude: nalgebra::Vector3<f64>,
        /// Period.
        period: f64,
        /// Phase at time zero, radians.
        phase: f64,
    },
    /// Straight lines between points in time; the first and the last rate hold outside of them.
    Table {
        /// Unit vector along the axis.
        axis: nalgebra::Vector3<f64>,
        /// Times, increasing.
        times: Vec<f64>,
        /// Angular velocity about the axis at each of them.
        rates: Vec<f64>,
    },
}

impl<const D: usize> Motion<D> {
    /// True where a body that is its own mirror image in a plane across this axis remains so: it neither moves along the axis, by itself or by
    /// what is not the gas's, nor turns but about it.
    pub fn keeps(&self, axis: usize) -> bool {
        self.velocity[axis] == 0.0 && self.acceleration[axis] == 0.0 && self.turning.is_about(axis)
    }
}

impl Turning {
    /// True where it is about this axis alone, or none.
    fn is_about(&self, axis: usize) -> bool {
        let about = match self {
            Self::Steady(rate) => rate,
            Self::Cosine { amplitude, .. } => amplitude,
            Self::Table { axis, .. } => axis,
        };
        (0..3).all(|k| k == axis || about[k] == 0.0)
    }
}
