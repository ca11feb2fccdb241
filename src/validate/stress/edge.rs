//! A sharp trailing edge: the wall's pressure where the body ends in nothing, and the shock that brings the
//! gas back to the stream's direction.

use aero_validation::exact::oblique::{Strength, oblique_shock};
use aero_validation::exact::prandtl_meyer::expand;
use aero_validation::table::Check;

use super::rows::{Rows, ended, median};
use super::{Context, GAMMA, PRESSURE, ValidateError, variant};
use crate::validate::outcome::{Outcome, Source, attempt};

const EDGE: Source = source!("sharp-trailing-edge");
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
fn exact() -> Result<Exact, ValidateError> {
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
pub(super) fn compare(
    scheme: [&str; 2],
    context: &Context<'_>,
) -> Result<Vec<Check>, ValidateError> {
    let [equations, extrapolation] = scheme;
    let label = format!("{equations} {extrapolation}");
    let tried = attempt(EDGE, &variant(equations, extrapolation), context)?;
    let mut rows = Rows::new(EDGE.name, &label, equations, &tried);
    let exact = exact()?;
    let outcome = ended(tried);
    let of = |measure: &dyn Fn(&Outcome) -> f64| outcome.as_deref().map_or(f64::NAN, measure);

    for (name, side) in [("below", -1.0), ("above", 1.0)] {
        let last = of(&|o| {
            let surface = &o.surface;
            let chosen = (0..surface.pressure.len())
                .filter(|&i| surface.position[i][0] > 0.9 && surface.normal[i][1] * side > 0.0);
            median(chosen.map(|i| surface.pressure[i]).collect())
        });
        let quantity = format!("p/p1 on the last tenth {name}");
        rows.relative(&quantity, THEORY, [last / PRESSURE, exact.rear, 5.0]);
    }
    let wake = of(&|o| {
        let gas = &o.gas;
        let is_wake = |p: &[f64; 3]| (1.3..1.55).contains(&p[0]) && p[1].abs() < 0.05;
        let chosen = (0..gas.pressure.len()).filter(|&i| is_wake(&gas.position[i]));
        median(chosen.map(|i| gas.pressure[i]).collect())
    });
    rows.relative(
        "p/p1 behind the edge",
        THEORY,
        [wake / PRESSURE, exact.wake, 3.0],
    );
    let middle = 0.5 * (exact.rear + exact.wake);
    let part = 0.15 * (exact.wake - exact.rear);
    let shock = of(&|o| {
        let gas = &o.gas;
        // The fan, farther out, passes through the same pressures.
        let slope = |p: &[f64; 3]| p[1].abs() / (p[0] - 1.0);
        let chosen = (0..gas.pressure.len()).filter(|&i| {
            let place = &gas.position[i];
            (1.25..1.55).contains(&place[0])
                && slope(place) < 0.5
                && (gas.pressure[i] / PRESSURE - middle).abs() < part
        });
        let angles = chosen.map(|i| slope(&gas.position[i]).atan().to_degrees());
        median(angles.collect())
    });
    rows.relative(
        "angle of the trailing shock, half-jump, deg",
        THEORY,
        [shock, exact.shock, 5.0],
    );

    let body = outcome.as_deref().map(|o| &o.summary.bodies["edge"]);
    let mean = |value: Option<f64>| value.unwrap_or(f64::NAN);
    rows.at_most(
        "lift coefficient, size",
        "symmetry",
        [mean(body.and_then(|b| b.cl_mean)).abs(), NO_LIFT],
    );
    // Both sides, each with two panels that rise and fall by its height.
    let drag = 4.0 * HEIGHT * (exact.front - exact.rear) / (GAMMA * MACH * MACH);
    rows.relative(
        "drag coefficient",
        THEORY,
        [mean(body.and_then(|b| b.cd_mean)), drag, 5.0],
    );
    let leaked = of(&|o| o.summary.leaked as f64);
    rows.at_most("particles in the body", "a wall is a wall", [leaked, 0.0]);
    Ok(rows.checks)
}
