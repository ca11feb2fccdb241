//! Air between a wall at rest and one that slides.

use aero_solver::frame::PanelFrame;
use aero_validation::exact::couette::{Couette, air_viscosity};
use aero_validation::table::{Check, Subject};

use super::{GAMMA, GAS_CONSTANT, NAME};
use crate::context::{CompareError, Context, Level};
use crate::scenes::{Source, scene};

pub(super) const SCENE: Source = scene!("couette");
pub(super) const THEORY: &str =
    "energy equation of plane shear (White, Viscous Fluid Flow, section 7-2)";
/// Distance of the walls, m, and temperature of that at rest, K.
pub(super) const HEIGHT: f64 = 1e-5;
pub(super) const TEMPERATURE: f64 = 300.0;
/// Per cent.
const SHEAR: f64 = 0.5;
const WALL: f64 = 0.2;

pub(super) fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let (machs, cells): (&[f64], u32) = match context.level {
        Level::Quick => (&[2.0], 24),
        Level::Full => (&[0.5, 2.0, 3.0], 32),
    };
    let mut checks = Vec::new();
    for &mach in machs {
        checks.extend(between(mach, cells, context)?);
    }
    Ok(checks)
}

/// A wall that slides, as warm as the other.
pub(super) fn sliding(speed: f64) -> String {
    format!(
        "{{ wall = {{ kind = \"no-slip\", temperature = {TEMPERATURE:?}, velocity = [{speed:?}, 0.0] }} }}"
    )
}

/// What gas takes from the wall that slides and gives to both.
pub(super) struct Rubbed {
    /// Friction per area.
    pub stress: f64,
    /// Heat into both walls per area.
    pub lost: f64,
}

impl Rubbed {
    pub(super) fn of(panels: &PanelFrame) -> Self {
        let heat = |side| of_wall(panels, side, |n| panels.heat.flux[n]);
        Self {
            // On the wall that slides the gas pulls back.
            stress: -of_wall(panels, 1, |n| panels.friction[n][0]),
            lost: -heat(0) - heat(1),
        }
    }
}

/// Mean over the panels of a wall side.
pub(super) fn of_wall(panels: &PanelFrame, side: u32, value: impl Fn(usize) -> f64) -> f64 {
    let own = (0..panels.body.len()).filter(|&n| panels.body[n] == side);
    let (sum, count) = own.fold((0.0, 0.0), |(sum, count), n| (sum + value(n), count + 1.0));
    sum / count
}

fn between(mach: f64, cells: u32, context: &Context<'_>) -> Result<[Check; 3], CompareError> {
    let speed = mach * (GAMMA * GAS_CONSTANT * TEMPERATURE).sqrt();
    let spacing = HEIGHT / f64::from(cells);
    let run = |wall: fn(f64) -> String| {
        let settings = [
            format!("spacing={spacing:?}"),
            format!("domain.max=[{:?}, {HEIGHT:?}]", 2.0 * spacing),
            format!("domain.sides.y_max={}", wall(speed)),
            format!("initial.field.velocity=[\"{speed:?} * y / {HEIGHT:?}\", 0.0]"),
        ];
        SCENE.attempt(&settings, context)
    };
    let couette = Couette {
        temperature: TEMPERATURE,
        mach,
        gamma: GAMMA,
        prandtl: 0.72,
    };
    let unit = air_viscosity(TEMPERATURE) * speed / HEIGHT;
    let subject = |quantity: &str| format!("shear, M {mach}, {cells} cells: {quantity}");
    let [shear, hot, heat] = [
        "tau H / (mu_w U)",
        "temperature of an adiabatic sliding wall over the other's",
        "heat into both walls over the work of the sliding one",
    ]
    .map(subject);
    let [shear, hot, heat] = [&shear, &hot, &heat].map(|what| Subject::new(NAME, what, THEORY));
    let held = run(sliding)?;
    let (shear, heat) = match held.outcome() {
        None => (shear.unmeasured(couette.shear()), heat.unmeasured(1.0)),
        Some(outcome) => {
            let Rubbed { stress, lost } = Rubbed::of(&outcome.panels);
            (
                shear.relative(stress / unit, couette.shear(), SHEAR),
                heat.relative(lost / (stress * speed), 1.0, SHEAR),
            )
        }
    };
    let free =
        run(|speed| format!("{{ wall = {{ kind = \"no-slip\", velocity = [{speed:?}, 0.0] }} }}"))?;
    let wall = couette.adiabatic_wall() / TEMPERATURE;
    let hot = match free.outcome() {
        None => hot.unmeasured(wall),
        Some(outcome) => {
            let found = of_wall(&outcome.panels, 1, |n| outcome.panels.heat.temperature[n]);
            hot.relative(found / TEMPERATURE, wall, WALL)
        }
    };
    Ok([shear, hot, heat])
}
