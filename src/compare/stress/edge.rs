//! A sharp trailing edge: the wall's pressure where the body ends in nothing, and the shock that brings the
//! gas back to the stream's direction.

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

const EDGE: Source = scene!("stress", "sharp-trailing-edge");
const THEORY: &str = "shock-expansion theory";
const MACH: f64 = 2.5;
/// Half the angle of either edge, degrees.
const HALF_ANGLE: f64 = 10.0;
/// Height of the body to either side, chords, which is also its rise over half the chord.
const HEIGHT: f64 = 0.088_163_49;
/// Lift coefficient of 0.03 degrees of incidence.
const NO_LIFT: f64 = 1e-3;

/// Pressures over the stream's on the panels of either side and behind the edge, and the angle from the
/// stream of the shock that leaves the edge.
struct Exact {
    front: f64,
    rear: f64,
    wake: f64,
    shock: f64,
}

/// A shock, a fan of twice the turn and a shock. What the leading shock and the trailing one send back meets
/// the flow behind the body.
fn exact() -> Result<Exact, CompareError> {
    let turn = HALF_ANGLE.to_radians();
    let front = oblique_shock(MACH, turn, GAMMA, Strength::Weak)?;
    let fan = expand(front.mach, 2.0 * turn, GAMMA)?;
    let tail = oblique_shock(fan.mach, turn, GAMMA, Strength::Weak)?;
    let rear = front.pressure_ratio * fan.pressure_ratio;
    Ok(Exact {
        front: front.pressure_ratio,
        rear,
        wake: rear * tail.pressure_ratio,
        shock: (tail.angle - turn).to_degrees(),
    })
}

/// The wall before the edge, the flow behind it, lift and drag.
pub(super) fn compare(scheme: Scheme, context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let exact = exact()?;
    Trial::new(EDGE, scheme).compare(context, |outcome| {
        let of = |measure: &dyn Fn(&Outcome) -> f64| outcome.map_or(f64::NAN, measure);
        let near = |quantity: &str, measured: f64, reference: f64, allowed: f64| {
            Row::relative(quantity, THEORY, measured, reference, allowed)
        };
        let body = outcome.map(|o| &o.summary.bodies["edge"]);
        let mean = |value: Option<f64>| value.unwrap_or(f64::NAN);
        let below = of(&|o| last_tenth(o, -1.0)) / PRESSURE;
        let above = of(&|o| last_tenth(o, 1.0)) / PRESSURE;
        let lift = mean(body.and_then(|b| b.cl_mean)).abs();
        // Both sides, each with two panels that rise and fall by its height.
        let drag = 4.0 * HEIGHT * (exact.front - exact.rear) / (GAMMA * MACH * MACH);
        Ok(vec![
            near("p/p1 on the last tenth below", below, exact.rear, 5.0),
            near("p/p1 on the last tenth above", above, exact.rear, 5.0),
            near(
                "p/p1 behind the edge",
                of(&wake) / PRESSURE,
                exact.wake,
                3.0,
            ),
            near(
                "angle of the trailing shock, half-jump, deg",
                of(&|o| trailing_shock(o, &exact)),
                exact.shock,
                5.0,
            ),
            Row::at_most("lift coefficient, size", "symmetry", lift, NO_LIFT),
            near(
                "drag coefficient",
                mean(body.and_then(|b| b.cd_mean)),
                drag,
                5.0,
            ),
            Row::at_most(
                "particles in the body",
                "a wall is a wall",
                of(&|o| o.summary.leaked as f64),
                0.0,
            ),
        ])
    })
}

/// Median pressure on the last tenth of the side that faces `up` (1) or down (-1).
fn last_tenth(outcome: &Outcome, up: f64) -> f64 {
    let surface = &outcome.surface;
    let chosen = (0..surface.pressure.len())
        .filter(|&i| surface.position[i][0] > 0.9 && surface.normal[i][1] * up > 0.0);
    median(chosen.map(|i| surface.pressure[i]))
}

/// Median pressure behind the edge.
fn wake(outcome: &Outcome) -> f64 {
    let gas = &outcome.gas;
    let is_wake = |p: &[f64; 3]| (1.3..1.55).contains(&p[0]) && p[1].abs() < 0.05;
    let chosen = (0..gas.pressure.len()).filter(|&i| is_wake(&gas.position[i]));
    median(chosen.map(|i| gas.pressure[i]))
}

/// Angle from the stream at which the pressure passes half of the trailing shock's jump, degrees.
fn trailing_shock(outcome: &Outcome, exact: &Exact) -> f64 {
    let gas = &outcome.gas;
    let middle = 0.5 * (exact.rear + exact.wake);
    let part = 0.15 * (exact.wake - exact.rear);
    // The fan, farther out, passes through the same pressures.
    let slope = |p: &[f64; 3]| p[1].abs() / (p[0] - 1.0);
    let chosen = (0..gas.pressure.len()).filter(|&i| {
        let at = &gas.position[i];
        (1.25..1.55).contains(&at[0])
            && slope(at) < 0.5
            && (gas.pressure[i] / PRESSURE - middle).abs() < part
    });
    median(chosen.map(|i| slope(&gas.position[i]).atan().to_degrees()))
}
