//! The quick level's limits: each row is held to about twice the error that it had when the table was written, where its
//! case allows more. What a case allows says how right the method is meant to be; the table says when it gets worse.
//!
//! `AERO_LIMITS_OF=FOLDER cargo test --release limits_written -- --ignored` writes the table anew from the
//! `validation.json` that `aero validate --quick --out FOLDER` has left.

use std::collections::BTreeMap;

use aero_validation::table::{Check, Subject};

/// Allowed errors by case and quantity, per cent, as [`Check::allowed_percent`] counts them.
#[derive(Clone, Debug, Default)]
pub struct Limits(BTreeMap<String, BTreeMap<String, f64>>);

/// The table of the project.
const TABLE: &str = include_str!("../../validation/quick-limits.json");

impl Limits {
    /// Those of the project.
    ///
    /// # Errors
    /// A table that cannot be read.
    pub fn of_the_quick_level() -> Result<Self, serde_json::Error> {
        serde_json::from_str(TABLE).map(Self)
    }

    /// Holds a row to its limit, where that is below what its case allows. True if the table knows the row.
    pub fn hold(&self, check: &mut Check) -> bool {
        let limit = self
            .0
            .get(&check.case)
            .and_then(|rows| rows.get(&check.quantity));
        if let Some(limit) = limit {
            check.allow_at_most(*limit);
        }
        limit.is_some()
    }

    /// Rows that fail, for each line of the table that none of `checks`, all that the level runs, answers to: a row that is no
    /// longer measured is missed.
    pub fn unanswered(&self, checks: &[Check]) -> Vec<Check> {
        let is_answered = |case: &str, quantity: &str| {
            checks
                .iter()
                .any(|check| check.case == case && check.quantity == quantity)
        };
        let mut missed = Vec::new();
        for (case, rows) in &self.0 {
            for quantity in rows.keys().filter(|quantity| !is_answered(case, quantity)) {
                let source = "validation/quick-limits.json, which no row answers to";
                missed.push(Subject::new(case, quantity, source).unmeasured(0.0));
            }
        }
        missed
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Errors below half of this change with the order of sums in flows that amplify it, per cent.
    const LEAST: f64 = 0.25;

    fn row(measured: f64) -> Check {
        Subject::new("wedge", "plateau", "theory").relative(measured, 1.0, 5.0)
    }

    fn limits(limit: f64) -> Limits {
        let rows = BTreeMap::from([("plateau".to_owned(), limit)]);
        Limits(BTreeMap::from([("wedge".to_owned(), rows)]))
    }

    #[test]
    fn a_row_is_held_to_the_table() {
        let mut check = row(1.03);
        assert!(check.pass && limits(2.0).hold(&mut check));
        assert!(!check.pass && check.allowed_percent == Some(2.0));
    }

    #[test]
    fn the_table_does_not_allow_more_than_the_case() {
        let mut check = row(1.06);
        assert!(limits(9.0).hold(&mut check) && !check.pass);
        assert_eq!(check.allowed_percent, Some(5.0));
    }

    #[test]
    fn rows_without_a_verdict_and_unknown_ones_stay() {
        let mut informs = Subject::new("wedge", "plateau", "theory").informs(1.5, 1.0);
        limits(2.0).hold(&mut informs);
        assert!(informs.pass && informs.allowed_percent.is_none());
        let mut other = Subject::new("wedge", "angle", "theory").relative(1.03, 1.0, 5.0);
        assert!(!limits(2.0).hold(&mut other) && other.pass);
    }

    #[test]
    fn a_line_that_no_row_answers_to_fails() {
        assert!(limits(2.0).unanswered(&[row(1.0)]).is_empty());
        let missed = limits(2.0).unanswered(&[]);
        assert!(missed.len() == 1 && !missed[0].pass);
    }

    #[test]
    fn the_table_names_cases_of_the_project_and_limits_above_zero() {
        let table = Limits::of_the_quick_level().expect("a table");
        assert!(!table.0.is_empty());
        for (case, rows) in &table.0 {
            assert!(crate::CASES.iter().any(|known| known.0 == case), "{case}");
            assert!(rows.values().all(|limit| *limit >= LEAST), "{case}");
        }
    }

    /// Writes the table from measured rows; see the module.
    #[test]
    #[ignore = "writes the table of limits from rows that AERO_LIMITS_OF names"]
    fn limits_written_from_measured_rows() {
        let folder = std::env::var("AERO_LIMITS_OF").expect("a folder in AERO_LIMITS_OF");
        let text = std::fs::read_to_string(format!("{folder}/validation.json")).expect("rows");
        let rows: Vec<Check> = serde_json::from_str(&text).expect("rows");
        let held = Limits::of_the_quick_level().expect("a table");
        let mut table = Limits::default();
        for mut check in rows {
            let allowed = check.allowed_percent.unwrap_or(0.0);
            // Rounded up to three digits.
            let limit = (2.0 * check.error_percent.abs()).max(LEAST);
            let step = 10.0_f64.powf(limit.log10().floor() - 2.0);
            let limit = (limit / step).ceil() * step;
            // What a line of the table allows is no longer what its case does.
            if held.hold(&mut check) || limit < allowed {
                let limit = format!("{limit:.4}").parse().expect("a number");
                let of_case = table.0.entry(check.case).or_default();
                of_case.insert(check.quantity, limit);
            }
        }
        let text = serde_json::to_string_pretty(&table.0).expect("a table") + "\n";
        let path = concat!(
            env!("CARGO_MANIFEST_DIR"),
            "/../../validation/quick-limits.json"
        );
        std::fs::write(path, text).expect("written");
    }
}
