//! A polar in one command, against shock-expansion theory.

use crate::support::Workplace;
use aero_validation::exact::shock_expansion::Biconvex;
use serde_json::Value;

/// An aerofoil in a box that its shocks leave through the outlet.
const AEROFOIL: &str = include_str!("../cases/polar.toml");

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
        assert!(swept < 0.28 * alone, "{swept} {alone}");
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

/// Points from below a body that is its own mirror image are those from above; those of one that is not, of a moment about a place off its
/// middle, or in a box that reaches farther up are run.
#[test]
fn a_symmetric_half_of_a_polar_is_not_run() {
    let place = Workplace::new();
    let coarse = AEROFOIL
        .replace("spacing = 0.025", "spacing = 0.05")
        .replace("refine = 2", "refine = 1");
    let sweep = |scene: &str, angles: &str, out: &str| {
        place.write("aerofoil.toml", scene);
        let list = ["--incidence", angles, "--out", out];
        let answer = place.aero(&[&["sweep", "aerofoil.toml"][..], &list].concat());
        answer.succeeds();
        let rows = place.json(&format!("{out}/sweep.json"));
        (answer.out, rows.as_array().expect("rows").clone())
    };
    let (said, rows) = sweep(&coarse, "-2,0,2,4", "polar");
    assert!(said.contains("mirror images of others: 1 of 4"), "{said}");
    let number = |row: &Value, key: &str| row[key].as_f64().expect("a number");
    let angles: Vec<f64> = rows.iter().map(|row| number(row, "incidence")).collect();
    assert_eq!(angles, [-2.0, 0.0, 2.0, 4.0]);
    assert_eq!(rows[0]["mirror_of"], "incidence-2");
    assert!(!place.path("polar/incidence--2").exists());
    let run = ["run", "aerofoil.toml", "--out", "alone", "--set"];
    let alone = place.aero(&[&run[..], &["free_stream.incidence=-2"]].concat());
    alone.succeeds();
    let alone = &place.json("alone/summary.json")["bodies"]["aerofoil"];
    let largest = number(&rows[3], "cl");
    for key in ["cd", "cl", "cm"] {
        let [own, image] = [alone, &rows[0]].map(|row| number(row, key));
        assert!(
            (own - image).abs() < ALONE * largest,
            "{key}: {own} {image}"
        );
    }
    let shape = "{ biconvex = { chord = 1.0, thickness_ratio = 0.1 } }";
    let crooked = "{ polygon = { points = [[0.0, 0.0], [0.5, -0.03], [1.0, 0.0], [0.4, 0.03]] } }";
    let aside = "moment_centre = [0.5, 0.1]\nreference_area";
    for (number, (old, new)) in [
        ("max = [1.25, 0.75]", "max = [1.25, 0.8]"),
        ("y_max = \"free-stream\"", "y_max = \"outlet\""),
        ("reference_area", aside),
        (shape, crooked),
    ]
    .into_iter()
    .enumerate()
    {
        assert!(coarse.contains(old), "{old}");
        let (said, rows) = sweep(&coarse.replace(old, new), "-2,2", &number.to_string());
        assert!(!said.contains("mirror images"), "{new}: {said}");
        assert!(rows.iter().all(|row| row["mirror_of"].is_null()), "{new}");
    }
}
