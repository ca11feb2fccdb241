//! `summary.json`: what a run was and what came of it.

use std::collections::BTreeMap;

use aero_packer::Warning;
use serde::Serialize;

use super::body_motion::BodyMotion;

/// The outcome of one run.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Summary {
    /// Name of the scene.
    pub case: String,
    /// What carried the gas: `with-the-gas` or `fixed`.
    pub motion: String,
    /// Set of equations.
    pub scheme: String,
    /// How ghosts got their state.
    pub extrapolation: String,
    /// In what numbers pairs were computed.
    pub precision: String,
    /// Number of space dimensions.
    pub dimension: usize,
    /// Particle spacing.
    pub spacing: f64,
    /// Numbers of particles at the end.
    pub particles: Particles,
    /// Points whose cells were split so often, from those never split; empty of particles.
    pub points_per_level: Vec<usize>,
    /// Steps taken.
    pub steps: u64,
    /// Time reached.
    pub end_time: f64,
    /// `end time reached`, or why the run stopped before; with `stop = "steady"`, how steady it was.
    pub stop_reason: String,
    /// Wall time of the run with its output, s.
    pub wall_seconds: f64,
    /// Processor time of all threads, user and system, s.
    pub cpu_seconds: f64,
    /// The most memory that the process held, packing included; none where the system does not tell.
    pub peak_memory_bytes: Option<u64>,
    /// Threads.
    pub threads: usize,
    /// Fluid particles advanced one full step, per second of processor time.
    pub particle_updates_per_cpu_second: f64,
    /// Mean number of neighbours within the support.
    pub neighbours_mean: f64,
    /// Drift of the conserved totals; none of a flow that was settled, which went through no time, or that sources drive.
    pub conservation: Option<Conservation>,
    /// Loads by name of the body.
    pub bodies: BTreeMap<String, BodySummary>,
    /// Fluid particles inside a body or behind a wall at the end.
    pub leaked: usize,
    /// How often gas was brought back that a step had carried into a wall.
    pub returned: u64,
    /// Ghosts whose mirror was short of neighbours at the end.
    pub mirror_fallbacks: usize,
    /// Smallest density met.
    pub min_density: f64,
    /// Smallest specific internal energy met.
    pub min_energy: f64,
    /// What the user should know.
    pub warnings: Vec<Warning>,
}

/// Numbers of particles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Particles {
    /// Particles that move by the equations.
    pub fluid: usize,
    /// Ghosts of bodies and walls.
    pub ghost: usize,
}

/// Relative drift of the conserved totals: what is there now, less what was there at the start and
/// what came through the boundaries since.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Conservation {
    /// Relative to the mass at the start.
    pub mass: f64,
    /// Length of the drift vector relative to `sqrt(2 M E)`, the momentum that mass and energy at
    /// the start could at most have: never zero, unlike the momentum of a gas at rest.
    pub momentum: f64,
    /// Relative to the energy at the start.
    pub energy: f64,
}

/// Force coefficients of one body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyCoefficients {
    /// Along the stream.
    pub cd: f64,
    /// Across the stream.
    pub cl: f64,
    /// Of the moment, positive nose up.
    pub cm: f64,
    /// Along the body, where the scene states an incidence.
    pub ca: Option<f64>,
    /// Across the body, where the scene states an incidence.
    pub cn: Option<f64>,
}

/// Loads on one body. Coefficients refer to the free stream and are absent where it is at rest.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BodySummary {
    /// Force at the end, by absolute pressure.
    pub force: [f64; 3],
    /// Moment at the end, about the body's moment centre, by absolute pressure.
    pub moment: [f64; 3],
    /// What of it is friction, at the end; of viscous gas alone.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub friction: Option<[f64; 3]>,
    /// Heat that goes from it into the gas per time, at the end; of viscous gas alone.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub heat: Option<f64>,
    /// How it moves at the end, of a body that the gas moves.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub motion: Option<BodyMotion>,
    /// Force at the end, by pressure less that of the free stream; the same on a closed body.
    pub force_gauge: [f64; 3],
    /// Moment at the end, by pressure less that of the free stream.
    pub moment_gauge: [f64; 3],
    /// The pressure that the coefficients are made of: `gauge` or `absolute`.
    pub coefficients: String,
    /// Drag coefficient at the end: force along the free stream.
    pub cd: Option<f64>,
    /// Lift coefficient at the end: force across the free stream, towards `+y`.
    pub cl: Option<f64>,
    /// Moment coefficient at the end, positive nose up, about the axis across drag and lift.
    pub cm: Option<f64>,
    /// Axial coefficient at the end: force along `+x`, where the scene states an incidence.
    pub ca: Option<f64>,
    /// Normal coefficient at the end: force along `+y`, where the scene states an incidence.
    pub cn: Option<f64>,
    /// Drag coefficient, time mean from `mean_from` to the end.
    pub cd_mean: Option<f64>,
    /// Lift coefficient, time mean from `mean_from` to the end.
    pub cl_mean: Option<f64>,
    /// Moment coefficient, time mean from `mean_from` to the end.
    pub cm_mean: Option<f64>,
    /// Axial coefficient, time mean from `mean_from` to the end.
    pub ca_mean: Option<f64>,
    /// Normal coefficient, time mean from `mean_from` to the end.
    pub cn_mean: Option<f64>,
    /// Force, time mean from `mean_from` to the end.
    pub force_mean: [f64; 3],
    /// Standard deviation of the force's components over the same time.
    pub force_spread: [f64; 3],
    /// What that is of the force at the end, less that of the free stream's pressure, per cent: how far the loads are settled.
    pub settled_percent: f64,
    /// Start of the time means.
    pub mean_from: f64,
    /// Area (3D) or length (2D) that the coefficients refer to.
    pub reference_area: f64,
    /// Length that the moment coefficients refer to besides.
    pub reference_length: f64,
    /// Point that moments refer to.
    pub moment_centre: [f64; 3],
    /// Part of the surface farther than 1.25 spacings from every ghost, per cent.
    pub uncovered_area_percent: f64,
}
