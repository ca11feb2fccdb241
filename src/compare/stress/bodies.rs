//! Bodies that ask much: convex corners next to vacuum, a blunt nose at Mach 20, wedges on either side
//! of the angle at which their shock leaves them, a plate thinner than the kernel.

use aero_validation::exact::normal::pitot_pressure_ratio;
use aero_validation::exact::oblique::detachment;
use aero_validation::exact::prandtl_meyer::expand;
use aero_validation::table::Check;

use super::schemes::{GAMMA, PRESSURE, schemes};
use super::trial::Trial;
use super::{base, edge, plate};
use crate::context::{CompareError, Context};
use crate::profiles::median;
use crate::row::Row;
use crate::scenes::{Source, scene};
use crate::variant::Scheme;
use crate::wedge::SCENE as WEDGE;

const CORNER: Source = scene!("stress", "expansion-corner");
const BLUNT: Source = scene!("stress", "blunt-body");

/// Runs the bodies by all schemes of the level.
pub fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let mut checks = Vec::new();
    for scheme in schemes(context.level) {
        for (mach, turn) in [(2.0, 20.0), (3.0, 45.0)] {
            checks.extend(corner([mach, turn], scheme, context)?);
        }
        checks.extend(blunt(scheme, context)?);
        for angle in [29.0, 31.0] {
            checks.extend(wedge(angle, scheme, context)?);
        }
        checks.extend(plate::compare(scheme, context)?);
        checks.extend(edge::compare(scheme, context)?);
        checks.extend(base::compare(scheme, context)?);
    }
    Ok(checks)
}

/// Pressure behind the fan of a convex corner.
fn corner(
    [mach, turn]: [f64; 2],
    scheme: Scheme,
    context: &Context<'_>,
) -> Result<Vec<Check>, CompareError> {
    let fan = expand(mach, turn.to_radians(), GAMMA)?;
    let trial = Trial::new(CORNER, scheme)
        .called(format!("M {mach}, {turn} deg, {scheme}"))
        .with([
            format!("free_stream.mach={mach}"),
            format!("body.corner.shape.expansion_corner.angle={turn}"),
        ]);
    trial.compare(context, |outcome| {
        // Along the wall behind the fan, thirty spacings and more from the corner.
        let turn = turn.to_radians();
        let wall = outcome.map_or(f64::NAN, |o| {
            let surface = &o.surface;
            let along = |p: &[f64; 3]| p[0] * turn.cos() - p[1] * turn.sin();
            let chosen = (0..surface.pressure.len())
                .filter(|&i| (1.5..2.4).contains(&along(&surface.position[i])));
            median(chosen.map(|i| surface.pressure[i]))
        });
        Ok(vec![Row::relative(
            "p2/p1 on the wall",
            "Prandtl-Meyer",
            wall / PRESSURE,
            fan.pressure_ratio,
            5.0,
        )])
    })
}

/// Stagnation pressure of a nose at Mach 20, and the entropy of the gas that has not met its shock.
fn blunt(scheme: Scheme, context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    Trial::new(BLUNT, scheme).compare(context, |outcome| {
        let stagnation = outcome.map_or(f64::NAN, |o| {
            let surface = &o.surface;
            let near = (0..surface.pressure.len())
                .filter(|&i| surface.position[i][1].abs() < 0.1 && surface.position[i][0] < 0.0);
            median(near.map(|i| surface.pressure[i]))
        });
        let change = outcome.map_or(f64::NAN, |o| {
            let gas = &o.gas;
            (0..gas.density.len())
                // The shock stands at -1.4, and its kernels reach 0.25 ahead.
                .filter(|&i| gas.position[i][0] < -1.75)
                .map(|i| (gas.pressure[i] / PRESSURE / gas.density[i].powf(GAMMA) - 1.0).abs())
                .fold(0.0, f64::max)
        });
        Ok(vec![
            Row::relative(
                "stagnation pressure",
                "Rayleigh's pitot formula",
                stagnation / PRESSURE,
                pitot_pressure_ratio(20.0, GAMMA),
                3.0,
            ),
            Row::at_most(
                "entropy ahead of the shock, largest change",
                "it is that of the stream",
                change,
                1e-6,
            ),
        ])
    })
}

/// A wedge of Mach 2.5, whose shock leaves it at 29.8 degrees.
fn wedge(angle: f64, scheme: Scheme, context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let limit = detachment(2.5, GAMMA)?.deflection.to_degrees();
    let word = if angle < limit {
        "attached"
    } else {
        "detached"
    };
    let trial = Trial::new(WEDGE, scheme)
        .called(format!("M 2.5, {angle} deg ({word}), {scheme}"))
        .with([format!("body.ramp.shape.compression_corner.angle={angle}")]);
    trial.compare(context, |_| Ok(Vec::new()))
}
