//! The rows of one run around a body.

use aero_validation::table::{Check, Subject};

use super::common_rows;
use crate::validate::outcome::{Attempt, Outcome};

/// Rows of one run.
pub(super) struct Rows<'a> {
    name: &'a str,
    label: &'a str,
    strict: bool,
    pub(super) checks: Vec<Check>,
}

impl<'a> Rows<'a> {
    /// The rows that every run gets; those of the published scheme only inform.
    pub(super) fn new(name: &'a str, label: &'a str, equations: &str, tried: &Attempt) -> Self {
        let strict = equations == "conservative";
        Self {
            name,
            label,
            strict,
            checks: common_rows(name, label, strict, tried),
        }
    }

    /// `measured` must lie within `allowed` per cent of `reference`.
    pub(super) fn relative(
        &mut self,
        quantity: &str,
        source: &str,
        [measured, reference, allowed]: [f64; 3],
    ) {
        let quantity = format!("{}: {quantity}", self.label);
        let subject = Subject::new(self.name, &quantity, source);
        self.checks.push(if self.strict {
            subject.relative(measured, reference, allowed)
        } else {
            subject.informs(measured, reference)
        });
    }

    /// `measured` must not exceed `bound`.
    pub(super) fn at_most(&mut self, quantity: &str, source: &str, [measured, bound]: [f64; 2]) {
        let quantity = format!("{}: {quantity}", self.label);
        let subject = Subject::new(self.name, &quantity, source);
        self.checks.push(if self.strict {
            subject.at_most(measured, bound)
        } else {
            subject.informs(measured, bound)
        });
    }

    /// `measured` must lie between the bounds.
    pub(super) fn between(
        &mut self,
        quantity: &str,
        source: &str,
        (measured, [low, high]): (f64, [f64; 2]),
    ) {
        let quantity = format!("{}: {quantity}", self.label);
        let subject = Subject::new(self.name, &quantity, source);
        let middle = 0.5 * (low + high);
        self.checks.push(if self.strict {
            subject.absolute(measured, middle, 0.5 * (high - low))
        } else {
            subject.informs(measured, middle)
        });
    }

    /// A row for the reader.
    pub(super) fn informs(
        &mut self,
        quantity: &str,
        source: &str,
        [measured, reference]: [f64; 2],
    ) {
        let quantity = format!("{}: {quantity}", self.label);
        let subject = Subject::new(self.name, &quantity, source);
        self.checks.push(subject.informs(measured, reference));
    }
}

/// The outcome of a run that came to its end.
pub(super) fn ended(tried: Attempt) -> Option<Box<Outcome>> {
    match tried {
        Attempt::Ended(outcome) => Some(outcome),
        Attempt::Stopped(..) => None,
    }
}

/// Middle value; NaN where there is none.
pub(super) fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}
