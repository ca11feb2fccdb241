//! `NAME-pack.json`: the quality of all packings of one command.

use aero_packer::{PackReport, Packing};
use serde::Serialize;

/// The report: worst values and sums over the bodies at the top, then body by body.
#[derive(Clone, Debug, Serialize)]
pub struct PackFile {
    /// Where the spacing comes from.
    pub spacing_reason: String,
    /// All bodies together: sums of counts and times, the worst of each quality.
    #[serde(flatten)]
    pub total: PackReport,
    /// Body by body.
    pub bodies: Vec<BodyReport>,
}

/// The report of one body.
#[derive(Clone, Debug, Serialize)]
pub struct BodyReport {
    /// Its name.
    pub name: String,
    /// Its packing.
    #[serde(flatten)]
    pub report: PackReport,
}

impl PackFile {
    pub(super) fn new<const D: usize>(reason: &str, bodies: &[(String, Packing<D>)]) -> Self {
        let reports = bodies.iter().map(|(name, packing)| {
            let report = &packing.report;
            let warnings = report.warnings.iter();
            PackReport {
                // One body's warnings need not say whose they are.
                warnings: warnings
                    .map(|warning| match bodies.len() {
                        1 => warning.clone(),
                        _ => warning.of(name),
                    })
                    .collect(),
                ..report.clone()
            }
        });
        Self {
            spacing_reason: reason.to_owned(),
            total: reports.reduce(worse).unwrap_or_default(),
            bodies: bodies
                .iter()
                .map(|(name, packing)| BodyReport {
                    name: name.clone(),
                    report: packing.report.clone(),
                })
                .collect(),
        }
    }
}

/// Two bodies as one: counts and times add, of each quality the worse counts.
fn worse(a: PackReport, b: PackReport) -> PackReport {
    let farther = |x: f64, y: f64| if y.abs() > x.abs() { y } else { x };
    let either = |x: Option<f64>, y: Option<f64>| match (x, y) {
        (Some(x), Some(y)) => Some(x.max(y)),
        _ => x.or(y),
    };
    let mut layer_counts = a.layer_counts;
    layer_counts.resize(layer_counts.len().max(b.layer_counts.len()), 0);
    for (sum, count) in layer_counts.iter_mut().zip(&b.layer_counts) {
        *sum += count;
    }
    PackReport {
        spacing: a.spacing.max(b.spacing),
        ghosts: a.ghosts + b.ghosts,
        fluid: a.fluid + b.fluid,
        layer_counts,
        density_std_percent: a.density_std_percent.max(b.density_std_percent),
        density_max_at: if b.density_max_percent > a.density_max_percent {
            b.density_max_at
        } else {
            a.density_max_at
        },
        density_max_percent: a.density_max_percent.max(b.density_max_percent),
        shell_volume_error_percent: farther(
            a.shell_volume_error_percent,
            b.shell_volume_error_percent,
        ),
        wall_offset_max: a.wall_offset_max.max(b.wall_offset_max),
        normal_error_max_deg: either(a.normal_error_max_deg, b.normal_error_max_deg),
        min_gap: a.min_gap.min(b.min_gap),
        coincident_ghosts: a.coincident_ghosts + b.coincident_ghosts,
        layer_hole_max: a.layer_hole_max.max(b.layer_hole_max),
        hole_at: if b.hole_max > a.hole_max {
            b.hole_at
        } else {
            a.hole_at
        },
        hole_max: a.hole_max.max(b.hole_max),
        uncovered_area_percent: {
            let area = (a.surface_area + b.surface_area).max(f64::MIN_POSITIVE);
            let open = |percent: f64, of: f64| percent * of / area;
            open(a.uncovered_area_percent, a.surface_area)
                + open(b.uncovered_area_percent, b.surface_area)
        },
        surface_area: a.surface_area + b.surface_area,
        volume_error_percent: farther(a.volume_error_percent, b.volume_error_percent),
        thin: a.thin + b.thin,
        mirror_error_max: either(a.mirror_error_max, b.mirror_error_max),
        wall_seconds: a.wall_seconds + b.wall_seconds,
        repairs: [a.repairs, b.repairs].concat(),
        warnings: [a.warnings, b.warnings].concat(),
    }
}
