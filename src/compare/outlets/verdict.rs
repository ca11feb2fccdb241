//! What is asked of a treatment, and its rows.

use aero_validation::table::{Check, Subject};

use super::cases::{Case, Suite};
use super::published::printed;
use super::treatment::Treatment;
use super::wave::Sound;

pub const NAME: &str = "outlets";
const LONG: &str = "a duct so long that nothing comes back";
const PAPER: &str = "Negi, Ramachandran & Haftu 2020";
const QUANTITIES: [&str; 3] = ["p", "u", "v"];

/// Largest error in the velocity across of a vortex over the printed one, and in the speed along: the paper prints three decimals.
const ACROSS: f64 = 1.25;
const ALONG: f64 = 0.015;
/// How near to the printed ones the errors at the ramp are that do not depend on how particles lie: the characteristic's, whose reference is
/// wrong until the ramp ends, per cent; and the hybrid's, which is right.
const RAMP: f64 = 10.0;
const RAMP_HYBRID: f64 = 0.02;

/// The row on the part of a sound that comes back.
pub fn echo_row(sound: &Sound, treatment: &dyn Treatment, back: f64) -> Check {
    let Sound {
        mach,
        strength,
        cells,
    } = *sound;
    let name = treatment.name();
    let quantity =
        format!("sound, M {mach}, {strength} c, dx 1/{cells}, {name}: part that comes back");
    let subject = Subject::new(NAME, &quantity, LONG);
    match treatment.echo(sound) {
        Some(most) => subject.at_most(back, most),
        None => subject.informs(back, 0.0),
    }
}

/// The rows on the errors of a treatment in the suite, beside the printed ones.
pub fn suite_rows(suite: &Suite, treatment: &str, errors: [f64; 3]) -> Vec<Check> {
    let printed = printed(suite, treatment);
    let has_own = printed.iter().all(Option::is_none);
    let mut checks = Vec::new();
    for (k, quantity) in QUANTITIES.iter().enumerate() {
        let is_across = k == 2 && suite.case != Case::Vortex;
        if is_across || (printed[k].is_none() && !has_own) {
            continue;
        }
        let quantity = format!("{}, {treatment}: e({quantity})", suite.name());
        let reference = printed[k].unwrap_or(0.0);
        let subject = Subject::new(NAME, &quantity, if has_own { LONG } else { PAPER });
        let error = errors[k];
        checks.push(match (suite.case, k, treatment) {
            (Case::Ramp, 0, "characteristic") => subject.relative(error, reference, RAMP),
            (Case::Ramp, 0, "hybrid") => subject.absolute(error, reference, RAMP_HYBRID),
            (Case::Vortex, 1, _) => subject.at_most(error, ALONG),
            (Case::Vortex, 2, _) if !has_own => subject.at_most(error, ACROSS * reference),
            _ => subject.informs(error, reference),
        });
    }
    checks
}
