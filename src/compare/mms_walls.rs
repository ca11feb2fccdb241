//! Wall treatments compared: weakly compressible gas beside walls, kept to manufactured solutions, with ghosts after eight publications [Negi &
//! Ramachandran 2022, doi:10.1063/5.0126234]. For verification alone: nothing of it is in the solver.

mod arrangement;
mod equations;
mod flow;
mod ghosts;
mod operators;
mod picture;
mod published;
mod solution;
mod study;
#[cfg(test)]
mod tests;
mod treatment;
mod treatments;
mod verdict;

use aero_validation::table::{Check, Subject};

use super::context::{CompareError, Context, Level};
use super::suite::Suite;
use super::variant::Levels;
use arrangement::{Arrangement, Form};
use picture::{Lines, OWN};
use published::printed;
use solution::{Condition, Family};
use study::Study;
use verdict::{Judged, NAME, own_row, planted_row};

const PAPER: &str = "Negi & Ramachandran 2022, table I";

/// Walls and whether particles are packed beside them; at the quick level the first two alone.
const ARRANGEMENTS: [(Form, bool); 5] = [
    (Form::Straight, false),
    (Form::Concave, true),
    (Form::Convex, true),
    (Form::Concave, false),
    (Form::Convex, false),
];
/// Spacings to the unit of length: of our solutions, quick and full, and of the paper's, down to its finest where it has a table.
const QUICK: [u32; 3] = [0, 50, 100];
const FULL: [u32; 3] = [75, 150, 300];
const PUBLISHED: [u32; 3] = [50, 100, 200];
const TABLE: [u32; 3] = [125, 250, 500];

/// The treatments, wall by wall.
pub const WALLS: Suite = Suite::of(&[(Levels::Both, compare)]);

fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let is_quick = context.level == Level::Quick;
    let walls = if is_quick { 2 } else { ARRANGEMENTS.len() };
    if !context.settings.is_empty() {
        (context.announce)(&format!(
            "{NAME}: has no scene, --set changes nothing of it"
        ));
    }
    let mut checks = Vec::new();
    for (form, is_packed) in &ARRANGEMENTS[..walls] {
        let arrangement = Arrangement {
            form: *form,
            is_packed: *is_packed,
            cells: 0,
        };
        let study = Study::new(arrangement, if is_quick { QUICK } else { FULL })?;
        checks.extend(judge(&study, is_quick, context)?);
        if !is_quick && *form == Form::Straight {
            let planted = |condition| planted_row(&study, condition);
            checks.extend(Condition::ALL.map(planted));
        }
        if !is_quick {
            let has_table = (*form, *is_packed) == (Form::Concave, true);
            let study = Study::new(arrangement, if has_table { TABLE } else { PUBLISHED })?;
            checks.extend(repeat(&study, context));
        }
    }
    Ok(checks)
}

/// Our solutions, with verdicts and a picture.
fn judge(study: &Study, is_quick: bool, context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let mut checks = Vec::new();
    let mut drawn = Vec::new();
    for condition in Condition::ALL {
        announce(study, condition, "slopes at the wall", context);
        let base = study.base(Family::Sheared, condition);
        let own = study.own(&base);
        checks.push(own_row(study, condition, &own));
        let mut lines: Lines = vec![(OWN, own.clone())];
        for treatment in kept(condition) {
            let added = study.added(&base, treatment, None);
            let judged = Judged {
                study,
                condition,
                treatment,
                own: &own,
                is_quick,
            };
            checks.extend(judged.rows(&added));
            lines.push((treatment.name(), added));
        }
        drawn.push((condition, lines));
    }
    picture::draw(study, &drawn, context)?;
    Ok(checks)
}

/// The paper's solutions, beside its figures.
fn repeat(study: &Study, context: &Context<'_>) -> Vec<Check> {
    let mut checks = Vec::new();
    for condition in Condition::ALL {
        announce(study, condition, "the paper's solution", context);
        let base = study.base(Family::Published, condition);
        let (place, range) = (study.arrangement.name(), study.range());
        let mut tell = |name: &str, errors: &study::Errors, printed: Option<published::Printed>| {
            let what = format!("paper's {}, {place}, {name}, {range}", condition.name());
            let quantity = format!("{what}: order, last pair");
            let order = printed.and_then(|printed| printed.order).unwrap_or(0.0);
            let subject = Subject::new(NAME, &quantity, PAPER);
            checks.push(subject.informs(errors.order(condition), order));
            let quantity = format!("{what}: mean error at the finest");
            let error = printed.map_or(0.0, |printed| printed.error);
            let subject = Subject::new(NAME, &quantity, PAPER);
            checks.push(subject.informs(errors.finest(condition), error));
        };
        tell("ghosts with the solution", &study.own(&base), None);
        for treatment in kept(condition) {
            let has_table = study.cells == TABLE;
            let printed = has_table.then(|| printed(treatment.name(), condition));
            let errors = study.errors(&base, treatment);
            tell(treatment.name(), &errors, printed.flatten());
        }
    }
    checks
}

/// The treatments that keep a condition.
fn kept(condition: Condition) -> impl Iterator<Item = &'static dyn treatment::Treatment> {
    let all = treatments::ALL.into_iter();
    all.filter(move |treatment| treatment.keeps(condition))
}

fn announce(study: &Study, condition: Condition, whose: &str, context: &Context<'_>) {
    let (place, range) = (study.arrangement.name(), study.range());
    (context.announce)(&format!(
        "{NAME}: {}, {place}, {whose}, {range}",
        condition.name()
    ));
}
