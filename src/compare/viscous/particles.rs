//! Shear by particles.

use aero_validation::exact::couette::{Couette, air_viscosity};
use aero_validation::table::{Check, Subject};

use super::shear::{self, HEIGHT, TEMPERATURE};
use super::{GAMMA, GAS_CONSTANT, NAME};
use crate::context::{CompareError, Context, Level};

/// Time over that in which friction gets from wall to wall, `H^2 / nu`: the flow starts all but settled.
const SETTLING: f64 = 0.3;
/// Spacings along the walls; particles would meet their own images on fewer.
const WIDTH: u32 = 12;
/// Per cent.
const SHEAR: f64 = 0.5;
const RISE: f64 = 2.0;

pub(super) fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let (machs, cells): (&[f64], u32) = match context.level {
        Level::Quick => (&[2.0], 20),
        Level::Full => (&[0.5, 2.0, 3.0], 32),
    };
    let mut checks = Vec::new();
    for &mach in machs {
        checks.extend(between(mach, cells, context)?);
    }
    Ok(checks)
}

/// Walls at the same temperature.
fn between(mach: f64, cells: u32, context: &Context<'_>) -> Result<[Check; 2], CompareError> {
    let speed = mach * (GAMMA * GAS_CONSTANT * TEMPERATURE).sqrt();
    let couette = Couette {
        temperature: TEMPERATURE,
        mach,
        gamma: GAMMA,
        prandtl: 0.72,
    };
    let spacing = HEIGHT / f64::from(cells);
    let viscosity = air_viscosity(TEMPERATURE);
    let pressure = GAS_CONSTANT * TEMPERATURE;
    let part = format!("(y / {HEIGHT:?})");
    let rise = 4.0 * (couette.between(0.5) - TEMPERATURE);
    let temperature = format!("({TEMPERATURE:?} + {rise:?} * {part} * (1 - {part}))");
    let settings = [
        "scheme.motion=with-the-gas".into(),
        "stop=end-time".into(),
        format!("end_time={:?}", SETTLING * HEIGHT * HEIGHT / viscosity),
        format!("spacing={spacing:?}"),
        format!("domain.max=[{:?}, {HEIGHT:?}]", f64::from(WIDTH) * spacing),
        format!("domain.sides.y_max={}", shear::sliding(speed)),
        format!("initial.field.density=\"{pressure:?} / {GAS_CONSTANT:?} / {temperature}\""),
        format!("initial.field.pressure=\"{pressure:?}\""),
        format!("initial.field.velocity=[\"{speed:?} * {part}\", 0.0]"),
    ];
    let what = |quantity: &str| format!("particles, shear, M {mach}, {cells} cells: {quantity}");
    let [shear, heat] = ["tau H / (mu_w U)", "mean rise of the temperature"].map(what);
    let [shear, heat] = [&shear, &heat].map(|what| Subject::new(NAME, what, shear::THEORY));
    let attempt = shear::SCENE.attempt(&settings, context)?;
    Ok(match attempt.outcome() {
        None => [shear.unmeasured(couette.shear()), heat.unmeasured(1.0)],
        Some(outcome) => {
            let panels = &outcome.panels;
            let at_rest = (0..panels.body.len()).filter(|&n| panels.body[n] == 0);
            let (sum, count) = at_rest.fold((0.0, 0.0), |(sum, count), n| {
                (sum + panels.friction[n][0], count + 1.0)
            });
            let unit = viscosity * speed / HEIGHT;
            let gas = &outcome.gas;
            let (mut found, mut exact) = (0.0, 0.0);
            for i in 0..gas.density.len() {
                found += gas.pressure[i] / gas.density[i] / GAS_CONSTANT - TEMPERATURE;
                exact += couette.between(gas.velocity[i][0] / speed) - TEMPERATURE;
            }
            [
                shear.relative(sum / count / unit, couette.shear(), SHEAR),
                heat.relative(found / exact, 1.0, RISE),
            ]
        }
    })
}
