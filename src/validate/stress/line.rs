//! The tubes: errors of the density against the answer, and how they fall with the spacing.

use aero_validation::exact::State;
use aero_validation::metrics::line;
use aero_validation::metrics::order::convergence_order;
use aero_validation::pictures::curves::{Curves, Panel, Series};
use aero_validation::table::{Check, Subject};

use super::tubes::{NOH, Profile, SOD, TORO_3, TUBES, Tube, gamma};
use super::{Context, Level, VARIANTS, ValidateError, common_rows, scene, variant};
use crate::validate::outcome::{Attempt, Outcome, attempt};

/// Largest mean error of the density, in per cent of its mean, at the spacing of the scenes.
const ALLOWED: f64 = 5.0;

/// Numbers of particles to a unit of length for the orders of convergence.
const FINER: [u32; 4] = [100, 200, 400, 800];

/// Runs all tubes in all variants of the level.
pub fn compare(context: &Context<'_>) -> Result<Vec<Check>, ValidateError> {
    let mut checks = Vec::new();
    for tube in &TUBES {
        for (equations, extrapolation, level) in VARIANTS {
            if level == Level::Full && context.level == Level::Quick {
                continue;
            }
            let label = format!("{equations} {extrapolation}");
            let mut settings = variant(equations, extrapolation);
            settings.extend(tube.setting.iter().map(|&setting| setting.to_owned()));
            let tried = attempt(tube.source, &settings, context)?;
            let name = name(tube);
            let strict = equations == "conservative";
            checks.extend(common_rows(&name, &label, strict, &tried));
            let quantity = format!("{label}: mean density error, % of mean");
            let subject = Subject::new(&name, &quantity, tube.theory);
            let Attempt::Ended(outcome) = tried else {
                checks.push(subject.unmeasured(0.0));
                continue;
            };
            let profile = (tube.answer)(&scene(tube.source, &settings)?.build::<1>()?)?;
            let mean = line::mean(tube.window, |x| profile(x).density);
            let error = 100.0 * density_error(tube, &outcome, &profile)? / mean;
            checks.push(if strict {
                subject.at_most(error, ALLOWED)
            } else {
                subject.informs(error, ALLOWED)
            });
            picture(
                tube,
                &outcome,
                &profile,
                &format!("{name}-{equations}-{extrapolation}"),
                context,
            )?;
        }
    }
    Ok(checks)
}

/// Errors of three flows at falling spacings.
pub fn convergence(context: &Context<'_>) -> Result<Vec<Check>, ValidateError> {
    if context.level == Level::Quick {
        return Ok(Vec::new());
    }
    let mut checks = Vec::new();
    for (tube, finest, order) in [
        (SOD, None, Some(0.8)),
        (NOH, Some(2e-2), None),
        (TORO_3, Some(1.2e-2), None),
    ] {
        let mut errors = Vec::new();
        for count in FINER {
            let mut settings = variant("conservative", "wom");
            settings.extend(tube.setting.iter().map(|&setting| setting.to_owned()));
            settings.push(format!("spacing={}", 1.0 / f64::from(count)));
            let quantity = format!("conservative wom: L1 of density, N = {count}");
            let subject = Subject::new(tube.source.name, &quantity, tube.theory);
            let Attempt::Ended(outcome) = attempt(tube.source, &settings, context)? else {
                checks.push(subject.unmeasured(0.0));
                continue;
            };
            let profile = (tube.answer)(&scene(tube.source, &settings)?.build::<1>()?)?;
            let error = density_error(&tube, &outcome, &profile)?;
            errors.push(error);
            checks.push(match finest.filter(|_| count == FINER[3]) {
                Some(bound) => subject.at_most(error, bound),
                None => subject.informs(error, 0.0),
            });
        }
        if errors.len() == FINER.len() {
            let spacings = FINER.map(|count| 1.0 / f64::from(count));
            let fitted =
                convergence_order(&spacings, &errors).map_err(|source| metric(&tube, source))?;
            let quantity = "conservative wom: order of convergence, L1 of density";
            let subject = Subject::new(tube.source.name, quantity, "first order at jumps");
            checks.push(match order {
                Some(least) => subject.at_least(fitted.order, least),
                None => subject.informs(fitted.order, 1.0),
            });
        }
    }
    Ok(checks)
}

/// The scene's name with what is set on top of it.
fn name(tube: &Tube) -> String {
    let value = |setting: &&str| setting.split_once('=').map(|(_, value)| value.to_owned());
    match tube.setting.first().and_then(value) {
        Some(value) => format!("{} {value}", tube.source.name),
        None => tube.source.name.to_owned(),
    }
}

fn density_error(tube: &Tube, outcome: &Outcome, profile: &Profile) -> Result<f64, ValidateError> {
    let gas = &outcome.gas;
    let x: Vec<f64> = gas.position.iter().map(|p| p[0]).collect();
    let error = line::mean_error(&x, &gas.density, tube.window, |x| profile(x).density);
    error.map_err(|source| metric(tube, source))
}

fn metric(tube: &Tube, source: aero_validation::metrics::MetricError) -> ValidateError {
    ValidateError::Metric {
        case: tube.source.name.into(),
        source,
    }
}

/// Profiles of density, pressure, velocity and energy against the answer.
fn picture(
    tube: &Tube,
    outcome: &Outcome,
    profile: &Profile,
    name: &str,
    context: &Context<'_>,
) -> Result<(), ValidateError> {
    let gas = &outcome.gas;
    let gamma = gamma(&scene(tube.source, &[])?.build::<1>()?);
    let x: Vec<f64> = gas.position.iter().map(|p| p[0]).collect();
    let velocity: Vec<f64> = gas.velocity.iter().map(|u| u[0]).collect();
    let panel = |label: &str, values: &[f64], pick: &dyn Fn(&State) -> f64| {
        let series = vec![
            Series::particles("particles", &x, values),
            Series::exact(tube.window, 1000, |x| pick(&profile(x))),
        ];
        Panel::new("x", label, series)
    };
    let title = format!("{name} at t = {}", gas.time);
    let mut curves = Curves::single(&title, panel("density", &gas.density, &|s| s.density));
    curves
        .panels
        .push(panel("pressure", &gas.pressure, &|s| s.pressure));
    curves
        .panels
        .push(panel("velocity", &velocity, &|s| s.velocity));
    curves
        .panels
        .push(panel("internal energy", &gas.energy, &|s| s.energy(gamma)));
    curves.columns = 2;
    let file = format!("{}.png", name.replace(' ', "-"));
    Ok(curves.save(&context.out.join(file))?)
}
