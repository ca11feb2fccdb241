//! `aero chart` runs a case at some spacings in each variant and writes chart and table.

use crate::support::Workplace;

#[test]
fn a_case_is_charted_in_every_variant_with_its_peers() {
    let place = Workplace::new();
    let arguments = ["chart", "wedge", "--spacings", "2", "--out", "charts"];
    place.aero(&arguments).succeeds();
    let table = std::fs::read_to_string(place.path("charts/wedge.csv")).unwrap();
    let mut lines = table.lines();
    assert_eq!(lines.next(), Some("series,peer,label,cpu_seconds,error"));
    for variant in [
        "conservative, wom",
        "conservative, wm",
        "conservative, wom, coarse start",
        "conservative, wom, coarse start, mixed",
        "paper, wom",
        "paper, wm",
    ] {
        let name = format!("\"{variant}\",false,");
        let errors: Vec<f64> = table
            .lines()
            .filter_map(|line| line.strip_prefix(&name))
            .map(|rest| rest.rsplit(',').next().unwrap().parse().unwrap())
            .collect();
        assert_eq!(errors.len(), 2, "{table}");
        assert!(errors[1] < errors[0] && errors[0] < 10.0, "{table}");
    }
    for peer in ["Eilmer 5,true,1/32,", "rhoCentralFoam,true,1/64,", "PySPH"] {
        assert!(table.contains(peer), "{table}");
    }
    let picture = std::fs::read_to_string(place.path("charts/wedge.svg")).unwrap();
    for word in ["CPU time, s", "density error", "paper, wm", "1/12"] {
        assert!(picture.contains(word), "{word}");
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
