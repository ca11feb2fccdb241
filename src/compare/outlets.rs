//! Ways to end a flow compared: weakly compressible gas that leaves a duct by the outlets of four publications and by the project's own
//! [Negi, Ramachandran & Haftu 2020, arXiv:1907.04034]. For verification alone: nothing of it is in the solver.

mod cases;
mod duct;
mod flow;
mod particle;
mod picture;
mod published;
mod sound;
mod sums;
#[cfg(test)]
mod tests;
mod treatment;
mod treatments;
mod verdict;
mod wave;

use aero_validation::table::Check;
use rayon::prelude::*;

use super::context::{CompareError, Context, Level};
use super::suite;
use super::variant::Levels;
use cases::{Case, DAMPING, Record, Suite, errors};
use published::{DAMPINGS, VISCOSITIES};
use treatments::ALL;
use verdict::{NAME, echo_row, suite_rows};
use wave::Sound;

/// Mach numbers of streams that carry a sound, and how strong it is over the speed of sound.
const MACH: [f64; 3] = [0.1, 0.3, 0.6];
const STRENGTH: [f64; 2] = [0.001, 0.05];
/// Of the quick level.
const QUICK: Sound = Sound {
    mach: 0.3,
    strength: 0.001,
    cells: 50,
};
const CELLS: u32 = 100;

/// The treatments, flow by flow.
pub const OUTLETS: suite::Suite = suite::Suite::of(&[(Levels::Both, compare)]);

fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let is_quick = context.level == Level::Quick;
    if !context.settings.is_empty() {
        (context.announce)(&format!(
            "{NAME}: has no scene, --set changes nothing of it"
        ));
    }
    let mut checks = Vec::new();
    for sound in sounds(is_quick) {
        let Sound { mach, strength, .. } = sound;
        (context.announce)(&format!("{NAME}: sound, M {mach}, {strength} c"));
        checks.extend(echoes(&sound));
    }
    for suite in suites(is_quick) {
        (context.announce)(&format!("{NAME}: {}", suite.name()));
        checks.extend(run(&suite, context)?);
    }
    Ok(checks)
}

fn sounds(is_quick: bool) -> Vec<Sound> {
    if is_quick {
        return vec![QUICK];
    }
    let of = |mach| {
        STRENGTH.map(|strength| Sound {
            mach,
            strength,
            cells: CELLS,
        })
    };
    MACH.into_iter().flat_map(of).collect()
}

fn suites(is_quick: bool) -> Vec<Suite> {
    let plain = |case| Suite {
        case,
        damping: DAMPING,
        viscosity: 0.0,
    };
    if is_quick {
        return vec![plain(Case::Ramp)];
    }
    let damped = DAMPINGS.map(|damping| Suite {
        damping,
        ..plain(Case::Pulse)
    });
    let viscous = VISCOSITIES.map(|viscosity| Suite {
        viscosity,
        ..plain(Case::Vortex)
    });
    let ramp = [plain(Case::Ramp)];
    damped.into_iter().chain(ramp).chain(viscous).collect()
}

/// What comes back of a sound.
fn echoes(sound: &Sound) -> Vec<Check> {
    let reference = sound.reference();
    let row = |treatment: &&dyn treatment::Treatment| {
        let back = sound.comes_back(&reference, *treatment, None);
        echo_row(sound, *treatment, back)
    };
    ALL.par_iter().map(row).collect()
}

/// A flow of the suite, and its picture where it is that of the paper's first tables.
fn run(suite: &Suite, context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let (reference, records): (Record, Vec<Record>) = rayon::join(
        || suite.reference(),
        || {
            ALL.par_iter()
                .map(|treatment| suite.treated(*treatment))
                .collect()
        },
    );
    if suite.damping == DAMPING && suite.viscosity == 0.0 {
        picture::draw(suite, &reference, &records, context)?;
    }
    let rows = ALL.iter().zip(&records).flat_map(|(treatment, record)| {
        suite_rows(suite, treatment.name(), errors(record, &reference))
    });
    Ok(rows.collect())
}
