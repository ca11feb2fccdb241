//! `aero chart` runs a case at some spacings in each variant and writes chart and table.

use crate::support::Workplace;

/// The table of a case that has been charted.
fn charted(place: &Workplace, case: &str, spacings: &str) -> String {
    let arguments = ["chart", case, "--spacings", spacings, "--out", "charts"];
    place.aero(&arguments).succeeds();
    let table = std::fs::read_to_string(place.path(&format!("charts/{case}.csv"))).unwrap();
    let header = table.lines().next();
    assert_eq!(header, Some("series,peer,label,cpu_seconds,error"));
    table
}

/// Those of one series.
fn errors(table: &str, series: &str) -> Vec<f64> {
    let name = format!("\"{series}\",false,");
    let rows = table.lines().filter_map(|line| line.strip_prefix(&name));
    rows.map(|rest| rest.rsplit(',').next().unwrap().parse().unwrap())
        .collect()
}

#[test]
fn a_case_is_charted_in_every_variant_with_its_peers() {
    let place = Workplace::new();
    let table = charted(&place, "wedge", "1");
    for variant in [
        "conservative, wom",
        "conservative, wm",
        "conservative, wom, coarse start",
        "conservative, wom, coarse start, mixed",
        "paper, wom",
        "paper, wm",
    ] {
        let errors = errors(&table, variant);
        assert!(errors.len() == 1 && errors[0] < 10.0, "{variant}: {table}");
    }
    for peer in ["Eilmer 5,true,1/32,", "rhoCentralFoam,true,1/64,", "PySPH"] {
        assert!(table.contains(peer), "{table}");
    }
    let picture = std::fs::read_to_string(place.path("charts/wedge.svg")).unwrap();
    for word in ["CPU time, s", "density error", "paper, wm", "1/8"] {
        assert!(picture.contains(word), "{word}");
    }
}

#[test]
fn errors_fall_from_spacing_to_spacing() {
    let place = Workplace::new();
    let table = charted(&place, "sod", "2");
    for variant in [
        "conservative, wom",
        "conservative, wm",
        "paper, wom",
        "paper, wm",
        "points, marched",
    ] {
        let errors = errors(&table, variant);
        assert!(errors.len() == 2 && errors[1] < 0.7 * errors[0], "{table}");
    }
}

#[test]
fn what_cannot_be_charted_is_refused() {
    let place = Workplace::new();
    let answer = place.aero(&["chart", "square"]);
    answer.refuses(&[
        "unknown case `square`",
        "wedge, sod, cylinder, biconvex, cone, sphere, double-mach",
    ]);
    assert_eq!(place.aero(&["chart", "wedge", "--spacings", "0"]).status, 2);
}
