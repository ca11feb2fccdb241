//! Air that friction heats until it vibrates and comes apart, between a wall at rest and one that slides.

use aero_validation::exact::couette::{HotCouette, air_viscosity};
use aero_validation::exact::hot_air::HotAir;
use aero_validation::table::{Check, Subject};

use super::NAME;
use super::shear::{Rubbed, TEMPERATURE, of_wall, sliding};
use crate::context::{CompareError, Context, Level};
use crate::scenes::{Source, scene};
use aero::run::Outcome;
use aero_solver::gas::Air;

const SCENE: Source = scene!("couette-hot");
const THEORY: &str = "energy equation of plane shear by the enthalpy; statistical mechanics";
/// Distance of the walls, m, and density at the start, kg/m^3, as in the scene.
const HEIGHT: f64 = 1e-3;
const DENSITY: f64 = 0.002;
/// Spacings along the walls of particles, which would meet their own images on fewer.
const WIDTH: u32 = 12;
/// Time over that in which friction gets from wall to wall, as particles start all but settled.
const SETTLING: f64 = 0.3;
/// Per cent: of shear and heat, of particles' shear, and of temperatures, which the theory's and the solver's air agree on to one.
const SHEAR: f64 = 0.5;
const SHEAR_OF_PARTICLES: f64 = 1.0;
const WARMTH: f64 = 1.0;

/// What happens to the air, in words of a scene.
const VIBRATES: (HotAir, &str) = (HotAir::Whole, "thermally-perfect-air");
const REACTS: (HotAir, &str) = (HotAir::Reacting, "equilibrium-air");

pub(super) fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let flows: &[((HotAir, &str), f64)] = match context.level {
        Level::Quick => &[(REACTS, 5000.0)],
        Level::Full => &[
            (VIBRATES, 2000.0),
            (VIBRATES, 3000.0),
            (REACTS, 3000.0),
            (REACTS, 5000.0),
            (REACTS, 6000.0),
        ],
    };
    let mut checks = Vec::new();
    for &(air, speed) in flows {
        checks.extend(about_points(air, speed, context)?);
    }
    let (cells, allowed) = match context.level {
        Level::Quick => (20, 2.0),
        Level::Full => (40, WARMTH),
    };
    checks.extend(by_particles(VIBRATES, 2000.0, (cells, allowed), context)?);
    Ok(checks)
}

/// What the gas is compared with, whose pressure is what its heat has made of it.
fn exact(air: HotAir, speed: f64, outcome: &Outcome) -> HotCouette {
    let pressures = &outcome.gas.pressure;
    HotCouette {
        air,
        pressure: pressures.iter().sum::<f64>() / pressures.len() as f64,
        temperature: TEMPERATURE,
        speed,
        prandtl: 0.72,
    }
}

fn about_points(
    (air, word): (HotAir, &str),
    speed: f64,
    context: &Context<'_>,
) -> Result<[Check; 3], CompareError> {
    let run = |wall: String| {
        let settings = [
            format!("gas.equation_of_state={word}"),
            format!("domain.sides.y_max={wall}"),
            format!("initial.field.velocity=[\"{speed:?} * y / {HEIGHT:?}\", 0.0]"),
        ];
        SCENE.attempt(&settings, context)
    };
    let subject = |quantity: &str| format!("shear, {word}, {speed} m/s, 25 cells: {quantity}");
    let [shear, heat, hot] = [
        "tau H / (mu_w U)",
        "heat into both walls over the work of the sliding one",
        "temperature of an adiabatic sliding wall, K",
    ]
    .map(subject);
    let [shear, heat, hot] = [&shear, &heat, &hot].map(|what| Subject::new(NAME, what, THEORY));
    let held = run(sliding(speed))?;
    let (shear, heat) = match held.outcome() {
        None => (shear.unmeasured(f64::NAN), heat.unmeasured(1.0)),
        Some(outcome) => {
            let Rubbed { stress, lost } = Rubbed::of(&outcome.panels);
            let unit = air_viscosity(TEMPERATURE) * speed / HEIGHT;
            let exact = exact(air, speed, outcome).shear()?;
            (
                shear.relative(stress / unit, exact, SHEAR),
                heat.relative(lost / (stress * speed), 1.0, SHEAR),
            )
        }
    };
    let free = run(format!(
        "{{ wall = {{ kind = \"no-slip\", velocity = [{speed:?}, 0.0] }} }}"
    ))?;
    let hot = match free.outcome() {
        None => hot.unmeasured(f64::NAN),
        Some(outcome) => {
            let found = of_wall(&outcome.panels, 1, |n| outcome.panels.heat.temperature[n]);
            let exact = exact(air, speed, outcome).adiabatic_wall()?;
            hot.relative(found, exact, WARMTH)
        }
    };
    Ok([shear, heat, hot])
}

/// Particles, from the profile of an ideal gas that is as warm in the middle, where `allowed` is in per cent of the temperature.
fn by_particles(
    (air, word): (HotAir, &str),
    speed: f64,
    (cells, allowed): (u32, f64),
    context: &Context<'_>,
) -> Result<[Check; 2], CompareError> {
    let spacing = HEIGHT / f64::from(cells);
    let pressure = 172.24;
    let start = HotCouette {
        air,
        pressure,
        temperature: TEMPERATURE,
        speed,
        prandtl: 0.72,
    };
    let rise = 4.0 * (start.between(0.5)? - TEMPERATURE);
    let part = format!("(y / {HEIGHT:?})");
    let warmth = format!("(1 + {:?} * {part} * (1 - {part}))", rise / TEMPERATURE);
    let time = SETTLING * HEIGHT * HEIGHT * DENSITY / air_viscosity(TEMPERATURE);
    let settings = [
        "scheme.motion=with-the-gas".into(),
        "stop=end-time".into(),
        format!("gas.equation_of_state={word}"),
        format!("end_time={time:?}"),
        format!("spacing={spacing:?}"),
        format!("domain.max=[{:?}, {HEIGHT:?}]", f64::from(WIDTH) * spacing),
        format!("domain.sides.y_max={}", sliding(speed)),
        format!("initial.field.density=\"{DENSITY:?} / {warmth}\""),
        format!("initial.field.pressure=\"{pressure:?}\""),
        format!("initial.field.velocity=[\"{speed:?} * {part}\", 0.0]"),
    ];
    let what = |quantity: &str| {
        format!("particles, shear, {word}, {speed} m/s, {cells} cells: {quantity}")
    };
    let [shear, middle] = ["tau H / (mu_w U)", "temperature in the middle, K"].map(what);
    let [shear, middle] = [&shear, &middle].map(|what| Subject::new(NAME, what, THEORY));
    let attempt = SCENE.attempt(&settings, context)?;
    Ok(match attempt.outcome() {
        None => [shear.unmeasured(f64::NAN), middle.unmeasured(f64::NAN)],
        Some(outcome) => {
            let panels = &outcome.panels;
            let stress = of_wall(panels, 0, |n| panels.friction[n][0]);
            let unit = air_viscosity(TEMPERATURE) * speed / HEIGHT;
            let exact = exact(air, speed, outcome);
            let gas = &outcome.gas;
            let near = |y: f64| (y / HEIGHT - 0.5).abs() < 1.01 / f64::from(cells);
            let own = (0..gas.density.len()).filter(|&i| near(gas.position[i][1]));
            let (mut sums, mut count) = ([0.0; 2], 0.0);
            for i in own {
                sums[0] += Air::ThermallyPerfect.temperature(gas.density[i], gas.pressure[i]);
                sums[1] += exact.between(gas.velocity[i][0] / speed)?;
                count += 1.0;
            }
            let [found, known] = sums.map(|sum| sum / count);
            [
                shear.relative(stress / unit, exact.shear()?, SHEAR_OF_PARTICLES),
                middle.relative(found, known, allowed),
            ]
        }
    })
}
