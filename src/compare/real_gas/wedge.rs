//! A wedge in hot air.

use aero_solver::gas::Air;
use aero_validation::exact::hot_air::HotAir;
use aero_validation::metrics::plateau::Ramp;
use aero_validation::metrics::shock_line::{ShockSearch, fit_shock_line};
use aero_validation::table::{Check, Subject};

use super::{NAME, THEORY, state};
use crate::context::{CompareError, Context, Level};
use crate::profiles::median;
use crate::scenes::{Source, scene};

const SCENE: Source = scene!("wedge-hot");

/// As in the scene: Pa, K, Mach number and degrees.
const PRESSURE: f64 = 1e4;
const TEMPERATURE: f64 = 1000.0;
const MACH: f64 = 6.0;
const ANGLE: f64 = 20.0;

/// Rays between wall and shock, and distances from the corner, that the gas is read between.
const RAYS: [f64; 2] = [0.3, 0.7];
const READ: [f64; 2] = [1.2, 2.7];

/// Per cent.
const ALLOWED: f64 = 0.8;

pub(super) fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let cells = match context.level {
        Level::Quick => 32,
        Level::Full => 64,
    };
    let air = Air::ThermallyPerfect;
    let ahead = HotAir::Whole.at(PRESSURE, TEMPERATURE)?;
    // The stream is given by its Mach number: its speed is that of the solver's own sound.
    let speed = MACH * air.sound_square(ahead.density, PRESSURE).sqrt();
    let (behind, wave) = HotAir::Whole.oblique_shock(&ahead, speed, ANGLE.to_radians())?;
    let spacing = 1.0 / f64::from(cells);
    let attempt = SCENE.attempt(&[format!("spacing={spacing:?}")], context)?;
    let gas = attempt.outcome().map(|outcome| &outcome.gas);
    let label = format!("wedge, Mach 6 in thermally perfect air of 1000 K, dx 1/{cells}");
    let found = gas.map(|gas| {
        let turn = ANGLE.to_radians();
        let read: Vec<usize> = (0..gas.position.len())
            .filter(|&i| {
                let [x, y, _] = gas.position[i];
                let ray = (y.atan2(x) - turn) / (wave - turn);
                let is_read = (READ[0]..READ[1]).contains(&x.hypot(y));
                is_read && (RAYS[0]..RAYS[1]).contains(&ray)
            })
            .collect();
        let middle = |column: &[f64]| median(read.iter().map(|&i| column[i]));
        [middle(&gas.density), middle(&gas.pressure)]
    });
    let mut checks = Vec::from(state(
        &label,
        "behind the shock",
        air,
        found,
        &behind,
        ALLOWED,
    ));
    let what = format!("{label}: shock angle, degrees");
    let subject = Subject::new(NAME, &what, THEORY);
    checks.push(match gas {
        None => subject.unmeasured(wave.to_degrees()),
        Some(gas) => {
            let ramp = Ramp {
                corner: [0.0, 0.0],
                angle: ANGLE.to_radians(),
                end_x: 3.0,
            };
            let densities = [ahead.density, behind.density];
            let search = ShockSearch::above_ramp(&ramp, 3.0, 6.0 * spacing, densities, spacing);
            let line = fit_shock_line(&gas.position, &gas.density, &search)?;
            subject.relative(line.angle.to_degrees(), wave.to_degrees(), ALLOWED)
        }
    });
    Ok(checks)
}
