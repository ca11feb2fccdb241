//! The scene file, key by key. Ranges of single numbers are checked here, by their types; whether
//! the values make sense together is decided where the case is built.

use std::path::PathBuf;

use serde::Deserialize;

use super::formula::Formula;
use super::number::{
    Count, Courant, Dimension, Disorder, Finite, Gamma, Name, NonNegative, Positive,
};
use super::shapes::ShapeEntry;
use super::side::{SideEntry, WallWord};
use super::spin::{Rotation, Spin};
use crate::case::{Equations, Extrapolation, Precision, Stop};

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
    /// Time at which the run ends.
    pub end_time: Positive,
    /// `end-time` unless given.
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
    /// Bodies.
    #[serde(default)]
    pub body: Vec<BodyEntry>,
    /// When to write what.
    #[serde(default)]
    pub output: OutputEntry,
}

/// `[gas]`
#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct GasEntry {
    /// Ratio of specific heats; 1.4 unless given.
    pub gamma: Option<Gamma>,
}

/// `[scheme]`
#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SchemeEntry {
    /// `conservative` unless given.
    pub equations: Option<EquationsWord>,
    /// `wom` unless given.
    pub extrapolation: Option<ExtrapolationWord>,
    /// Off unless given.
    pub shield: Option<bool>,
    /// Off unless given.
    pub shifting: Option<bool>,
    /// On unless given.
    pub constant_ghost_volume: Option<bool>,
    /// On unless given; of the conservative scheme.
    pub limited_viscosity: Option<bool>,
    /// On unless given; of the conservative scheme.
    pub limited_conduction: Option<bool>,
    /// On unless given.
    pub surface_tags: Option<bool>,
    /// Moves the undisturbed free stream on without pair sums.
    pub skip_undisturbed: Option<bool>,
    /// `double` unless given.
    pub precision: Option<PrecisionWord>,
    /// 0.5 unless given.
    pub cfl: Option<Courant>,
}

/// When a run ends, as a scene spells it.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum StopWord {
    /// At the end time.
    EndTime,
    /// As soon as forces and shocks have settled, at the end time at the latest.
    Steady,
}

impl From<StopWord> for Stop {
    fn from(word: StopWord) -> Self {
        match word {
            StopWord::EndTime => Self::EndTime,
            StopWord::Steady => Self::Steady,
        }
    }
}

/// Numbers of the pair sums, as a scene spells it.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum PrecisionWord {
    /// All in `f64`.
    Double,
    /// Pairs in `f32`.
    Mixed,
}

impl From<PrecisionWord> for Precision {
    fn from(word: PrecisionWord) -> Self {
        match word {
            PrecisionWord::Double => Self::Double,
            PrecisionWord::Mixed => Self::Mixed,
        }
    }
}

/// Set of equations, as a scene spells it.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum EquationsWord {
    /// The conservative successor.
    Conservative,
    /// The published scheme.
    Paper,
}

impl From<EquationsWord> for Equations {
    fn from(word: EquationsWord) -> Self {
        match word {
            EquationsWord::Conservative => Self::Conservative,
            EquationsWord::Paper => Self::Paper,
        }
    }
}

/// How ghosts get their state, as a scene spells it.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ExtrapolationWord {
    /// Without ghost mirrors.
    Wom,
    /// With ghost mirrors.
    Wm,
}

impl From<ExtrapolationWord> for Extrapolation {
    fn from(word: ExtrapolationWord) -> Self {
        match word {
            ExtrapolationWord::Wom => Self::Wom,
            ExtrapolationWord::Wm => Self::Wm,
        }
    }
}

/// `[free_stream]`: pressure, one of density and temperature, one of Mach number, speed and
/// velocity.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FreeStreamEntry {
    /// Pressure.
    pub pressure: Positive,
    /// Density.
    pub density: Option<Positive>,
    /// Temperature in kelvin, in place of the density.
    pub temperature: Option<Positive>,
    /// Specific gas constant in J/(kg K), with a temperature; 287.05 (air) unless given.
    pub gas_constant: Option<Positive>,
    /// Mach number.
    pub mach: Option<NonNegative>,
    /// Speed.
    pub speed: Option<NonNegative>,
    /// Velocity.
    pub velocity: Option<Vec<Finite>>,
    /// Direction, with a Mach number or a speed; along the first axis unless given.
    pub direction: Option<Vec<Finite>>,
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
#[derive(Clone, Copy, Debug, Deserialize)]
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
    /// Random displacement of the starting lattice, as a fraction of the spacing; none unless
    /// given.
    pub disorder: Option<Disorder>,
}

/// `[initial.field]`: numbers or formulas of position; what is left out is that of the free
/// stream. Where the density is zero, there is no gas.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FieldEntry {
    /// Density.
    pub density: Option<Formula>,
    /// Pressure.
    pub pressure: Option<Formula>,
    /// Velocity, one formula per axis.
    pub velocity: Option<Vec<Formula>>,
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
    /// Density.
    pub density: Positive,
    /// Pressure.
    pub pressure: Positive,
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
    /// `slip` unless given.
    pub wall: Option<WallWord>,
    /// Ghost spacing; that of the scene unless given.
    pub spacing: Option<Positive>,
    /// Fly it all the same where more than two per cent of its surface have no ghosts; off unless given.
    pub allow_loss: Option<bool>,
    /// Conforming fluid around it at the start, in place of the lattice; off unless given.
    pub packed_fluid: Option<bool>,
    /// Where it stands.
    pub place: Option<PlaceEntry>,
    /// How it moves.
    pub motion: Option<MotionEntry>,
    /// Area (3D) or length (2D) of the force coefficients.
    pub reference_area: Option<Positive>,
    /// Length of the moment coefficients.
    pub reference_length: Option<Positive>,
    /// Point of the moments.
    pub moment_centre: Option<Vec<Finite>>,
}

/// `place`: scaled about the origin, then turned about it, then shifted.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PlaceEntry {
    /// Factor on all lengths.
    pub scale: Option<Positive>,
    /// Turn: degrees in 2D, axis and degrees in 3D.
    pub rotate: Option<Rotation>,
    /// Shift.
    pub translate: Option<Vec<Finite>>,
}

/// `motion`
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MotionEntry {
    /// Velocity of the pivot at time zero.
    pub velocity: Option<Vec<Finite>>,
    /// Constant acceleration of the pivot.
    pub acceleration: Option<Vec<Finite>>,
    /// Angular velocity about the pivot, rad/s: a number in 2D, a vector in 3D, or either over time.
    pub angular_velocity: Option<Spin>,
    /// Pivot at time zero; the moment centre unless given.
    pub pivot: Option<Vec<Finite>>,
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
    /// Compressed frames; off unless given.
    pub compress: Option<bool>,
    /// Steps between rows of the history; 1 unless given.
    pub history_every: Option<Count>,
    /// Longest time between checkpoints in seconds; 60 unless given.
    pub checkpoint_seconds: Option<NonNegative>,
}

/// `output.region`: a box.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RegionEntry {
    /// Lowest corner.
    pub min: Vec<Finite>,
    /// Highest corner.
    pub max: Vec<Finite>,
}
