//! Tests of the table of comparisons.

use super::*;

const BETA: Subject<'_> = Subject::new("wedge", "shock angle, deg", "oblique-shock theory");
const LEAKS: Subject<'_> = Subject::new("wedge", "leaked particles", "none may leak");

#[test]
fn relative_errors_are_judged_by_their_size() {
    assert!(BETA.relative(29.9, 29.8, 0.5).pass);
    assert!(BETA.relative(29.7, 29.8, 0.5).pass);
    let failed = BETA.relative(31.0, 29.8, 0.5);
    assert!(!failed.pass && failed.error_percent > 4.0);
    let negative = BETA.relative(-1.1, -1.0, 5.0);
    assert!((negative.error_percent + 10.0).abs() < 1e-9 && !negative.pass);
}

#[test]
fn absolute_errors_are_judged_in_the_unit_of_the_quantity() {
    assert!(BETA.absolute(30.0, 29.8, 0.21).pass);
    assert!(!BETA.absolute(30.1, 29.8, 0.21).pass);
    let zero = LEAKS.absolute(0.02, 0.0, 0.03);
    assert!(zero.pass && zero.error_percent == 2.0 && zero.allowed_percent == Some(3.0));
    // Exactly the allowed error passes in spite of round-off.
    assert!(BETA.absolute(1.7, 1.6, 1.7 - 1.6).pass);
}

#[test]
fn a_bound_is_kept_or_exceeded() {
    assert!(LEAKS.at_most(0.0, 0.0).pass);
    assert!(LEAKS.at_most(-3.0, 0.0).pass);
    let failed = LEAKS.at_most(2.0, 0.0);
    assert!(!failed.pass && failed.error_percent == 200.0);
    let drift = Subject::new("sod", "energy drift", "conservation").at_most(3e-6, 1e-6);
    assert!(!drift.pass && (drift.error_percent - 200.0).abs() < 1e-9);
}

#[test]
fn what_is_not_a_number_never_passes() {
    assert!(!BETA.relative(f64::NAN, 29.8, 100.0).pass);
    assert!(!BETA.absolute(f64::INFINITY, 29.8, 100.0).pass);
    assert!(!LEAKS.at_most(f64::NAN, 5.0).pass);
    assert!(!BETA.unmeasured(29.8).pass);
}

#[test]
fn rows_that_inform_do_not_count() {
    let rows = [BETA.informs(50.0, 29.8), BETA.relative(29.8, 29.8, 0.1)];
    assert!(rows.iter().all(|row| row.pass));
    let text = to_text(&rows);
    assert!(text.ends_with("1 of 1 checks pass\n"), "{text}");
}

#[test]
fn the_text_is_aligned_and_names_a_case_once() {
    let rows = [
        BETA.relative(29.7654, 29.800_916, 0.5),
        LEAKS.at_most(3.0, 0.0),
        Subject::new("sod", "L1 density error", "exact").at_most(4.2e-3, 6e-3),
    ];
    let text = to_text(&rows);
    let expected = "\
case   quantity           measured  reference  error %  allowed %  verdict
--------------------------------------------------------------------------
wedge  shock angle, deg     29.765     29.801    -0.12       0.50  pass
       leaked particles          3          0  +300.00       0.00  FAIL
sod    L1 density error  0.0042000  0.0060000     0.00       0.00  pass
2 of 3 checks pass
";
    assert_eq!(text, expected);
}

#[test]
fn the_json_has_the_documented_fields_and_reads_back() {
    let rows = vec![BETA.relative(29.7, 29.8, 0.5), BETA.unmeasured(29.8)];
    let json = to_json(&rows).unwrap();
    let value: serde_json::Value = serde_json::from_str(&json).unwrap();
    let mut fields: Vec<&str> = value[0]
        .as_object()
        .unwrap()
        .keys()
        .map(String::as_str)
        .collect();
    fields.sort_unstable();
    assert_eq!(
        fields,
        [
            "allowed_percent",
            "case",
            "error_percent",
            "measured",
            "pass",
            "quantity",
            "reference",
            "source"
        ]
    );
    assert!(value[1]["measured"].is_null());
    let back: Vec<Check> = serde_json::from_str(&json).unwrap();
    assert_eq!(back[0], rows[0]);
    assert!(back[1].measured.is_nan() && !back[1].pass);
}

#[test]
fn the_json_file_is_written_where_asked() {
    let folder = tempfile::tempdir().unwrap();
    write_json(&[BETA.relative(29.7, 29.8, 0.5)], folder.path()).unwrap();
    let text = std::fs::read_to_string(folder.path().join("validation.json")).unwrap();
    assert!(text.starts_with('['));
    assert!(write_json(&[], &folder.path().join("absent")).is_err());
}

#[test]
fn markdown_cells_keep_their_bars_to_themselves() {
    let row = Subject::new("cone", "max |grad rho|", "a|b").relative(1.0, 1.0, 1.0);
    let text = to_markdown(&[row]);
    let last = text.lines().last().unwrap();
    assert_eq!(last.matches(" | ").count(), 7, "{last}");
}

#[test]
fn numbers_keep_five_digits_and_switch_to_powers_of_ten() {
    assert_eq!(number(29.800_916), "29.801");
    assert_eq!(number(123_456.7), "123457");
    assert_eq!(number(0.014_284), "0.014284");
    assert_eq!(number(-3.0), "-3");
    assert_eq!(number(1.25e-7), "1.250e-7");
    assert_eq!(number(f64::NAN), "not finite");
    assert_eq!(percent(0.012, true), "+0.0120");
}

#[test]
fn a_least_value_is_reached_or_missed_by_what_it_falls_short() {
    let order = Subject::new("sod", "order", "first order at jumps");
    assert!(order.at_least(0.9, 0.8).pass && order.at_least(0.9, 0.8).error_percent == 0.0);
    let failed = order.at_least(0.6, 0.8);
    assert!(!failed.pass && (failed.error_percent + 25.0).abs() < 1e-9);
    assert!(!order.at_least(f64::NAN, 0.8).pass);
}
