//! A plane shock that meets an inclined interface.

use aero_solver::frame::Frame;
use aero_validation::exact::refraction::{Refraction, refraction};
use aero_validation::table::{Check, Subject};

use super::bubble_gas::{AIR, GAMMAS, HELIUM, MACH};
use super::{NAME, places};
use crate::context::{CompareError, Context, Level};
use crate::profiles::median;
use crate::scenes::{Source, scene};

const SCENE: Source = scene!("helium-bubble");
const THEORY: &str = "regular refraction by shock polars (Henderson 1966)";

/// Angle between shock and interface, degrees.
const ANGLE: f64 = 10.0;

/// Where the waves have met when the flow is looked at, m above the plane of symmetry.
const MET: f64 = 0.35;

/// The part of the interface that is looked at, m: what comes from the plane of symmetry has not come so far.
const READ: [f64; 2] = [0.18, 0.3];

/// Spacings from the interface that the gas is read at.
const BESIDE: [f64; 2] = [2.5, 6.0];

/// Degrees that the interface may be off, and per cent of the state behind the transmitted shock.
const ALLOWED_TURN: [f64; 2] = [0.08, 0.1];
const ALLOWED: [f64; 2] = [1.0, 0.5];

pub(super) fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let angle = ANGLE.to_radians();
    let exact = refraction(MACH, angle, [AIR, HELIUM], GAMMAS)?;
    let (spacing, at) = match context.level {
        Level::Quick => (0.003_125, 0),
        Level::Full => (0.002, 1),
    };
    let slope = angle.tan();
    let front = MACH * AIR.sound_speed(GAMMAS[0]);
    // From two spacings short of the lowest point of the interface.
    let start = -0.03;
    let time = (MET * slope - start) / front;
    let settings = [
        format!("spacing={spacing}"),
        format!("end_time={time:?}"),
        "domain.min=[-0.16, 0.0]".into(),
        "domain.max=[0.24, 0.4]".into(),
        format!("gas.second.inside=x - {slope:?} * y"),
        format!("initial.riemann.position={start}"),
        "output.mirror=false".into(),
    ];
    let attempt = SCENE.attempt(&settings, context)?;
    let gas = attempt.outcome().map(|outcome| &outcome.gas);
    let label = format!("shock of Mach {MACH} on helium at {ANGLE} deg, dx {spacing} m");
    Ok(judged(&label, gas, spacing, &exact, at))
}

fn judged(
    label: &str,
    gas: Option<&Frame>,
    spacing: f64,
    exact: &Refraction,
    at: usize,
) -> Vec<Check> {
    let found = gas.map(|gas| {
        let line = interface(gas, spacing);
        let state = |column: fn(&Frame) -> &Vec<f64>| {
            let near = |place: &[f64; 3]| {
                let beyond = (place[0] - line.at(place[1])) / spacing;
                is_read(place) && (BESIDE[0]..BESIDE[1]).contains(&beyond)
            };
            median(places(gas, true, near).iter().map(|&i| column(gas)[i]))
        };
        [
            ANGLE - line.slope.atan().to_degrees(),
            state(|gas| &gas.pressure),
            state(|gas| &gas.density),
        ]
    });
    let expected = [exact.turn.to_degrees(), exact.pressure, exact.density_ahead];
    let names = [
        "turn of the interface, deg",
        "pressure in the helium beside it",
        "density in the helium beside it",
    ];
    (0..3)
        .map(|k| {
            let what = format!("{label}: {}", names[k]);
            let subject = Subject::new(NAME, &what, THEORY);
            match found {
                None => subject.unmeasured(expected[k]),
                Some(found) if k == 0 => subject.absolute(found[k], expected[k], ALLOWED_TURN[at]),
                Some(found) => subject.relative(found[k], expected[k], ALLOWED[at]),
            }
        })
        .collect()
}

fn is_read(place: &[f64; 3]) -> bool {
    (READ[0]..READ[1]).contains(&place[1])
}

/// A straight line `x = x_0 + slope y`.
struct Line {
    start: f64,
    slope: f64,
}

impl Line {
    fn at(&self, y: f64) -> f64 {
        self.start + self.slope * y
    }
}

/// The line through the middle between the last of one gas and the first of the other, row by row, by least squares.
fn interface(gas: &Frame, spacing: f64) -> Line {
    let rows = ((READ[1] - READ[0]) / (2.0 * spacing)) as usize;
    let height = (READ[1] - READ[0]) / rows as f64;
    let middles = (0..rows).map(|row| {
        let low = READ[0] + row as f64 * height;
        let near = |place: &[f64; 3]| (low..low + height).contains(&place[1]);
        let x = |is_second| {
            places(gas, is_second, near)
                .into_iter()
                .map(|i| gas.position[i][0])
        };
        let last = x(false).fold(f64::NEG_INFINITY, f64::max);
        let first = x(true).fold(f64::INFINITY, f64::min);
        [low + 0.5 * height, 0.5 * (last + first)]
    });
    let middles: Vec<[f64; 2]> = middles.collect();
    let count = middles.len() as f64;
    let mean = |k: usize| middles.iter().map(|at| at[k]).sum::<f64>() / count;
    let [y, x] = [mean(0), mean(1)];
    let both = middles
        .iter()
        .map(|at| (at[0] - y) * (at[1] - x))
        .sum::<f64>();
    let spread = middles.iter().map(|at| (at[0] - y).powi(2)).sum::<f64>();
    let slope = both / spread;
    Line {
        start: x - slope * y,
        slope,
    }
}
