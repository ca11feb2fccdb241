//! The scene file, key by key. Ranges of single numbers are checked here, by their types; whether
//! the values make sense together is decided where the case is built.

use std::path::PathBuf;

use serde::Deserialize;

use super::formula::{Formula, TimedFormula};
use super::number::{
    Altitude, Count, Courant, Dimension, Disorder, Finite, Gamma, Name, NonNegative, Part,
    Positive, StreamAngle,
};
use super::picture::PictureEntry;
use super::probe::ProbeEntry;
use super::refine::RefineEntry;
use super::region::RegionEntry;
use super::second::SecondGasEntry;
use super::shapes::{PlaceEntry, ShapeEntry};
use super::side::SideEntry;
use super::spin::{Inertia, Spin};
use super::state::EquationOfState;
use super::views::LatticeEntry;
use super::viscosity::ViscosityEntry;
use super::wall::BodyWallEntry;
use super::words::{
    ExtrapolationWord, MotionWord, PrecisionWord, PressureWord, SchemeName, StopWord, TimeWord,
};

/// A whole scene.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SceneFile {
    /// A line for people.
    pub title: Option<String>,
    /// Number of space dimensions.
    pub dimension: Dimension,
    /// Particle spacing.
    pub spacing: Positive,
    /// Time at which the run ends; needed unless it stops when it is steady, and long then.
    pub end_time: Option<Positive>,
    /// When the run ends: at its end time, or as soon as forces and shocks have settled; `end-time` unless given.
    pub stop: Option<StopWord>,
    /// The gas.
    #[serde(default)]
    pub gas: GasEntry,
    /// Equations and boundary treatment.
    #[serde(default)]
    pub scheme: SchemeEntry,
    /// Undisturbed state.
    pub free_stream: Option<FreeStreamEntry>,
    /// Box of the flow.
    pub domain: DomainEntry,
    /// State at the start.
    #[serde(default)]
    pub initial: InitialEntry,
    /// Acceleration of all gas by a force at a distance, m/s^2: gravity, or what drives a periodic channel; none unless given.
    pub body_force: Option<Vec<Finite>>,
    /// A solution made up beforehand, in place of a start: sources keep the gas to it.
    pub manufactured: Option<ManufacturedEntry>,
    /// Bodies.
    #[serde(default)]
    pub body: Vec<BodyEntry>,
    /// When to write what.
    #[serde(default)]
    pub output: OutputEntry,
    /// Where values of the gas are recorded.
    #[serde(default)]
    pub probe: Vec<ProbeEntry>,
}

/// `[gas]`
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct GasEntry {
    /// How pressure and temperature follow from density and energy; `ideal` unless given.
    pub equation_of_state: Option<EquationOfState>,
    /// Ratio of specific heats; 1.4 unless given, of an ideal gas alone.
    pub gamma: Option<Gamma>,
    /// Specific gas constant in J/(kg K), which makes temperatures of pressures and densities; that of the free stream unless given.
    pub gas_constant: Option<Positive>,
    /// Dynamic viscosity, which heat conduction goes with; none unless given.
    pub viscosity: Option<ViscosityEntry>,
    /// Prandtl number, `viscosity * heat capacity / conductivity`; 0.72 (air) unless given.
    pub prandtl: Option<Positive>,
    /// A second gas beside it, of particles; none unless given.
    pub second: Option<SecondGasEntry>,
}

/// `[scheme]`
#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SchemeEntry {
    /// Set of equations: the project's own, the published one, or one of liquids; `conservative` unless given.
    pub equations: Option<SchemeName>,
    /// How ghosts get their state: by a sum where they are, or by a first-order one at their mirror points; `wom` unless given.
    pub extrapolation: Option<ExtrapolationWord>,
    /// Bends the path of what heads for a ghost nearer than its own spacing; off unless given.
    pub shield: Option<bool>,
    /// Particles drift towards even spacing, at 5 to 25 per cent more time; off unless given.
    pub shifting: Option<bool>,
    /// Off only to see particles leak; on unless given.
    pub constant_ghost_volume: Option<bool>,
    /// Smooth flow is spared the artificial viscosity; on unless given, of the conservative scheme alone.
    pub limited_viscosity: Option<bool>,
    /// Smooth and linear energy is spared the artificial conduction, and of viscous gas all that is not in shocks; on unless given, of the conservative scheme alone.
    pub limited_conduction: Option<bool>,
    /// Artificial viscosity and conduction; on unless given, off of viscous gas alone, whose shocks are then as thick as its own viscosity makes them.
    pub artificial_dissipation: Option<bool>,
    /// The two sides of a thin part do not feel each other; on unless given.
    pub surface_tags: Option<bool>,
    /// The undisturbed free stream moves on without pair sums; on unless given.
    pub skip_undisturbed: Option<bool>,
    /// Numbers in which pairs are computed; `double` unless given.
    pub precision: Option<PrecisionWord>,
    /// Courant number; 0.5 unless given, 1 for fixed points.
    pub cfl: Option<Courant>,
    /// What carries the gas: particles that move with it, or points that stay; `with-the-gas` unless given.
    pub motion: Option<MotionWord>,
    /// Whether the way to the end matters; `accurate` unless given, `settle` with `stop = "steady"`; of fixed points alone.
    pub time: Option<TimeWord>,
    /// Halvings of the spacing where the flow and bodies ask for them, or `{ flow = N, bodies = M, bends = K }` of each, `{ points = N }` or `{ minutes = T }`; none unless given, of fixed points alone.
    pub refine: Option<RefineEntry>,
}

/// `[free_stream]`: an altitude, or pressure and one of density and temperature, or density or pressure of a liquid; one of Mach number, speed and velocity.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FreeStreamEntry {
    /// Altitude above the sea in m, in place of pressure and density or temperature: air of the US Standard Atmosphere 1976.
    pub altitude: Option<Altitude>,
    /// Pressure; Pa with a temperature.
    pub pressure: Option<Positive>,
    /// Density, in place of a temperature.
    pub density: Option<Positive>,
    /// Temperature in kelvin, in place of the density.
    pub temperature: Option<Positive>,
    /// Specific gas constant in J/(kg K), with a temperature; 287.05 (air) unless given.
    pub gas_constant: Option<Positive>,
    /// Mach number.
    pub mach: Option<NonNegative>,
    /// Speed, in place of a Mach number; m/s with a temperature.
    pub speed: Option<NonNegative>,
    /// Velocity, in place of a Mach number and a direction.
    pub velocity: Option<Vec<Finite>>,
    /// Direction, with a Mach number or a speed; along the first axis unless given.
    pub direction: Option<Vec<Finite>>,
    /// Angle of attack in degrees, in place of a direction: gas that goes along the first axis comes from below the second one; 0 unless given.
    pub incidence: Option<StreamAngle>,
    /// Sideslip in degrees, in place of a direction: gas comes from below the third axis; 0 unless given.
    pub sideslip: Option<StreamAngle>,
}

/// `[domain]`
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DomainEntry {
    /// Lowest corner.
    pub min: Vec<Finite>,
    /// Highest corner.
    pub max: Vec<Finite>,
    /// What bounds each side.
    pub sides: SidesEntry,
}

/// `[domain.sides]`
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SidesEntry {
    /// Lower side of the first axis.
    pub x_min: SideEntry,
    /// Upper side of the first axis.
    pub x_max: SideEntry,
    /// Lower side of the second axis.
    pub y_min: Option<SideEntry>,
    /// Upper side of the second axis.
    pub y_max: Option<SideEntry>,
    /// Lower side of the third axis.
    pub z_min: Option<SideEntry>,
    /// Upper side of the third axis.
    pub z_max: Option<SideEntry>,
}

impl SidesEntry {
    /// Axis, end and entry of every side that is named.
    pub(super) fn each(&self) -> impl Iterator<Item = (usize, usize, &SideEntry)> {
        let all = [
            Some(&self.x_min),
            Some(&self.x_max),
            self.y_min.as_ref(),
            self.y_max.as_ref(),
            self.z_min.as_ref(),
            self.z_max.as_ref(),
        ];
        let named = all.into_iter().enumerate();
        named.filter_map(|(n, entry)| Some((n / 2, n % 2, entry?)))
    }
}

/// `[initial]`; the free stream everywhere unless given.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct InitialEntry {
    /// Two states beside a plane.
    pub riemann: Option<RiemannEntry>,
    /// Formulas of position, in place of two states.
    pub field: Option<FieldEntry>,
    /// Frame of an earlier run of whatever spacing, whose flow is taken over; relative to the scene's folder.
    pub frame: Option<PathBuf>,
    /// Free stream of that run where it was another one: its flow is turned, sped up and thinned to go with this scene's.
    pub stream: Option<FreeStreamEntry>,
    /// A second run, from which the flow goes on to that of `frame` and beyond.
    pub trend: Option<TrendEntry>,
    /// Random displacement of the starting lattice, as a fraction of the spacing; none unless
    /// given.
    pub disorder: Option<Disorder>,
}

/// `[initial.trend]`: what a run before the one of `initial.frame` tells of where the flow goes.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TrendEntry {
    /// Its frame; relative to the scene's folder.
    pub frame: PathBuf,
    /// Its free stream where it was another one.
    pub stream: Option<FreeStreamEntry>,
    /// Way beyond the flow of `initial.frame`, as a part of the way to there.
    pub part: Part,
}

/// `[initial.field]`: numbers or formulas of position; what is left out is that of the free
/// stream. Where the density is zero, there is no gas.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FieldEntry {
    /// Density; of a liquid in place of the pressure.
    pub density: Option<Formula>,
    /// Pressure; of a liquid in place of the density.
    pub pressure: Option<Formula>,
    /// Velocity, one formula per axis.
    pub velocity: Option<Vec<Formula>>,
}

/// `[manufactured]`: formulas of position and time.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ManufacturedEntry {
    /// Density.
    pub density: TimedFormula,
    /// Pressure.
    pub pressure: TimedFormula,
    /// Velocity, one formula per axis.
    pub velocity: Vec<TimedFormula>,
}

/// `[initial.riemann]`
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RiemannEntry {
    /// Position of the diaphragm on the first axis.
    pub position: Finite,
    /// Smooth density and pressure over a few spacings; off unless given.
    pub smooth: Option<bool>,
    /// State below the position.
    pub left: StateEntry,
    /// State above it.
    pub right: StateEntry,
}

/// A state of the gas.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StateEntry {
    /// Density; needed of gas, in place of the pressure of a liquid.
    pub density: Option<Positive>,
    /// Pressure; needed of gas, in place of the density of a liquid.
    pub pressure: Option<Positive>,
    /// Velocity; zero unless given.
    pub velocity: Option<Vec<Finite>>,
}

/// `[[body]]`
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BodyEntry {
    /// Name, unique in the scene.
    pub name: Name,
    /// Its surface.
    pub shape: ShapeEntry,
    /// Whether the gas slides along it or sticks to it, and what heat does there; `slip` unless given.
    pub wall: Option<BodyWallEntry>,
    /// Ghost spacing, from an eighth of the scene's to one and a half times; the scene's unless given.
    pub spacing: Option<Positive>,
    /// Fly it all the same where more than two per cent of its surface have no ghosts; off unless given.
    pub allow_loss: Option<bool>,
    /// Layers of fluid around it at the start, laid as its ghosts are, in place of the lattice, whose particles next to a body stand in the middle of the room that it leaves them; off unless given.
    pub packed_fluid: Option<bool>,
    /// Where it stands.
    pub place: Option<PlaceEntry>,
    /// How it moves.
    pub motion: Option<MotionEntry>,
    /// Area (3D) or length (2D) of the force coefficients; what a stream along the axis nearest to it sees of the body unless given.
    pub reference_area: Option<Positive>,
    /// Length of the moment coefficients; the largest extent of the body unless given.
    pub reference_length: Option<Positive>,
    /// Point of the moments; the middle of the box about the body unless given.
    pub moment_centre: Option<Vec<Finite>>,
}

/// `motion`
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MotionEntry {
    /// Velocity of the pivot at time zero.
    pub velocity: Option<Vec<Finite>>,
    /// Constant acceleration of the pivot; of a free body what comes beside the gas, as gravity does.
    pub acceleration: Option<Vec<Finite>>,
    /// Angular velocity about the pivot, rad/s: a number in 2D, a vector in 3D, or either over time; of a free body that at time zero.
    pub angular_velocity: Option<Spin>,
    /// Pivot at time zero; the moment centre unless given.
    pub pivot: Option<Vec<Finite>>,
    /// What makes it free, to be moved by the gas; as prescribed unless given.
    pub free: Option<FreeEntry>,
}

/// `motion.free`
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FreeEntry {
    /// Mass, kg; in 2D to a metre of depth, in 1D to a square metre.
    pub mass: Positive,
    /// Moments of inertia about the centre at time zero, kg m^2: a number in 2D, `[xx, yy, zz]` or `[xx, yy, zz, xy, xz, yz]` in 3D; needed where it can turn.
    pub inertia: Option<Inertia>,
    /// Centre of mass, or the hinge that holds it; the moment centre unless given.
    pub centre: Option<Vec<Finite>>,
    /// What it cannot do; nothing unless given.
    pub constraints: Option<Vec<ConstraintWord>>,
}

/// `motion.free.constraints`
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ConstraintWord {
    /// It does not move along x.
    X,
    /// It does not move along y.
    Y,
    /// It does not move along z.
    Z,
    /// It does not turn.
    Turn,
    /// It does not turn about the direction of x; in 3D alone.
    TurnX,
    /// It does not turn about the direction of y; in 3D alone.
    TurnY,
    /// It does not turn about the direction of z.
    TurnZ,
}

/// `[output]`
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct OutputEntry {
    /// Number of frames after the first; 20 unless an interval is given.
    pub frames: Option<Count>,
    /// Time between frames.
    pub interval: Option<Positive>,
    /// What frames show; everything unless given.
    pub region: Option<RegionEntry>,
    /// The cells about points that stay, beside every frame; off unless given.
    pub cells: Option<bool>,
    /// The gas on a lattice, beside every frame; none unless given, `{}` for one as fine as the gas.
    pub field: Option<LatticeEntry>,
    /// A picture of a plane of the flow, beside every frame; none unless given, `{}` for Mach numbers.
    pub picture: Option<PictureEntry>,
    /// Ghosts and buffers, beside every frame; off unless given, of particles alone.
    pub ghosts: Option<bool>,
    /// How the density changes along each axis where particles or points are, in every frame: schlieren; off unless given.
    pub density_gradient: Option<bool>,
    /// The other half of a scene with symmetry sides or an axis, in all that shows the flow; off unless given. Forces stay what they are.
    pub mirror: Option<bool>,
    /// Compressed files; on unless given.
    pub compress: Option<bool>,
    /// The pressure that force coefficients are made of; `gauge` unless given.
    pub coefficients: Option<PressureWord>,
    /// Steps between rows of the history; 1 unless given.
    pub history_every: Option<Count>,
    /// Longest time between checkpoints in seconds; 60 unless given.
    pub checkpoint_seconds: Option<NonNegative>,
}
