//! The nose of what returns to Earth.

use aero_solver::frame::Frame;
use aero_solver::gas::Air;
use aero_validation::exact::hot_air::HotAir;
use aero_validation::table::{Check, Subject};

use super::{NAME, at_60_km, state};
use crate::context::{CompareError, Context, Level};
use crate::scenes::{Source, scene};

const SCENE: Source = scene!("hemisphere-hot");

/// m/s, as in the scene.
const SPEED: f64 = 7500.0;

/// Stand-off over radius and `rho_1 / rho_2` of an ideal gas: of a sphere at Mach 10, 0.136 behind a shock of 5.714.
const IDEAL: f64 = 0.136 * 5.714;

/// The nose and what is beside it.
const NOSE: [&str; 2] = ["domain.min=[-1.2, 0.0]", "domain.max=[-0.4, 1.2]"];

/// Parts of the way from the shock to the nose between which the gas is read.
const READ: [f64; 2] = [0.3, 0.8];

/// Per cent, quickly and in full.
const STATE: [f64; 2] = [2.0, 2.0];

/// Per cent of the stand-off, which four cells between shock and nose are too few for.
const STAND_OFF: f64 = 10.0;

pub(super) fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    // The nose alone: what is beside it does not reach it faster than sound.
    let (cells, halvings, how, allowed) = match context.level {
        Level::Quick => (50, 1, "halved once", STATE[0]),
        Level::Full => (80, 0, "everywhere", STATE[1]),
    };
    let ahead = at_60_km()?;
    let behind = HotAir::Reacting.normal_shock(&ahead, SPEED)?;
    let ratio = behind.density / ahead.density;
    let spacing = 1.0 / f64::from(cells);
    let mut settings = vec![
        format!("spacing={spacing:?}"),
        format!("scheme.refine={halvings}"),
    ];
    settings.extend(NOSE.map(String::from));
    let attempt = SCENE.attempt(&settings, context)?;
    let label = format!("hemisphere, 7.5 km/s at 60 km, dx R/{cells} {how}");
    let row = attempt.outcome().map(|outcome| {
        let width = spacing * 0.5_f64.powi(halvings);
        axis(&outcome.gas, spacing, width)
    });
    let level = 0.5 * (ahead.density + behind.density);
    // What is left of the speed behind the shock.
    let rest = 0.5 * ahead.density * SPEED * SPEED / ratio;
    let gains = [
        rest / Air::Equilibrium.sound_square(behind.density, behind.pressure),
        rest,
    ];
    let found = row.and_then(|row| Nose::new(&row, level, gains));
    let mut checks = Vec::from(state(
        &label,
        "behind the shock on the axis",
        Air::Equilibrium,
        found.as_ref().map(|nose| [nose.density, nose.pressure]),
        &behind,
        allowed,
    ));
    let what = format!("{label}: stand-off / R over rho_1 / rho_2");
    let subject = Subject::new(NAME, &what, "an ideal gas (validation/sphere)");
    checks.push(match found {
        Some(nose) if context.level == Level::Quick => {
            subject.informs(nose.stand_off * ratio, IDEAL)
        }
        Some(nose) => subject.relative(nose.stand_off * ratio, IDEAL, STAND_OFF),
        None => subject.unmeasured(IDEAL),
    });
    Ok(checks)
}

/// Place, density and pressure of the point nearest to the axis in each column of the finest cells ahead of the nose.
fn axis(gas: &Frame, spacing: f64, width: f64) -> Vec<[f64; 3]> {
    let mut row: Vec<[f64; 5]> = (0..gas.position.len())
        .map(|i| {
            let [x, y, _] = gas.position[i];
            [(x / width).floor(), y, x, gas.density[i], gas.pressure[i]]
        })
        .filter(|point| point[2] < -1.0 && point[1] < spacing)
        .collect();
    row.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    row.dedup_by_key(|point| point[0]);
    row.iter()
        .map(|point| [point[2], point[3], point[4]])
        .collect()
}

/// The gas ahead of the nose.
struct Nose {
    stand_off: f64,
    /// Just behind the shock.
    density: f64,
    pressure: f64,
}

impl Nose {
    /// From the gas along the axis: where its density passes `level`, and what is read less what it has gained since, of `gains` in density
    /// and pressure on the whole way to the nose.
    fn new(row: &[[f64; 3]], level: f64, gains: [f64; 2]) -> Option<Self> {
        // From the nose on, against the stream.
        let pair = row
            .windows(2)
            .rev()
            .find(|pair| pair[0][1] < level && level <= pair[1][1])?;
        let [[a, low, _], [b, high, _]] = [pair[0], pair[1]];
        let shock = a + (b - a) * (level - low) / (high - low);
        let stand_off = -1.0 - shock;
        let part = |point: &[f64; 3]| (point[0] - shock) / stand_off;
        let read: Vec<&[f64; 3]> = row
            .iter()
            .filter(|point| (READ[0]..READ[1]).contains(&part(point)))
            .collect();
        if read.is_empty() {
            return None;
        }
        // Along the axis the speed falls to nothing on a straight line, and pressure rises as it does.
        let mean = |gain: f64, k: usize| {
            let each = read.iter().map(|point| {
                let left = 1.0 - part(point);
                point[k] - gain * (1.0 - left * left)
            });
            each.sum::<f64>() / read.len() as f64
        };
        Some(Self {
            stand_off,
            density: mean(gains[0], 1),
            pressure: mean(gains[1], 2),
        })
    }
}
