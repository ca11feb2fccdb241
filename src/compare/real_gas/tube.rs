//! Gas that a wall stops.

use aero_solver::frame::Frame;
use aero_solver::gas::Air;
use aero_validation::exact::hot_air::{Hot, HotAir};
use aero_validation::table::{Check, Subject};

use super::{NAME, THEORY, at_60_km, state};
use crate::context::{CompareError, Context, Level};
use crate::profiles::median;
use crate::scenes::{Source, scene};

const SCENE: Source = scene!("hot-shock");

/// The part of the gas behind the shock that is read: away from the wall, which heats it, and from the shock.
const READ: [f64; 2] = [0.4, 0.8];

/// Per cent: of density, pressure and temperature.
const ALLOWED: f64 = 1.5;

/// Per cent of where the shock is, at the quick level, by three particles to its width, and at the full one.
const PLACE: [f64; 2] = [3.0, 1.5];

/// What is run.
struct Stream {
    name: &'static str,
    air: Air,
    model: HotAir,
    ahead: Hot,
    speed: f64,
    /// Seconds in which the shock comes about half a metre from the wall.
    time: f64,
    settings: Vec<String>,
}

pub(super) fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let (cells, place) = match context.level {
        Level::Quick => (50, PLACE[0]),
        Level::Full => (200, PLACE[1]),
    };
    let mut checks = Vec::new();
    for stream in [cold()?, high()?] {
        for motion in ["fixed", "with-the-gas"] {
            let mut settings = stream.settings.clone();
            settings.push(format!("spacing={:?}", 1.0 / f64::from(cells)));
            settings.push(format!("scheme.motion={motion}"));
            let attempt = SCENE.attempt(&settings, context)?;
            let label = format!("{}, {motion}, {cells} to a metre", stream.name);
            checks.extend(judged(
                &stream,
                &label,
                attempt.outcome().map(|outcome| &outcome.gas),
                place,
            )?);
        }
    }
    Ok(checks)
}

/// Molecules begin to swing.
fn cold() -> Result<Stream, CompareError> {
    Ok(Stream {
        name: "thermally perfect air, 300 K at 1800 m/s",
        air: Air::ThermallyPerfect,
        model: HotAir::Whole,
        ahead: HotAir::Whole.at(1e4, 300.0)?,
        speed: 1800.0,
        time: 1.1e-3,
        settings: [
            "gas.equation_of_state=thermally-perfect-air",
            "free_stream={ speed = 1800.0, pressure = 1e4, temperature = 300.0 }",
            "end_time=1.1e-3",
        ]
        .map(String::from)
        .to_vec(),
    })
}

/// Molecules come apart.
fn high() -> Result<Stream, CompareError> {
    Ok(Stream {
        name: "equilibrium air, 60 km at 7000 m/s",
        air: Air::Equilibrium,
        model: HotAir::Reacting,
        ahead: at_60_km()?,
        speed: 7000.0,
        time: 1.2e-3,
        settings: Vec::new(),
    })
}

fn judged(
    stream: &Stream,
    label: &str,
    gas: Option<&Frame>,
    place: f64,
) -> Result<Vec<Check>, CompareError> {
    let (behind, front) = stream.model.stopped(&stream.ahead, stream.speed)?;
    let depth = front * stream.time;
    let mean = |column: fn(&Frame) -> &Vec<f64>| {
        gas.map(|gas| {
            let read = (0..gas.position.len()).filter(|&i| {
                let part = (1.0 - gas.position[i][0]) / depth;
                (READ[0]..READ[1]).contains(&part)
            });
            median(read.map(|i| column(gas)[i]))
        })
    };
    let (density, pressure) = (mean(|gas| &gas.density), mean(|gas| &gas.pressure));
    let found = density.zip(pressure).map(<[f64; 2]>::from);
    let mut checks = Vec::from(state(
        label,
        "behind the shock",
        stream.air,
        found,
        &behind,
        ALLOWED,
    ));
    let what = format!("{label}: distance of shock and wall, m");
    let subject = Subject::new(NAME, &what, THEORY);
    let level = 0.5 * (stream.ahead.density + behind.density);
    checks.push(match gas.map(|gas| 1.0 - crossing(gas, level)) {
        Some(found) => subject.relative(found, depth, place),
        None => subject.unmeasured(depth),
    });
    Ok(checks)
}

/// Where the density rises through `level` first.
fn crossing(gas: &Frame, level: f64) -> f64 {
    let mut row: Vec<[f64; 2]> = (0..gas.position.len())
        .map(|i| [gas.position[i][0], gas.density[i]])
        .filter(|[x, _]| *x > 0.0)
        .collect();
    row.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let pair = row
        .windows(2)
        .find(|pair| pair[0][1] < level && level <= pair[1][1]);
    pair.map_or(f64::NAN, |pair| {
        let [[a, low], [b, high]] = [pair[0], pair[1]];
        a + (b - a) * (level - low) / (high - low)
    })
}
