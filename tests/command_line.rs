//! What can be typed besides `pack`, `run` and `validate`.

use crate::support::Workplace;

#[test]
fn a_new_scene_is_written_once_and_never_over_another() {
    let place = Workplace::new();
    let answer = place.aero(&["new", "wedge"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    assert!(answer.out.contains("aero run wedge.toml"), "{}", answer.out);
    place
        .aero(&["new", "wedge"])
        .refuses(&["`wedge.toml` is there already", "aero new wedge FILE"]);
    assert_eq!(place.aero(&["new", "tube", "mine.toml"]).status, 0);
    let answer = place.aero(&[
        "run",
        "mine.toml",
        "--set",
        "end_time=0.001",
        "--out",
        "results",
    ]);
    assert_eq!(answer.status, 0, "{}", answer.err);
}

#[test]
fn kinds_are_listed_and_slips_of_the_finger_understood() {
    let place = Workplace::new();
    assert!(place.aero(&["new"]).out.contains("body"));
    place
        .aero(&["new", "cilinder"])
        .refuses(&["did you mean `cylinder`?"]);
    place
        .aero(&["validate", "wegde"])
        .refuses(&["did you mean `wedge`?"]);
    let answer = place.aero(&["valdate", "wedge"]);
    assert_eq!(answer.status, 2);
    assert!(answer.err.contains("'validate'"), "{}", answer.err);
}

#[test]
fn shells_and_manuals_are_served() {
    let place = Workplace::new();
    assert!(
        place
            .aero(&["completions", "bash"])
            .out
            .contains("validate")
    );
    let manual = place.aero(&["man"]).out;
    assert!(
        manual.contains(".TH aero") && manual.contains("resume"),
        "{manual}"
    );
}

#[test]
fn the_program_is_installed_as_the_readme_says_without_symbols() {
    let read = |name: &str| {
        let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(name);
        std::fs::read_to_string(path).unwrap()
    };
    assert!(read("README.md").contains("`cargo install --path .`"));
    let manifest: toml::Table = read("Cargo.toml").parse().unwrap();
    assert_eq!(
        manifest["profile"]["release"]["strip"].as_bool(),
        Some(true)
    );
}

/// A lens at Mach 3 about a few points that stay.
const LENS: &str = r#"
dimension = 2
spacing = 0.05
end_time = 20.0
stop = "steady"

[scheme]
motion = "fixed"

[free_stream]
mach = 3.0
density = 1.0
pressure = 0.7142857142857143

[domain]
min = [-0.3, -0.8]
max = [1.3, 0.8]

[domain.sides]
x_min = "inlet"
x_max = "outlet"
y_min = "free-stream"
y_max = "free-stream"

[[body]]
name = "lens"
shape = { biconvex = { chord = 1.0, thickness_ratio = 0.1 } }
"#;

#[test]
fn a_sweep_makes_a_polar_and_keeps_what_is_done() {
    let place = Workplace::new();
    place.write("lens.toml", LENS);
    let command = [
        "sweep",
        "lens.toml",
        "--incidence",
        "-2..2:2",
        "--out",
        "polar",
    ];
    let answer = place.aero(&command);
    assert_eq!(answer.status, 0, "{}", answer.err);
    let rows = place.json("polar/sweep.json");
    let csv = || std::fs::read_to_string(place.path("polar/sweep.csv")).unwrap();
    let first = csv();
    let lift = |row: usize| rows[row]["cl"].as_f64().unwrap();
    assert_eq!(rows.as_array().unwrap().len(), 3);
    assert!(rows[0]["settled"].as_bool().unwrap(), "{rows}");
    assert!(
        lift(2) > 0.05 && (lift(0) + lift(2)).abs() < 0.05 * lift(2),
        "{rows}"
    );
    assert!(place.path("polar/sweep.svg").exists());
    assert!(
        first.lines().nth(1).unwrap().starts_with("3,-2,,lens,"),
        "{first}"
    );

    // Two degrees on, a point starts from the last one; a Mach number on, it does not, and that is said.
    assert!(!answer.err.contains("free stream"), "{}", answer.err);
    let far = place.aero(&["sweep", "lens.toml", "--mach", "3,4", "--out", "far"]);
    far.succeeds();
    assert!(far.err.contains("starts in the free stream"), "{}", far.err);

    let again = place.aero(&command);
    assert!(!again.err.contains("iteration"), "{}", again.err);
    // The processor time tells that nothing was flown again.
    let seconds = |text: &str| -> Vec<String> {
        let last = |line: &str| line.rsplit(',').next().unwrap_or_default().to_owned();
        text.lines().map(last).collect()
    };
    assert_eq!(seconds(&csv()), seconds(&first));
    let other = [&command[..], &["--set", "spacing=0.1"]].concat();
    place.aero(&other).refuses(&["another scene", "--out"]);
    place
        .aero(&["sweep", "lens.toml"])
        .refuses(&["--incidence -4..8:2"]);
    place
        .aero(&["sweep", "lens.toml", "--mach", "1..2"])
        .refuses(&["no step"]);
}

#[test]
fn a_sweep_tells_which_of_its_points_have_not_settled() {
    let place = Workplace::new();
    let ends = LENS
        .replace("stop = \"steady\"", "")
        .replace("end_time = 20.0", "end_time = 0.1");
    place.write("lens.toml", ends);
    let answer = place.aero(&["sweep", "lens.toml", "--incidence", "0,2"]);
    answer.succeeds();
    assert!(
        answer.out.contains("2 of 2 rows are not settled"),
        "{}",
        answer.out
    );
    let rows = place.json("out/lens-sweep/sweep.json");
    for row in rows.as_array().unwrap() {
        assert_eq!(row["settled"], false, "{row}");
    }
}
