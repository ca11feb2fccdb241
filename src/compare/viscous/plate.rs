//! The laminar boundary layer of air along a flat plate, without heat through it or cold.

use aero::run::Outcome;
use aero_validation::exact::couette::air_viscosity;
use aero_validation::exact::flat_plate::{FlatPlate, Layer};
use aero_validation::table::{Check, Subject};

use super::{GAMMA, GAS_CONSTANT, NAME};
use crate::context::{CompareError, Context};
use crate::profiles::median;
use crate::scenes::{Source, scene};

const FASTER: Source = scene!("flat-plate");
/// The same, turned: no row of points lies along the plate.
const ASKEW: Source = scene!("flat-plate-askew");
/// Degrees that it is turned by.
const TURN: f64 = 20.0;
/// Than sound: a mirror leads up to the leading edge.
const SLOWER: Source = scene!("flat-plate-subsonic");
const THEORY: &str =
    "similar solution by Sutherland's law (White, Viscous Fluid Flow, section 7-4)";
/// As in the scene, K.
const TEMPERATURE: f64 = 220.0;
/// Per unit of length.
const REYNOLDS: f64 = 1e5;
/// Where friction and temperature are read.
const WINDOW: [f64; 2] = [0.9, 1.05];
/// Per cent.
const FRICTION: f64 = 3.0;
const RECOVERY: f64 = 1.0;

pub(super) fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let mut checks = Vec::new();
    for (mach, wall) in [
        (0.5, None),
        (2.0, None),
        (3.0, None),
        (2.0, Some(TEMPERATURE)),
        (3.0, Some(TEMPERATURE)),
    ] {
        checks.extend(of(mach, wall, context)?);
    }
    checks.extend(askew(context)?);
    Ok(checks)
}

/// Friction and heat of a cold plate that cuts cells askew.
fn askew(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let stream = Stream::new(3.0);
    let settings = [format!("free_stream.pressure={:?}", stream.pressure)];
    let layer = stream.plate(Some(TEMPERATURE)).layer();
    let attempt = ASKEW.attempt(&settings, context)?;
    let found = attempt
        .outcome()
        .map(|outcome| read(outcome, &stream, TURN));
    let row = |what: &str, found: Option<f64>, exact: f64| {
        let what = format!("plate turned by {TURN} degrees, M 3, {TEMPERATURE} K: {what}");
        let subject = Subject::new(NAME, &what, THEORY);
        found.map_or_else(
            || subject.unmeasured(exact),
            |found| subject.relative(found, exact, FRICTION),
        )
    };
    Ok(vec![
        row(
            "c_f sqrt(Re_x) sqrt(p / p_w)",
            found.map(|found| found.friction),
            layer.friction,
        ),
        row(
            "q_w sqrt(Re_x) sqrt(p / p_w) / (rho u c_p T)",
            found.map(|found| found.heat),
            layer.heat,
        ),
    ])
}

/// Air over a plate.
struct Stream {
    mach: f64,
    speed: f64,
    density: f64,
    pressure: f64,
}

impl Stream {
    fn new(mach: f64) -> Self {
        let speed = mach * (GAMMA * GAS_CONSTANT * TEMPERATURE).sqrt();
        let density = REYNOLDS * air_viscosity(TEMPERATURE) / speed;
        Self {
            mach,
            speed,
            density,
            pressure: density * GAS_CONSTANT * TEMPERATURE,
        }
    }

    fn plate(&self, wall: Option<f64>) -> FlatPlate {
        FlatPlate {
            mach: self.mach,
            temperature: TEMPERATURE,
            gamma: GAMMA,
            prandtl: 0.72,
            wall,
        }
    }
}

fn of(mach: f64, wall: Option<f64>, context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let stream = Stream::new(mach);
    let pressure = stream.pressure;
    let heat = wall.map_or(String::new(), |wall| format!(", temperature = {wall:?}"));
    let mut settings = vec![
        format!("free_stream.mach={mach:?}"),
        format!("free_stream.pressure={pressure:?}"),
    ];
    let source = if mach < 1.0 {
        settings.push(format!(
            "domain.sides.x_max={{ outlet = {{ pressure = {pressure:?} }} }}"
        ));
        SLOWER
    } else {
        settings.push(format!(
            "domain.sides.y_min={{ wall = {{ kind = \"no-slip\"{heat} }} }}"
        ));
        FASTER
    };
    let layer = stream.plate(wall).layer();
    let how = wall.map_or("adiabatic".to_owned(), |wall| format!("{wall} K"));
    let attempt = source.attempt(&settings, context)?;
    let found = attempt.outcome().map(|outcome| read(outcome, &stream, 0.0));
    let what = format!("plate, M {mach}, {how}: c_f sqrt(Re_x) sqrt(p / p_w)");
    let subject = Subject::new(NAME, &what, THEORY);
    let mut checks = vec![match &found {
        Some(found) => subject.relative(found.friction, layer.friction, FRICTION),
        None => subject.unmeasured(layer.friction),
    }];
    if wall.is_none() {
        let what = format!("plate, M {mach}, {how}: recovery factor");
        let subject = Subject::new(NAME, &what, THEORY);
        checks.push(match &found {
            Some(found) => {
                let kinetic = 0.5 * (GAMMA - 1.0) * mach * mach;
                subject.relative((found.wall - 1.0) / kinetic, layer.recovery, RECOVERY)
            }
            None => subject.unmeasured(layer.recovery),
        });
    }
    Ok(checks)
}

/// Friction and heat, with the pressure of the leading edge's shock taken out, and temperature of the wall in the window, of a plate `turned` so many
/// degrees.
fn read(outcome: &Outcome, stream: &Stream, turned: f64) -> Layer {
    let panels = &outcome.panels;
    let corners = panels.corners.max(1);
    let (sin, cos) = turned.to_radians().sin_cos();
    let middle = |n: usize| {
        let own = &panels.points[n * corners..(n + 1) * corners];
        own.iter().map(|point| point[0]).sum::<f64>() / corners as f64 / cos
    };
    let chosen: Vec<usize> = (0..panels.body.len())
        .filter(|&n| (WINDOW[0]..WINDOW[1]).contains(&middle(n)))
        .collect();
    let of = |value: &dyn Fn(usize) -> f64| median(chosen.iter().map(|&n| value(n)));
    let root = |n: usize| (REYNOLDS * middle(n) * stream.pressure / panels.pressure[n]).sqrt();
    let dynamic = 0.5 * stream.density * stream.speed * stream.speed;
    let carried =
        stream.density * stream.speed * GAMMA / (GAMMA - 1.0) * GAS_CONSTANT * TEMPERATURE;
    Layer {
        friction: of(&|n| {
            let along = panels.friction[n][0] * cos + panels.friction[n][1] * sin;
            along / dynamic * root(n)
        }),
        heat: of(&|n| -panels.heat.flux[n] / carried * root(n)),
        wall: of(&|n| panels.heat.temperature[n] / TEMPERATURE),
        recovery: f64::NAN,
    }
}
