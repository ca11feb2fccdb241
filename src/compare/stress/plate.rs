//! A plate thinner than the kernel at incidence: pressure on its flat parts, lift and drag.

use aero::run::Outcome;
use aero_validation::exact::oblique::{Strength, oblique_shock};
use aero_validation::exact::prandtl_meyer::expand;
use aero_validation::table::Check;

use super::schemes::{GAMMA, PRESSURE};
use super::trial::Trial;
use crate::context::{CompareError, Context};
use crate::profiles::median;
use crate::row::Row;
use crate::scenes::{Source, scene};
use crate::variant::Scheme;

pub(super) const PLATE: Source = scene!("stress", "thin-plate");
pub(super) const THEORY: &str = "shock-expansion theory";
pub(super) const MACH: f64 = 2.0;
/// Degrees.
pub(super) const INCIDENCE: f64 = 5.0;
/// Half the plate's thickness, and the length of its edges, in chords.
pub(super) const EDGE: [f64; 2] = [0.02, 0.12];

/// A panel of one side of the plate: pressure over the stream's, extent along the chord, rise towards the gas.
struct Panel {
    pressure: f64,
    length: f64,
    rise: f64,
}

/// The panels of the side of a plate of half the thickness `half` that is turned into the stream by `incidence`, from the leading edge: a
/// shock or a fan at the edge, a fan at each corner (shock-expansion theory).
fn side(mach: f64, incidence: f64, half: f64) -> Result<[Panel; 3], CompareError> {
    let edge = EDGE[1];
    let slope = half.atan2(edge);
    // The gas above a plate thinner than this incidence asks for turns away at the leading edge.
    let turn = slope + incidence;
    let (behind, nose) = if turn > 0.0 {
        let shock = oblique_shock(mach, turn, GAMMA, Strength::Weak)?;
        (shock.mach, shock.pressure_ratio)
    } else {
        let fan = expand(mach, -turn, GAMMA)?;
        (fan.mach, fan.pressure_ratio)
    };
    let first = expand(behind, slope, GAMMA)?;
    let second = expand(first.mach, slope, GAMMA)?;
    let flat = nose * first.pressure_ratio;
    let panel = |pressure, length, rise| Panel {
        pressure,
        length,
        rise,
    };
    Ok([
        panel(nose, edge, half),
        panel(flat, 1.0 - 2.0 * edge, 0.0),
        panel(flat * second.pressure_ratio, edge, -half),
    ])
}

/// Lift and drag coefficients of a plate of half the thickness `half`, in chords.
pub(super) fn coefficients(half: f64) -> Result<(f64, f64), CompareError> {
    let incidence = INCIDENCE.to_radians();
    let (sin, cos) = incidence.sin_cos();
    let windward = side(MACH, incidence, half)?;
    let leeward = side(MACH, -incidence, half)?;
    let over = |panel: &Panel| panel.pressure - 1.0;
    let lift = |side: &[Panel; 3]| side.iter().map(|p| over(p) * p.length).sum::<f64>();
    let push = |side: &[Panel; 3]| side.iter().map(|p| over(p) * p.rise).sum::<f64>();
    let scale = 2.0 / (GAMMA * MACH * MACH);
    let normal = scale * (lift(&windward) - lift(&leeward));
    let axial = scale * (push(&windward) + push(&leeward));
    Ok((normal * cos - axial * sin, normal * sin + axial * cos))
}

/// Pressure on the flat parts, lift and drag; no gas may go through the plate.
pub(super) fn compare(scheme: Scheme, context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let incidence = INCIDENCE.to_radians();
    let (windward, leeward) = (
        side(MACH, incidence, EDGE[0])?,
        side(MACH, -incidence, EDGE[0])?,
    );
    let (lift, drag) = coefficients(EDGE[0])?;
    Trial::new(PLATE, scheme).compare(context, |outcome| {
        let body = outcome.map(|o| &o.summary.bodies["plate"]);
        let mean = |value: Option<f64>| value.unwrap_or(f64::NAN);
        let near = |quantity: &str, measured: f64, exact: f64, allowed: f64| {
            Row::relative(quantity, THEORY, measured, exact, allowed)
        };
        let below = flat_pressure(outcome, -1.0) / PRESSURE;
        let above = flat_pressure(outcome, 1.0) / PRESSURE;
        Ok(vec![
            near(
                "p/p1 on the flat part below",
                below,
                windward[1].pressure,
                3.0,
            ),
            near(
                "p/p1 on the flat part above",
                above,
                leeward[1].pressure,
                3.0,
            ),
            near(
                "lift coefficient",
                mean(body.and_then(|b| b.cl_mean)),
                lift,
                5.0,
            ),
            near(
                "drag coefficient",
                mean(body.and_then(|b| b.cd_mean)),
                drag,
                5.0,
            ),
            Row::at_most(
                "particles in the plate",
                "a wall is a wall",
                outcome.map_or(f64::NAN, |o| o.summary.leaked as f64),
                0.0,
            ),
        ])
    })
}

/// Median pressure on the flat part that faces `up` (1) or down (-1), behind the waves that the corner of
/// the leading edge sends to the shock and back.
fn flat_pressure(outcome: Option<&Outcome>, up: f64) -> f64 {
    let (sin, cos) = INCIDENCE.to_radians().sin_cos();
    let is_flat = |p: &[f64; 3]| (0.5..0.8).contains(&(p[0] * cos - p[1] * sin));
    outcome.map_or(f64::NAN, |o| {
        let wall = &o.surface;
        let chosen = (0..wall.pressure.len())
            .filter(|&i| is_flat(&wall.position[i]) && wall.normal[i][1] * up > 0.0);
        median(chosen.map(|i| wall.pressure[i]))
    })
}
