//! A polar in one command, against shock-expansion theory.

use crate::support::Workplace;
use aero_validation::exact::shock_expansion::Biconvex;
use serde_json::Value;

/// The aerofoil of `cases/biconvex.toml` in a box that its shocks leave through the outlet.
const AEROFOIL: &str = r#"
dimension = 2
spacing = 0.025
stop = "steady"

[scheme]
motion = "fixed"
refine = 2

[free_stream]
mach = 4.04
density = 1.4
pressure = 1.0

[domain]
min = [-0.25, -0.75]
max = [1.25, 0.75]

[domain.sides]
x_min = "inlet"
x_max = "outlet"
y_min = "free-stream"
y_max = "free-stream"

[[body]]
name = "aerofoil"
shape = { biconvex = { chord = 1.0, thickness_ratio = 0.1 } }
reference_area = 1.0
reference_length = 1.0

[output]
frames = 1
"#;

/// Departure from theory, of the largest lift and of the drag.
const LIFT: f64 = 0.02;
const DRAG: f64 = 0.03;

/// Difference from a run of its own, of the largest force: a few tolerances of the flow's coming to rest.
const ALONE: f64 = 5e-4;

#[test]
fn a_polar_is_that_of_theory_and_of_single_runs_for_a_third_of_their_iterations() {
    let place = Workplace::new();
    place.write("aerofoil.toml", AEROFOIL);
    let sweep = |out: &str, threads: &str| {
        let command = [
            "sweep",
            "aerofoil.toml",
            "--incidence",
            "2..8:2",
            "--out",
            out,
            "--threads",
            threads,
        ];
        place.aero(&command).succeeds();
    };
    sweep("polar", "1");
    let rows = place.json("polar/sweep.json");
    let rows = rows.as_array().unwrap();
    let number = |row: &Value, key: &str| row[key].as_f64().unwrap();
    let theory = Biconvex::new(0.1, 4.04, 1.4).unwrap();
    let exact = |row: &Value| {
        theory
            .at_incidence(number(row, "incidence").to_radians())
            .unwrap()
    };
    let largest = exact(&rows[3]).lift;
    for row in rows {
        let exact = exact(row);
        assert!(
            (number(row, "cl") - exact.lift).abs() < LIFT * largest,
            "{row} {exact:?}"
        );
        assert!(
            (number(row, "cd") / exact.drag - 1.0).abs() < DRAG,
            "{row} {exact:?}"
        );
    }

    let run = [
        "run",
        "aerofoil.toml",
        "--set",
        "free_stream.incidence=8",
        "--out",
        "alone",
    ];
    place.aero(&run).succeeds();
    let of = |folder: &str| place.json(&format!("{folder}/summary.json"));
    let (alone, third, last) = (
        of("alone"),
        of("polar/incidence-6"),
        of("polar/incidence-8"),
    );
    let loads =
        |summary: &Value| ["cd", "cl"].map(|key| number(&summary["bodies"]["aerofoil"], key));
    for (alone, swept) in loads(&alone).into_iter().zip(loads(&last)) {
        assert!((alone - swept).abs() < ALONE * largest, "{alone} {swept}");
    }
    for swept in [third, last] {
        let (swept, alone) = (number(&swept, "steps"), number(&alone, "steps"));
        assert!(swept < 0.35 * alone, "{swept} {alone}");
    }
    // One frame: that of the start is its neighbour's last.
    for (point, frames) in [(2, 2), (8, 1)] {
        let folder = place.path(&format!("polar/incidence-{point}"));
        let files = std::fs::read_dir(folder).unwrap().map(|file| file.unwrap());
        let names = files.map(|file| file.file_name().into_string().unwrap());
        assert_eq!(
            names.filter(|name| name.starts_with("frame-")).count(),
            frames,
            "{point}"
        );
    }
}
