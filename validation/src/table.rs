//! Comparisons with theory as rows: measured, reference, error, allowed, verdict; and the table as
//! text, Markdown and JSON.

use serde::{Deserialize, Serialize};
use std::fmt::Write as _;
use std::path::Path;

/// One comparison. In JSON the fields are as named here; a value that is not finite becomes `null`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Check {
    /// Name of the case.
    pub case: String,
    /// What was measured, with its unit.
    pub quantity: String,
    /// The value measured.
    #[serde(deserialize_with = "null_is_nan")]
    pub measured: f64,
    /// The value it should have, or the bound it should keep.
    #[serde(deserialize_with = "null_is_nan")]
    pub reference: f64,
    /// Error, per cent of the reference.
    #[serde(deserialize_with = "null_is_nan")]
    pub error_percent: f64,
    /// Largest error that passes, per cent; none for a row that only informs.
    pub allowed_percent: Option<f64>,
    /// Whether the error is allowed; a row that only informs always passes.
    pub pass: bool,
    /// Where the reference comes from.
    pub source: String,
}

impl Check {
    /// Allows an error of `limit` per cent, unless less is allowed already; a row that only informs, or that keeps a bound,
    /// stays as it is.
    pub fn allow_at_most(&mut self, limit: f64) {
        if self.allowed_percent.is_some_and(|allowed| limit < allowed) {
            self.allowed_percent = Some(limit);
            self.pass = is_allowed(self.error_percent, self.allowed_percent);
        }
    }
}

/// A comparison with NaN is false, so a value that is not a number never passes; round-off in the percentages must not fail
/// an error that is just allowed.
fn is_allowed(error: f64, allowed: Option<f64>) -> bool {
    allowed.is_none_or(|limit| error.abs() <= limit * (1.0 + 1e-12))
}

/// What a row is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Subject<'a> {
    /// Name of the case.
    pub case: &'a str,
    /// What was measured, with its unit.
    pub quantity: &'a str,
    /// Where the reference comes from.
    pub source: &'a str,
}

impl<'a> Subject<'a> {
    /// A subject from its three texts.
    pub const fn new(case: &'a str, quantity: &'a str, source: &'a str) -> Self {
        Self {
            case,
            quantity,
            source,
        }
    }

    /// The measured value must lie within `allowed_percent` of the reference, which must not be
    /// zero.
    pub fn relative(self, measured: f64, reference: f64, allowed_percent: f64) -> Check {
        let error = 100.0 * (measured - reference) / reference.abs();
        self.row(measured, reference, error, Some(allowed_percent))
    }

    /// The measured value must lie within `allowed` (in the quantity's unit) of the reference.
    ///
    /// Both are still written as per cent: of the reference, or of one unit where that is zero.
    pub fn absolute(self, measured: f64, reference: f64, allowed: f64) -> Check {
        let unit = if reference == 0.0 {
            1.0
        } else {
            reference.abs()
        };
        let error = 100.0 * (measured - reference) / unit;
        self.row(measured, reference, error, Some(100.0 * allowed / unit))
    }

    /// The measured value must not exceed `bound`; the error is the excess, zero if there is none,
    /// and none is allowed. With a bound of zero the error is per cent of one unit.
    pub fn at_most(self, measured: f64, bound: f64) -> Check {
        let unit = if bound == 0.0 { 1.0 } else { bound.abs() };
        // Not f64::max, which would hide a NaN.
        let excess = if measured <= bound {
            0.0
        } else {
            measured - bound
        };
        self.row(measured, bound, 100.0 * excess / unit, Some(0.0))
    }

    /// The measured value must reach `bound`; the error is what it falls short by, zero if nothing,
    /// and none is allowed. With a bound of zero the error is per cent of one unit.
    pub fn at_least(self, measured: f64, bound: f64) -> Check {
        let unit = if bound == 0.0 { 1.0 } else { bound.abs() };
        // Not f64::min, which would hide a NaN.
        let lack = if measured >= bound {
            0.0
        } else {
            measured - bound
        };
        self.row(measured, bound, 100.0 * lack / unit, Some(0.0))
    }

    /// A row for the reader, without a verdict.
    pub fn informs(self, measured: f64, reference: f64) -> Check {
        let unit = if reference == 0.0 {
            1.0
        } else {
            reference.abs()
        };
        let error = 100.0 * (measured - reference) / unit;
        self.row(measured, reference, error, None)
    }

    /// A row for a quantity that could not be measured: it fails.
    pub fn unmeasured(self, reference: f64) -> Check {
        self.row(f64::NAN, reference, f64::NAN, Some(0.0))
    }

    fn row(self, measured: f64, reference: f64, error: f64, allowed: Option<f64>) -> Check {
        Check {
            case: self.case.to_owned(),
            quantity: self.quantity.to_owned(),
            measured,
            reference,
            error_percent: error,
            allowed_percent: allowed,
            pass: is_allowed(error, allowed),
            source: self.source.to_owned(),
        }
    }
}

/// Headings of the text and Markdown tables.
const HEADINGS: [&str; 7] = [
    "case",
    "quantity",
    "measured",
    "reference",
    "error %",
    "allowed %",
    "verdict",
];

/// The rows with aligned columns, a case's name only on its first row, and a summary line.
pub fn to_text(checks: &[Check]) -> String {
    let mut rows: Vec<[String; 7]> = vec![HEADINGS.map(str::to_owned)];
    let mut previous = "";
    for check in checks {
        let mut row = cells(check);
        if check.case == previous {
            row[0].clear();
        }
        previous = &check.case;
        rows.push(row);
    }
    let widths: [usize; 7] =
        std::array::from_fn(|k| rows.iter().map(|r| r[k].chars().count()).max().unwrap_or(0));
    let mut text = String::new();
    for (number, row) in rows.iter().enumerate() {
        let mut line = String::new();
        for (k, cell) in row.iter().enumerate() {
            let gap = " ".repeat(widths[k] - cell.chars().count());
            // Words lean left, numbers right.
            let padded = if (2..6).contains(&k) {
                format!("{gap}{cell}")
            } else {
                format!("{cell}{gap}")
            };
            let _ = write!(line, "{}{padded}", if k == 0 { "" } else { "  " });
        }
        let _ = writeln!(text, "{}", line.trim_end());
        if number == 0 {
            let total = widths.iter().sum::<usize>() + 2 * (widths.len() - 1);
            let _ = writeln!(text, "{}", "-".repeat(total));
        }
    }
    let _ = writeln!(text, "{}", summary(checks));
    text
}

/// The rows as a Markdown table, with the sources in the last column.
pub fn to_markdown(checks: &[Check]) -> String {
    let mut text = format!("| {} | source |\n", HEADINGS.join(" | "));
    text.push_str("|---|---|---:|---:|---:|---:|---|---|\n");
    let escape = |cell: &str| cell.replace('|', "\\|").replace('\n', " ");
    for check in checks {
        let row = cells(check).map(|c| escape(&c));
        let _ = writeln!(text, "| {} | {} |", row.join(" | "), escape(&check.source));
    }
    text
}

/// The rows as a JSON list.
pub fn to_json(checks: &[Check]) -> serde_json::Result<String> {
    serde_json::to_string_pretty(checks).map(|text| text + "\n")
}

/// Writes the rows as `validation.json` into `folder`, which must exist.
pub fn write_json(checks: &[Check], folder: &Path) -> std::io::Result<()> {
    std::fs::write(folder.join("validation.json"), to_json(checks)?)
}

fn cells(check: &Check) -> [String; 7] {
    let verdict = match (check.allowed_percent, check.pass) {
        (None, _) => "-",
        (_, true) => "pass",
        (_, false) => "FAIL",
    };
    [
        check.case.clone(),
        check.quantity.clone(),
        number(check.measured),
        number(check.reference),
        percent(check.error_percent, true),
        check
            .allowed_percent
            .map_or_else(|| "-".to_owned(), |v| percent(v, false)),
        verdict.to_owned(),
    ]
}

fn summary(checks: &[Check]) -> String {
    let judged: Vec<&Check> = checks
        .iter()
        .filter(|c| c.allowed_percent.is_some())
        .collect();
    let passed = judged.iter().filter(|c| c.pass).count();
    format!("{passed} of {} checks pass", judged.len())
}

/// Five significant digits, whole numbers plain; powers of ten where a plain number is long.
fn number(value: f64) -> String {
    if !value.is_finite() {
        return "not finite".to_owned();
    }
    let size = value.abs();
    if value.fract() == 0.0 && size < 1e6 {
        format!("{value:.0}")
    } else if (1e-4..1e6).contains(&size) {
        let digits = (4 - size.log10().floor() as i32).max(0) as usize;
        format!("{value:.digits$}")
    } else {
        format!("{value:.3e}")
    }
}

/// Two decimals, more for small values; with a sign where asked.
fn percent(value: f64, signed: bool) -> String {
    if !value.is_finite() {
        return "not finite".to_owned();
    }
    let digits = if value == 0.0 || value.abs() >= 0.1 {
        2
    } else {
        4
    };
    if value.abs() >= 1e5 {
        format!("{value:.1e}")
    } else if signed && value != 0.0 {
        format!("{value:+.digits$}")
    } else {
        format!("{value:.digits$}")
    }
}

fn null_is_nan<'de, D: serde::Deserializer<'de>>(from: D) -> Result<f64, D::Error> {
    Option::<f64>::deserialize(from).map(|v| v.unwrap_or(f64::NAN))
}

#[cfg(test)]
#[path = "table_tests.rs"]
mod tests;
