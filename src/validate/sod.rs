//! The reflecting shock tube against the exact solution.

use aero_validation::exact::State;
use aero_validation::exact::sod_tube::ClosedTube;
use aero_validation::metrics::profile::profile_error;
use aero_validation::pictures::curves::{Curves, Panel, Series};
use aero_validation::table::{Check, Subject};

use super::outcome::{Outcome, Source, run};
use super::{Context, Level, ValidateError};

pub(crate) const SCENE: Source = Source {
    name: "sod",
    text: include_str!("../../cases/sod.toml"),
};
const THEORY: &str = "exact Riemann solution with reflection (Toro 2009)";
const GAMMA: f64 = 1.4;

/// Times of comparison, and the largest particle-mean error of the density at each.
const TIMES: [(f64, f64); 2] = [(0.15, 5e-3), (0.375, 6e-3)];

/// Runs the variants and compares profiles, the state behind the reflected shock and the balance.
pub fn compare(context: &Context<'_>) -> Result<Vec<Check>, ValidateError> {
    let tube = ClosedTube::sod()?;
    let mut checks = Vec::new();
    for (equations, extrapolation, level) in [
        ("conservative", "wom", Level::Quick),
        ("conservative", "wm", Level::Quick),
        ("paper", "wom", Level::Full),
        ("paper", "wm", Level::Full),
    ] {
        if level == Level::Full && context.level == Level::Quick {
            continue;
        }
        for (time, allowed) in TIMES {
            let settings = [
                format!("scheme.equations={equations}"),
                format!("scheme.extrapolation={extrapolation}"),
                format!("end_time={time}"),
            ];
            let outcome = run(SCENE, &settings, context)?;
            let label = format!("{equations} {extrapolation}, t {time}");
            let cured = equations == "conservative";
            let mut row = |quantity: &str, measured: f64, reference: f64, allowed: f64| {
                let quantity = format!("{label}: {quantity}");
                let subject = Subject::new(SCENE.name, &quantity, THEORY);
                checks.push(match (cured, reference == 0.0) {
                    (false, _) => subject.informs(measured, reference),
                    (true, true) => subject.at_most(measured.abs(), allowed),
                    (true, false) => subject.relative(measured, reference, allowed),
                });
            };
            row(
                "mean density error",
                density_error(&outcome, &tube)?,
                0.0,
                allowed,
            );
            row(
                "drift of total energy",
                outcome.summary.conservation.energy,
                0.0,
                2e-4,
            );
            if time > tube.wall_time() {
                let behind = tube.reflected();
                row(
                    "density at the wall",
                    plateau(&outcome, &tube, |gas, i| gas.density[i]),
                    behind.density,
                    0.5,
                );
                row(
                    "pressure at the wall",
                    plateau(&outcome, &tube, |gas, i| gas.pressure[i]),
                    behind.pressure,
                    0.5,
                );
                picture(
                    &outcome,
                    &tube,
                    &format!("sod-{equations}-{extrapolation}"),
                    context,
                )?;
            }
        }
    }
    Ok(checks)
}

/// Mean departure of the density from the exact solution, over the particles.
pub(crate) fn density_error(outcome: &Outcome, tube: &ClosedTube) -> Result<f64, ValidateError> {
    let gas = &outcome.gas;
    let x: Vec<f64> = gas.position.iter().map(|p| p[0]).collect();
    let exact = |x: f64| tube.at(x, gas.time).ok().map(|state| state.density);
    let error = profile_error(&x, &gas.density, exact).map_err(|error| SCENE.unread(error))?;
    Ok(error.l1)
}

/// Median between the reflected shock and the wall, a quarter of the way off either.
fn plateau(
    outcome: &Outcome,
    tube: &ClosedTube,
    value: impl Fn(&aero_solver::frame::Frame, usize) -> f64,
) -> f64 {
    let gas = &outcome.gas;
    let shock = tube.shock_position(gas.time).unwrap_or(1.0);
    let margin = 0.25 * (1.0 - shock);
    let mut values: Vec<f64> = (0..gas.position.len())
        .filter(|&i| (shock + margin..1.0 - margin).contains(&gas.position[i][0]))
        .map(|i| value(gas, i))
        .collect();
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

/// Profiles of density, pressure, velocity and energy against the exact ones.
fn picture(
    outcome: &Outcome,
    tube: &ClosedTube,
    name: &str,
    context: &Context<'_>,
) -> Result<(), ValidateError> {
    let gas = &outcome.gas;
    let x: Vec<f64> = gas.position.iter().map(|p| p[0]).collect();
    let velocity: Vec<f64> = gas.velocity.iter().map(|u| u[0]).collect();
    let exact = |x: f64, pick: fn(&State) -> f64| {
        tube.at(x, gas.time).map_or(f64::NAN, |state| pick(&state))
    };
    let panel = |label: &str, values: &[f64], pick: fn(&State) -> f64| {
        let series = vec![
            Series::particles("particles", &x, values),
            Series::exact([0.0, 1.0], 1000, |x| exact(x, pick)),
        ];
        Panel::new("x", label, series)
    };
    let mut curves = Curves::single(
        &format!("Reflecting shock tube at t = {} ({name})", gas.time),
        panel("density", &gas.density, |state| state.density),
    );
    curves
        .panels
        .push(panel("pressure", &gas.pressure, |state| state.pressure));
    curves
        .panels
        .push(panel("velocity", &velocity, |state| state.velocity));
    curves
        .panels
        .push(panel("internal energy", &gas.energy, |state| {
            state.energy(GAMMA)
        }));
    curves.columns = 2;
    Ok(curves.save(&context.out.join(format!("{name}.png")))?)
}
