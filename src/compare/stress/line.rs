//! The tubes: errors of the density against the answer, and how they fall with the spacing.

use aero::case::AnyCase;
use aero::run::Outcome;
use aero_validation::exact::ExactError;
use aero_validation::metrics::line;
use aero_validation::metrics::order::convergence_order;
use aero_validation::table::{Check, Subject};

use super::schemes::schemes;
use super::trial::Trial;
use super::tubes::{NOH, Profile, SOD, TORO_3, TUBES, Tube, gamma};
use crate::context::{CompareError, Context, Level};
use crate::profiles::Profiles;
use crate::row::Row;
use crate::variant::Scheme;

/// Largest mean error of the density, in per cent of its mean, at the spacing of the scenes.
const ALLOWED: f64 = 5.0;

/// Numbers of particles to a unit of length for the orders of convergence.
const FINER: [u32; 4] = [100, 200, 400, 800];

/// Runs all tubes by all schemes of the level.
pub fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let mut checks = Vec::new();
    for tube in &TUBES {
        for scheme in schemes(context.level) {
            let mut trial = tube.trial(scheme);
            trial.case = name(tube);
            let quantity = "mean density error, % of mean";
            checks.extend(trial.compare(context, |outcome| {
                let Some(outcome) = outcome else {
                    return Ok(vec![Row::unmeasured(quantity, tube.theory)]);
                };
                let (profile, gamma) = tube.answer(&trial)?;
                let mean = line::mean(tube.window, |x| profile(x).density);
                let error = 100.0 * density_error(tube, outcome, &profile)? / mean;
                draw(tube, &trial, outcome, (&profile, gamma), context)?;
                Ok(vec![Row::at_most(quantity, tube.theory, error, ALLOWED)])
            })?);
        }
    }
    Ok(checks)
}

/// Errors of three flows at falling spacings.
pub fn convergence(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
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
            let spacing = format!("spacing={}", 1.0 / f64::from(count));
            let trial = tube.trial(Scheme::USUAL).with([spacing]);
            let quantity = format!("{}: L1 of density, N = {count}", trial.label);
            let subject = Subject::new(tube.scene.name, &quantity, tube.theory);
            let attempt = trial.attempt(context)?;
            let Some(outcome) = attempt.outcome() else {
                checks.push(subject.unmeasured(0.0));
                continue;
            };
            let (profile, _) = tube.answer(&trial)?;
            let error = density_error(&tube, outcome, &profile)?;
            errors.push(error);
            checks.push(match finest.filter(|_| count == FINER[3]) {
                Some(bound) => subject.at_most(error, bound),
                None => subject.informs(error, 0.0),
            });
        }
        if errors.len() == FINER.len() {
            let spacings = FINER.map(|count| 1.0 / f64::from(count));
            let fitted = convergence_order(&spacings, &errors)?;
            let quantity = "conservative wom: order of convergence, L1 of density";
            let subject = Subject::new(tube.scene.name, quantity, "first order at jumps");
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
        Some(value) => format!("{} {value}", tube.scene.name),
        None => tube.scene.name.to_owned(),
    }
}

impl Tube {
    fn trial(&self, scheme: Scheme) -> Trial {
        Trial::new(self.scene, scheme).with(self.setting.iter().map(ToString::to_string))
    }

    /// The answer to a trial, and the gas's ratio of specific heats.
    fn answer(&self, trial: &Trial) -> Result<(Profile, f64), CompareError> {
        match self.scene.scene(&trial.all_settings())?.build_any()? {
            AnyCase::One(case) => Ok(((self.exact)(&case)?, gamma(&case))),
            AnyCase::Two(_) | AnyCase::Three(_) => {
                Err(CompareError::Exact(ExactError::OutOfRange {
                    what: "the dimension of a tube",
                    value: f64::NAN,
                    range: "1",
                }))
            }
        }
    }
}

fn density_error(tube: &Tube, outcome: &Outcome, profile: &Profile) -> Result<f64, CompareError> {
    let gas = &outcome.gas;
    let x: Vec<f64> = gas.position.iter().map(|p| p[0]).collect();
    let exact = |x| profile(x).density;
    Ok(line::mean_error(&x, &gas.density, tube.window, exact)?)
}

/// Profiles of density, pressure, velocity and energy against the answer.
fn draw(
    tube: &Tube,
    trial: &Trial,
    outcome: &Outcome,
    (profile, gamma): (&Profile, f64),
    context: &Context<'_>,
) -> Result<(), CompareError> {
    let name = format!("{} {}", trial.case, trial.label);
    let profiles = Profiles {
        title: format!("{name} at t = {}", outcome.gas.time),
        range: tube.window,
        gamma,
        exact: profile,
    };
    let file = format!("{}.png", name.replace(' ', "-"));
    Ok(profiles.of(&outcome.gas).save(&context.out.join(file))?)
}
