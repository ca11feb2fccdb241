//! What one run of a flight has shown.

use std::path::{Path, PathBuf};

use aero_geometry::Vector;
use aero_geometry::parallel::prelude::*;
use serde::Serialize;

use super::error::FlyError;
use super::flight::Flight;
use super::lee::Lee;
use super::read::{self, Cells};
use crate::output::Summary;

/// What faces away from the stream by more than so many degrees, with nothing of the body behind it, is base: real gas does not follow such a
/// turn, and what an inviscid one does there has no exact answer. The front of a groove belongs to its back.
pub const BASE: f64 = 25.0;

/// Rows of the history, at its end, over which loads are looked at.
const ROWS: usize = 150;

/// Coefficients of a body.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Coefficients {
    /// Drag.
    pub cd: f64,
    /// Drag of what does not face away from the stream.
    pub cd_forebody: f64,
    /// Drag of what does.
    pub cd_base: f64,
    /// Lift.
    pub cl: f64,
    /// Moment, positive nose up.
    pub cm: f64,
    /// Force to the right of the body, `-z`, over that of the dynamic pressure on the reference area.
    pub cy: f64,
    /// Moment about the body's own axis upwards, positive nose right.
    pub cn_yaw: f64,
    /// Moment about the body's own length, positive right side down.
    pub cl_roll: f64,
}

/// A run at one spacing.
#[derive(Clone, Debug, Serialize)]
pub struct Level {
    /// Spacing of the lattice.
    pub spacing: f64,
    /// The smallest one near body and shocks, noses and edges aside where these have smaller ones.
    pub finest: f64,
    /// Folder with what the run has written.
    pub folder: PathBuf,
    /// Points or particles.
    pub points: usize,
    /// Steps or iterations.
    pub steps: u64,
    /// Wall time, s.
    pub wall_seconds: f64,
    /// Processor time, s.
    pub cpu_seconds: f64,
    /// True where loads came to rest, be it in the mean.
    pub settled: bool,
    /// How the run ended.
    pub end: String,
    /// Coefficients, means where the flow swings.
    #[serde(flatten)]
    pub coefficients: Coefficients,
    /// Half of what they went on to swing by.
    pub swing: Coefficients,
    /// Part of a load that an uneven surface may cost: what is left of the sum of all normals.
    pub open: f64,
    /// Area of the base, over the reference area.
    pub base_area: f64,
    /// How far off the line of the moments the middle of the base lies, up and aside, over the reference length.
    #[serde(skip)]
    pub base_arms: [f64; 2],
    /// Warnings of the run.
    #[serde(skip)]
    pub warnings: Vec<String>,
    /// Sides of the box that were too near for it, axis and end; not those that a wake leaves by, which hardly matter ahead of it.
    #[serde(skip)]
    pub near_sides: Vec<(usize, usize)>,
}

impl Level {
    /// Reads what the run at `spacing` has left in `folder`.
    ///
    /// # Errors
    /// Files that are not there.
    pub fn read(
        flight: &Flight,
        folder: &Path,
        spacing: f64,
        summary: &Summary,
    ) -> Result<Self, FlyError> {
        let body = summary
            .bodies
            .get(&flight.name)
            .ok_or_else(|| FlyError::Files(format!("`{}` holds no loads", folder.display())))?;
        let parts = parts_of_run(flight, folder)?;
        let history = read::history(&folder.join("history.csv"))?;
        let swing = |key: &str| {
            let rows = history.get(&format!("{}.{key}", flight.name));
            half_range(rows.map_or(&[][..], Vec::as_slice))
        };
        let now = body.cd.unwrap_or(f64::NAN);
        let mean = body.cd_mean.unwrap_or(now);
        // The wake swings, the front does not.
        let cd_forebody = parts.forebody;
        let level = flight.dimension() == 2;
        let or_none = |value: Option<f64>| {
            if level {
                0.0
            } else {
                value.unwrap_or(f64::NAN)
            }
        };
        // Nose upstream along -x, right side along -z, down along -y: the usual axes of a body.
        let scale = -1.0 / (flight.dynamic_pressure() * flight.area);
        let has_sides = !level && !flight.mirrors().contains(&2);
        let aside = |axis: usize, load: &[f64; 3]| {
            if has_sides { scale * load[axis] } else { 0.0 }
        };
        let turn = |axis: usize, load: &[f64; 3]| aside(axis, load) / flight.reference_length();
        let finest = summary.points_per_level.len().saturating_sub(1);
        let finest = finest.min(usize::from(flight.body_halvings()));
        let swing_cd = swing("cd");
        Ok(Self {
            spacing,
            finest: spacing / f64::from(1_u32 << finest),
            folder: folder.to_owned(),
            points: summary.particles.fluid,
            steps: summary.steps,
            wall_seconds: summary.wall_seconds,
            cpu_seconds: summary.cpu_seconds,
            settled: summary.stop_reason.starts_with("settled")
                || summary.stop_reason.starts_with("steady"),
            end: summary.stop_reason.clone(),
            coefficients: Coefficients {
                cd: mean,
                cd_forebody,
                cd_base: parts.base_of(mean),
                cl: or_none(body.cl_mean.or(body.cl)),
                cm: or_none(body.cm_mean.or(body.cm)),
                cy: aside(2, &body.force_gauge),
                cn_yaw: turn(1, &body.moment_gauge),
                cl_roll: turn(0, &body.moment_gauge),
            },
            swing: Coefficients {
                cd: swing_cd,
                cd_forebody: if parts.base_area > 0.0 {
                    0.1 * swing_cd
                } else {
                    swing_cd
                },
                cd_base: swing_cd,
                cl: if level { 0.0 } else { swing("cl") },
                cm: if level { 0.0 } else { swing("cm") },
                cy: aside(2, &[0.0, 0.0, swing("fz")]),
                cn_yaw: turn(1, &[0.0, swing("my"), 0.0]),
                cl_roll: turn(0, &[swing("mx"), 0.0, 0.0]),
            },
            open: parts.open,
            base_area: parts.base_area,
            base_arms: parts.base_arms,
            warnings: summary.warnings.iter().map(ToString::to_string).collect(),
            near_sides: summary.warnings.iter().filter_map(|w| w.side).collect(),
        })
    }
}

/// Drag of forebody and base, and where the force across the body stands, of one run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shares {
    /// Drag of what does not face away from the stream.
    pub cd_forebody: f64,
    /// Drag of what does.
    pub cd_base: f64,
    /// Behind the nose, in lengths of the body; none without a force across it.
    pub centre_of_pressure: Option<f64>,
}

impl Shares {
    /// Of drag, lift and moment of the run whose files are in `folder`.
    ///
    /// # Errors
    /// Files that are not there.
    pub fn read(flight: &Flight, folder: &Path, [cd, cl, cm]: [f64; 3]) -> Result<Self, FlyError> {
        let parts = parts_of_run(flight, folder)?;
        let whole = Coefficients {
            cd,
            cl,
            cm,
            ..Coefficients::default()
        };
        Ok(Self {
            cd_forebody: parts.forebody,
            cd_base: parts.base_of(cd),
            centre_of_pressure: centre(flight, &whole),
        })
    }
}

/// What is summed over the last surface in `folder`.
fn parts_of_run(flight: &Flight, folder: &Path) -> Result<Parts, FlyError> {
    let path = read::last(folder, "surface-")
        .ok_or_else(|| FlyError::Files(format!("`{}` holds no surface", folder.display())))?;
    Ok(parts(flight, &read::surface(&path)?))
}

/// What is summed over a surface.
struct Parts {
    forebody: f64,
    base_area: f64,
    base_arms: [f64; 2],
    open: f64,
}

impl Parts {
    /// What the base has of the drag `cd`.
    fn base_of(&self, cd: f64) -> f64 {
        if self.base_area > 0.0 {
            cd - self.forebody
        } else {
            0.0
        }
    }
}

/// Drag of the forebody, area of the base, and what normals leave.
fn parts(flight: &Flight, surface: &Cells) -> Parts {
    let [up, aside] = [flight.wishes.incidence, flight.wishes.sideslip].map(f64::to_radians);
    let way = [up.cos() * aside.cos(), up.sin() * aside.cos(), aside.sin()];
    let column = |name: &str| surface.arrays.get(name).map_or(&[][..], Vec::as_slice);
    let (cp, area, normal) = (
        column("pressure_coefficient"),
        column("area"),
        column("normal"),
    );
    let body = column("body");
    let images = f64::from(1_u32 << flight.mirrors().len());
    let (mut forebody, mut base_area, mut base_moments) = (0.0, 0.0, [0.0; 2]);
    let (mut sum, mut total) = (0.0, 0.0);
    let across = flight.centre_across();
    let steep = BASE.to_radians().sin();
    let lee = Lee::new(flight.shape.as_ref(), way, steep);
    let normal_of = |n: usize| Vector::<3>::from_fn(|k, _| normal[3 * n + k]);
    let is_open: Vec<bool> = (0..area.len())
        .into_par_iter()
        .map(|n| {
            let along: f64 = (0..3).map(|k| normal[3 * n + k] * way[k]).sum();
            along > steep && lee.is_open(&middle(&surface.corners[n]), &normal_of(n))
        })
        .collect();
    for n in 0..area.len() {
        if body.get(n).is_some_and(|number| *number != 0.0) {
            continue;
        }
        let along: f64 = (0..3).map(|k| normal[3 * n + k] * way[k]).sum();
        if is_open[n] {
            let part = images * area[n] * along / flight.area;
            base_area += part;
            let middle = middle(&surface.corners[n]);
            for (k, moment) in base_moments.iter_mut().enumerate() {
                *moment += part * (middle[k + 1] - across[k]);
            }
        } else {
            forebody -= images * cp[n] * along * area[n] / flight.area;
        }
        sum += normal[3 * n] * area[n];
        total += normal[3 * n].abs() * area[n];
    }
    // What is mirrored, or turned about the axis, has its middle there.
    let base_arms = [1, 2].map(|axis| {
        let is_on_axis = flight.dimension() == 2 || flight.mirrors().contains(&axis);
        if is_on_axis || base_area == 0.0 {
            0.0
        } else {
            (base_moments[axis - 1] / (base_area * flight.reference_length())).abs()
        }
    });
    Parts {
        forebody,
        base_area,
        base_arms,
        open: (sum / f64::max(total, f64::MIN_POSITIVE)).abs(),
    }
}

/// The middle of a cell of the surface.
fn middle(corners: &[[f64; 3]]) -> Vector<3> {
    let sum: Vector<3> = corners.iter().copied().map(Vector::from).sum();
    sum / corners.len() as f64
}

/// Half the range of the last rows.
fn half_range(values: &[f64]) -> f64 {
    let rows = ROWS.min(values.len() / 4).max(20).min(values.len());
    let last = &values[values.len() - rows..];
    let most = last.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let least = last.iter().copied().fold(f64::INFINITY, f64::min);
    if most >= least {
        0.5 * (most - least)
    } else {
        0.0
    }
}

/// Where the force across the body would have to stand, behind the nose, in lengths: `x / L = (x_m - c_m L_ref / c_n) / L`.
pub(super) fn centre(flight: &Flight, c: &Coefficients) -> Option<f64> {
    /// Less is noise.
    const LEAST: f64 = 1e-3;
    if flight.dimension() == 2 {
        return None;
    }
    let angle = flight.wishes.incidence.to_radians();
    let across = c.cl * angle.cos() + c.cd * angle.sin();
    let place = (flight.centre() - c.cm * flight.reference_length() / across) / flight.length();
    (across.abs() > LEAST * c.cd.abs()).then_some(place)
}
