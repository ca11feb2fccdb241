//! A body that the gas moves: a diamond on a hinge swings in pitch, as the static moment of the gas says.

use std::f64::consts::PI;

use aero::run::{Keep, Outcome};
use aero_validation::exact::diamond::diamond;
use aero_validation::table::{Check, Subject};

use super::context::{CompareError, Context, Level};
use super::scenes::{Source, scene};
use super::suite::Suite;
use super::variant::Levels;

const NAME: &str = "free";
const SCENE: Source = scene!("pitching");
/// About the hinge, as in the scene.
const INERTIA: f64 = 7.2;
/// Angle that the moment is taken at, degrees.
const ANGLE: f64 = 1.5;
/// The hinge, parts of the chord behind the nose, the slope of the diamond's faces, and the Mach number.
const HINGE: f64 = 0.25;
const SLOPE: f64 = 0.1;
const MACH: f64 = 2.0;
const GAMMA: f64 = 1.4;

/// The swing.
pub const FREE_BODIES: Suite = Suite::of(&[(Levels::Both, compare)]);

fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let cells: &[u32] = match context.level {
        Level::Quick => &[40],
        Level::Full => &[40, 80],
    };
    let mut checks = Vec::new();
    for cells in cells {
        checks.extend(swing(*cells, context)?);
    }
    Ok(checks)
}

fn swing(cells: u32, context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let spacing = format!("spacing={:?}", 1.0 / f64::from(cells));
    let label = |what: &str| format!("diamond on a hinge, chord/{cells}: {what}");
    let still = [
        spacing.clone(),
        "end_time=3.0".into(),
        format!("body.diamond.place={{ rotate = {:?} }}", -ANGLE),
        "body.diamond.motion={}".into(),
    ];
    let held = SCENE.run(&still, Keep::End, context)?;
    let moment = held.summary.bodies["diamond"].cm_mean.unwrap_or(f64::NAN);
    // Nose up is positive, and the body lies nose up: what brings it back is negative.
    let pressure = 0.5 * MACH * MACH;
    let stiffness = -moment * pressure / ANGLE.to_radians();
    let exact = diamond(SLOPE.atan(), MACH, ANGLE.to_radians(), GAMMA)?;
    let theory = -exact.moment(HINGE) * pressure / ANGLE.to_radians();
    let free = SCENE.run(&[spacing], Keep::Loads, context)?;
    let wanted = PI * (INERTIA / stiffness).sqrt();
    let what = label("moment that brings it back, per radian");
    let slope = Subject::new(NAME, &what, "shocks and expansions");
    let what = label("time of half a swing");
    let time = Subject::new(NAME, &what, "the moment of the same body held at an angle");
    Ok(vec![
        slope.relative(stiffness, theory, moment_within(cells)),
        time.relative(half_swing(&free), wanted, 2.5),
    ])
}

/// Per cent: first order in the spacing.
fn moment_within(cells: u32) -> f64 {
    320.0 / f64::from(cells)
}

/// When it passes its middle again.
fn half_swing(outcome: &Outcome) -> f64 {
    let history = &outcome.history;
    let turns = history.motion.iter().map(|motion| motion.turn[2]);
    let passes: Vec<(f64, f64)> = history.time.iter().copied().zip(turns).collect();
    let back = (passes.windows(2)).find(|pair| pair[0].1 > 0.0 && pair[1].1 <= 0.0);
    back.map_or(f64::NAN, |pair| {
        let [(t0, a0), (t1, a1)] = [pair[0], pair[1]];
        t0 + (t1 - t0) * a0 / (a0 - a1)
    })
}
