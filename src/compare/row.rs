//! A row of a comparison before it is called and judged.

use aero_validation::table::{Check, Subject};

/// A quantity beside what it should be.
#[derive(Clone, Debug)]
pub struct Row {
    quantity: String,
    /// Where the reference comes from.
    source: &'static str,
    measured: f64,
    reference: f64,
    rule: Rule,
    /// Judged even where the scheme is shown for comparison alone.
    is_judged_always: bool,
}

/// How a row is judged.
#[derive(Clone, Copy, Debug)]
enum Rule {
    /// Within so many per cent of the reference.
    Relative(Allowed),
    /// Within so much of the reference, in the quantity's unit.
    Absolute(Allowed),
    /// In size not above the reference; without a verdict beside zero.
    Error,
    /// Not above a bound.
    AtMost(Allowed),
    /// Not at all.
    Informs,
    /// It fails, by whatever scheme.
    Unmeasured,
}

/// The largest error that passes, at the quick level and at the full one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Allowed {
    quick: f64,
    full: f64,
}

impl From<f64> for Allowed {
    fn from(allowed: f64) -> Self {
        Self {
            quick: allowed,
            full: allowed,
        }
    }
}

impl From<[f64; 2]> for Allowed {
    fn from([quick, full]: [f64; 2]) -> Self {
        Self { quick, full }
    }
}

impl Allowed {
    fn at(self, is_quick: bool) -> f64 {
        if is_quick { self.quick } else { self.full }
    }
}

/// Whose row it is.
#[derive(Clone, Copy, Debug)]
pub struct Heading<'a> {
    /// Name of the case.
    pub case: &'a str,
    /// Stands before the quantity.
    pub label: &'a str,
    /// Without a verdict, whatever the row says.
    pub only_informs: bool,
    /// What is allowed is that of the quick level.
    pub is_quick: bool,
}

impl Row {
    /// `measured` must lie within `allowed` per cent of `reference`, which is not zero.
    pub fn relative(
        quantity: impl Into<String>,
        source: &'static str,
        measured: f64,
        reference: f64,
        allowed: impl Into<Allowed>,
    ) -> Self {
        let rule = Rule::Relative(allowed.into());
        Self::new(quantity, source, [measured, reference], rule)
    }

    /// `measured` must lie within `allowed`, in its own unit, of `reference`.
    pub fn absolute(
        quantity: impl Into<String>,
        source: &'static str,
        measured: f64,
        reference: f64,
        allowed: impl Into<Allowed>,
    ) -> Self {
        let rule = Rule::Absolute(allowed.into());
        Self::new(quantity, source, [measured, reference], rule)
    }

    /// An error, which is to be zero: its size must not exceed `bound`.
    pub fn error(
        quantity: impl Into<String>,
        source: &'static str,
        measured: f64,
        bound: f64,
    ) -> Self {
        Self::new(quantity, source, [measured, bound], Rule::Error)
    }

    /// `measured` must not exceed `bound`.
    pub fn at_most(
        quantity: impl Into<String>,
        source: &'static str,
        measured: f64,
        bound: impl Into<Allowed>,
    ) -> Self {
        let rule = Rule::AtMost(bound.into());
        Self::new(quantity, source, [measured, 0.0], rule)
    }

    /// The same with another allowance where the gas is carried by points that stay, `is_of_points`.
    #[must_use]
    pub fn by_points(mut self, is_of_points: bool, allowed: impl Into<Allowed>) -> Self {
        if is_of_points {
            match &mut self.rule {
                Rule::Relative(now) | Rule::Absolute(now) | Rule::AtMost(now) => {
                    *now = allowed.into();
                }
                Rule::Error | Rule::Informs | Rule::Unmeasured => {}
            }
        }
        self
    }

    /// The same, judged even where the scheme is shown for comparison alone: it says whether that is still the scheme that is
    /// shown.
    pub fn always(self) -> Self {
        Self {
            is_judged_always: true,
            ..self
        }
    }

    /// A row for the reader, without a verdict.
    pub fn informs(
        quantity: impl Into<String>,
        source: &'static str,
        measured: f64,
        reference: f64,
    ) -> Self {
        Self::new(quantity, source, [measured, reference], Rule::Informs)
    }

    /// A row for a quantity that could not be measured: it fails.
    pub fn unmeasured(quantity: impl Into<String>, source: &'static str) -> Self {
        Self::new(quantity, source, [f64::NAN, 0.0], Rule::Unmeasured)
    }

    fn new(
        quantity: impl Into<String>,
        source: &'static str,
        [measured, reference]: [f64; 2],
        rule: Rule,
    ) -> Self {
        Self {
            quantity: quantity.into(),
            source,
            measured,
            reference,
            rule,
            is_judged_always: false,
        }
    }

    /// The row under its heading, judged.
    pub fn check(self, heading: Heading<'_>) -> Check {
        let quantity = format!("{}: {}", heading.label, self.quantity);
        let subject = Subject::new(heading.case, &quantity, self.source);
        let (measured, reference) = (self.measured, self.reference);
        let only_informs = heading.only_informs && !self.is_judged_always;
        match self.rule {
            Rule::Unmeasured => subject.unmeasured(reference),
            Rule::Error if only_informs => subject.informs(measured, 0.0),
            _ if only_informs => subject.informs(measured, reference),
            Rule::Relative(allowed) => {
                subject.relative(measured, reference, allowed.at(heading.is_quick))
            }
            Rule::Absolute(allowed) => {
                subject.absolute(measured, reference, allowed.at(heading.is_quick))
            }
            Rule::Error => subject.at_most(measured.abs(), reference),
            Rule::AtMost(bound) => subject.at_most(measured, bound.at(heading.is_quick)),
            Rule::Informs => subject.informs(measured, reference),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEADING: Heading<'_> = Heading {
        case: "step",
        label: "dx 1/40",
        only_informs: false,
        is_quick: true,
    };

    #[test]
    fn what_is_allowed_goes_with_the_level() {
        let row = || Row::relative("height", "book", 1.03, 1.0, [4.0, 2.0]);
        let quick = row().check(HEADING);
        assert_eq!(quick.quantity, "dx 1/40: height");
        assert!(quick.pass && quick.allowed_percent == Some(4.0));
        let full = row().check(Heading {
            is_quick: false,
            ..HEADING
        });
        assert!(!full.pass && full.allowed_percent == Some(2.0));
    }

    #[test]
    fn a_scheme_that_is_shown_for_comparison_has_no_verdict() {
        let shown = Heading {
            only_informs: true,
            ..HEADING
        };
        let row = Row::at_most("leaks", "book", 7.0, 0.0).check(shown);
        assert!(row.pass && row.allowed_percent.is_none());
        let kept = Row::at_most("leaks", "book", 7.0, [8.0, 0.0]).always();
        assert!(kept.clone().check(shown).pass);
        let full = Heading {
            is_quick: false,
            ..shown
        };
        assert!(!kept.check(full).pass);
    }
}
