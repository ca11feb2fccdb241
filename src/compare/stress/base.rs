//! The base flow of an entry capsule: the gas behind the shoulder is a few per cent of the stream's.

use aero_solver::frame::SurfaceFrame;
use aero_validation::table::Check;

use super::schemes::GAMMA;
use super::trial::Trial;
use crate::context::{CompareError, Context};
use crate::row::Row;
use crate::scenes::{Source, scene};
use crate::variant::Scheme;

const CAPSULE: Source = scene!("apollo-axisymmetric");
/// Largest radius of the body, m.
const RADIUS: f64 = 1.9558;
/// Mean pressure coefficient of what faces downstream, at Mach 2.5.
const VOLUMES: f64 = -0.172;

/// One stream.
struct Stream {
    mach: f64,
    /// The flow is steady from the tenth length of the body on.
    settings: &'static [&'static str],
    volumes: Option<f64>,
}

const STREAMS: [Stream; 2] = [
    Stream {
        mach: 2.5,
        settings: &["end_time=0.06"],
        volumes: Some(VOLUMES),
    },
    // At 0.1 m the shoulder is two spacings: its shock layer reaches a fifth down the cone behind it, and the
    // pressure there is above the stream's.
    Stream {
        mach: 10.0,
        settings: &["end_time=0.008", "spacing=0.05", "domain.max=[6.0, 5.0]"],
        volumes: None,
    },
];

/// Whether the wake is survived, and the base's pressure.
pub(super) fn compare(scheme: Scheme, context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let mut checks = Vec::new();
    for stream in &STREAMS {
        let mach = stream.mach;
        let trial = Trial::new(CAPSULE, scheme)
            .called(format!("base flow, M {mach}, {scheme}"))
            .with([format!("free_stream.mach={mach}")])
            .with(stream.settings.iter().map(ToString::to_string));
        checks.extend(trial.compare(context, |outcome| {
            let base = outcome.map_or(f64::NAN, |o| base_pressure(&o.surface));
            let vacuum = -2.0 / (GAMMA * mach * mach);
            let quantity = "base pressure coefficient";
            let mut rows = vec![Row::absolute(
                quantity,
                "between a vacuum's and the stream's",
                base,
                0.5 * vacuum,
                -0.5 * vacuum,
            )];
            if let Some(volumes) = stream.volumes {
                let source = "finite volumes, second order, axisymmetric (validation/apollo)";
                rows.push(Row::informs(quantity, source, base, volumes));
            }
            let leaked = outcome.map_or(f64::NAN, |o| o.summary.leaked as f64);
            rows.push(Row::at_most(
                "particles in the body",
                "a wall is a wall",
                leaked,
                0.0,
            ));
            Ok(rows)
        })?);
    }
    Ok(checks)
}

/// Mean pressure coefficient of the wall that faces downstream, over its area seen along the axis: every
/// point stands for the ring as far as half way to its neighbours.
fn base_pressure(surface: &SurfaceFrame) -> f64 {
    let facing = (0..surface.pressure.len()).filter(|&i| surface.normal[i][0] > 0.0);
    let mut rings: Vec<(f64, f64)> = facing
        .map(|i| (surface.position[i][1], surface.pressure_coefficient[i]))
        .collect();
    rings.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut inner = 0.0;
    let mut sum = 0.0;
    for (n, &(radius, coefficient)) in rings.iter().enumerate() {
        let outer = rings
            .get(n + 1)
            .map_or(RADIUS, |next| 0.5 * (radius + next.0));
        sum += coefficient * (outer * outer - inner * inner);
        inner = outer;
    }
    sum / (RADIUS * RADIUS)
}
