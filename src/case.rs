//! What a scene meant: checked, in SI or stated units, with bodies packed. The solver reads this
//! and nothing of the file.

use std::sync::Arc;

use aero_geometry::{Bounds, Shape, Vector};
use aero_packer::{Ghosts, PackReport, Warning};

/// A flow problem ready to run, in `D` dimensions.
#[derive(Clone, Debug)]
pub struct Case<const D: usize> {
    /// Name of the scene.
    pub name: String,
    /// Particle spacing `dx` of the undisturbed lattice.
    pub spacing: f64,
    /// Time at which the run ends.
    pub end_time: f64,
    /// Whether it may end before.
    pub stop: Stop,
    /// Ratio of specific heats.
    pub gamma: f64,
    /// Equations and boundary treatment.
    pub scheme: Scheme,
    /// Box of the flow and what bounds it.
    pub domain: Domain<D>,
    /// Undisturbed state: inlets, free-stream sides, reference of all coefficients.
    pub free_stream: State<D>,
    /// State at the start.
    pub initial: Initial<D>,
    /// Random displacement of the starting lattice inside the domain, as a fraction of the
    /// spacing; zero for a perfect lattice.
    pub disorder: f64,
    /// Bodies in the flow.
    pub bodies: Vec<Body<D>>,
    /// When to write what.
    pub output: OutputPlan<D>,
}

impl<const D: usize> Case<D> {
    /// What the user should know about the bodies.
    pub fn warnings(&self) -> Vec<Warning> {
        let of_body = |body: &Body<D>| {
            let warnings = body.report.warnings.iter();
            warnings
                .map(|warning| warning.of(&body.name))
                .collect::<Vec<_>>()
        };
        self.bodies.iter().flat_map(of_body).collect()
    }
}

/// When a run ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// At its end time.
    EndTime,
    /// As soon as the flow is steady, at its end time at the latest.
    Steady,
}

/// Density, velocity and pressure at a point.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct State<const D: usize> {
    /// Density.
    pub density: f64,
    /// Velocity.
    pub velocity: Vector<D>,
    /// Pressure.
    pub pressure: f64,
}

/// State of the gas at the start.
#[derive(Clone, Debug)]
pub enum Initial<const D: usize> {
    /// The free stream everywhere.
    FreeStream,
    /// Two states on either side of a plane `x = position`.
    Riemann {
        /// State at `x < position`.
        left: State<D>,
        /// State at `x > position`.
        right: State<D>,
        /// Position of the diaphragm on the first axis.
        position: f64,
        /// Smooth density and pressure over a few spacings (Villodi & Ramachandran, eq. 38).
        smooth: bool,
    },
    /// Any state as a function of position.
    Field(Field<D>),
}

/// A state of the gas as a function of position.
#[derive(Clone)]
pub struct Field<const D: usize>(pub Arc<dyn Fn(&Vector<D>) -> State<D> + Send + Sync>);

impl<const D: usize> std::fmt::Debug for Field<D> {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str("Field")
    }
}

/// The set of equations that advances the gas.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Equations {
    /// The scheme of the paper, equations (5)-(17) and (19)-(23), misprints corrected.
    Paper,
    /// Its conservative successor: pairwise conduction, density read off the particles.
    Conservative,
}

/// How ghosts get the state of the gas.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extrapolation {
    /// Without ghost mirrors: Shepard interpolation at the ghost.
    Wom,
    /// With ghost mirrors: first-order consistent interpolation at the mirror point.
    Wm,
}

/// In what numbers the arithmetic of a pair of particles is done; all else is `f64`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// In `f64`.
    Double,
    /// In `f32`: faster, with noise of about a part in a million.
    Mixed,
}

/// Equations and boundary treatment.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(clippy::struct_excessive_bools)] // switches that do not depend on each other
pub struct Scheme {
    /// Set of equations.
    pub equations: Equations,
    /// How ghosts get their state.
    pub extrapolation: Extrapolation,
    /// Penetration shield through the transport velocity.
    pub shield: bool,
    /// Particles are shifted towards even spacing through the transport velocity.
    pub shifting: bool,
    /// Ghost volumes stay constant; false only to show what happens otherwise.
    pub constant_ghost_volume: bool,
    /// The artificial viscosity leaves flow alone that varies linearly; conservative scheme only.
    pub limited_viscosity: bool,
    /// Spare what varies smoothly the artificial conduction; of the conservative scheme only.
    pub limited_conduction: bool,
    /// Gas on one side of a thin part feels neither gas nor ghosts of the other side.
    pub surface_tags: bool,
    /// The undisturbed free stream is moved on without pair sums.
    pub skip_undisturbed: bool,
    /// In what numbers pairs are computed.
    pub precision: Precision,
    /// Courant number `C_CFL` [Villodi & Ramachandran 2024, eq. 33; 0.5 in section 3.4].
    pub cfl: f64,
}

impl Default for Scheme {
    /// What a scene gets that names nothing.
    fn default() -> Self {
        Self {
            equations: Equations::Conservative,
            extrapolation: Extrapolation::Wom,
            shield: false,
            shifting: false,
            constant_ghost_volume: true,
            limited_viscosity: true,
            limited_conduction: true,
            surface_tags: true,
            skip_undisturbed: true,
            precision: Precision::Double,
            cfl: 0.5,
        }
    }
}

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
        self.sides.iter().flatten().any(|side| *side == Side::Axis)
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
}

/// Condition on the velocity at a wall.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WallKind {
    /// The gas slides along the wall.
    Slip,
    /// The gas sticks to the wall.
    NoSlip,
}

/// A rigid body with its packed ghosts.
#[derive(Clone, Debug)]
pub struct Body<const D: usize> {
    /// Name, unique in the scene.
    pub name: String,
    /// The surface, at time zero.
    pub shape: Arc<dyn Shape<D>>,
    /// Slip or no slip.
    pub wall: WallKind,
    /// Prescribed motion.
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

/// Prescribed rigid motion; all zero for a body at rest.
#[derive(Clone, Debug, PartialEq)]
pub struct Motion<const D: usize> {
    /// Velocity of the pivot at time zero.
    pub velocity: Vector<D>,
    /// Constant acceleration of the pivot.
    pub acceleration: Vector<D>,
    /// Angular velocity about the pivot.
    pub turning: Turning,
    /// Pivot at time zero.
    pub pivot: Vector<D>,
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

/// When to write what.
#[derive(Clone, Debug, PartialEq)]
pub struct OutputPlan<const D: usize> {
    /// Time between frames; the first and the last state are always written.
    pub frame_interval: f64,
    /// What frames show; everything if none.
    pub region: Option<Bounds<D>>,
    /// Frames are compressed.
    pub is_compressed: bool,
    /// Steps between rows of the history.
    pub history_every: usize,
    /// Longest wall time between checkpoints, s.
    pub checkpoint_seconds: f64,
}
