//! What is asked of a treatment, and its rows.

use aero_validation::table::{Check, Subject};

use super::arrangement::Manner;
use super::kept;
use super::solution::{Condition, Family};
use super::study::{Base, Errors, Study};
use super::treatment::{Mistake, Treatment};

pub const NAME: &str = "mms-walls";
const THEORY: &str = "manufactured solution with slopes at the wall (Roache 2002)";

/// Least orders of the last pair, where second and first are expected, at the quick level and at the full one.
const SECOND: [f64; 2] = [1.6, 1.7];
const FIRST: f64 = 0.8;

/// What is judged.
pub struct Judged<'a> {
    pub study: &'a Study,
    pub condition: Condition,
    pub treatment: &'a dyn Treatment,
    /// Errors with ghosts that take the solution.
    pub own: &'a Errors,
    pub is_quick: bool,
}

impl Judged<'_> {
    /// Rows on what the treatment `added`: its order, and its size over the scheme's own error, which it must not exceed beside a straight
    /// wall if it is of any order.
    pub fn rows(&self, added: &Errors) -> [Check; 2] {
        let Self {
            study,
            condition,
            treatment,
            ..
        } = self;
        let (name, kept) = (treatment.name(), condition.name());
        let (lie, range) = (study.arrangement.name(), study.range());
        let what = |of: &str| format!("{kept}, {lie}, {name}, {range}: {of}");
        let quantity = what("order of what it adds, last pair");
        let subject = Subject::new(NAME, &quantity, THEORY);
        let order = added.order(*condition);
        let is_judged = self.is_quick || treatment.lasts();
        let order = match treatment.order(*condition, study.manner()) {
            Some(wanted) if is_judged => subject.at_least(order, self.least(wanted)),
            Some(wanted) => subject.informs(order, wanted),
            None => subject.informs(order, 0.0),
        };
        let quantity = what("what it adds over the scheme's own error, at the finest");
        let subject = Subject::new(NAME, &quantity, THEORY);
        let share = added.finest(*condition) / self.own.finest(*condition);
        let is_small = study.manner() == Manner::Along && treatment.is_small();
        let share = if is_small && is_judged {
            subject.at_most(share, 1.0)
        } else {
            subject.informs(share, 0.0)
        };
        [order, share]
    }

    /// True if a row fails with a mistake.
    pub fn shows(&self, base: &Base, mistake: Mistake) -> bool {
        let added = self.study.added(base, self.treatment, Some(mistake));
        self.rows(&added).iter().any(|row| !row.pass)
    }

    fn least(&self, wanted: f64) -> f64 {
        if wanted < 2.0 {
            FIRST
        } else {
            SECOND[usize::from(!self.is_quick)]
        }
    }
}

/// The row on mistakes in the treatments of a condition that are judged at any spacing: those planted must each make a row fail.
pub fn planted_row(study: &Study, condition: Condition) -> Check {
    let base = study.base(Family::Sheared, condition);
    let own = study.own(&base);
    let (mut planted, mut caught) = (0, 0);
    for treatment in kept(condition).filter(|treatment| treatment.lasts()) {
        let judged = Judged {
            study,
            condition,
            treatment,
            own: &own,
            is_quick: false,
        };
        for mistake in treatment.mistakes(condition) {
            planted += 1;
            caught += i32::from(judged.shows(&base, *mistake));
        }
    }
    let (kept, lie, range) = (condition.name(), study.arrangement.name(), study.range());
    let quantity = format!("{kept}, {lie}, {range}: planted mistakes that show, of {planted}");
    let source = "a mistake must make a row fail";
    Subject::new(NAME, &quantity, source).at_least(f64::from(caught), f64::from(planted))
}

/// The row on the scheme itself.
pub fn own_row(study: &Study, condition: Condition, own: &Errors) -> Check {
    let (kept, lie, range) = (condition.name(), study.arrangement.name(), study.range());
    let quantity = format!("{kept}, {lie}, ghosts with the solution, {range}: order, last pair");
    Subject::new(NAME, &quantity, THEORY).at_least(own.order(condition), 1.7)
}
