//! Whose results a folder holds, and when a run may end by itself.

use crate::support::{BOX, Workplace, box_with};

const RUN: [&str; 4] = ["run", "scene.toml", "--out", "results"];

#[test]
fn what_another_scene_has_left_is_not_written_over_unasked() {
    let place = Workplace::new();
    place.write("scene.toml", BOX);
    place.aero(&RUN).succeeds();
    // The same once more is no loss.
    place.aero(&RUN).succeeds();
    let other = [&RUN[..], &["--set", "end_time=0.01"]].concat();
    place
        .aero(&other)
        .refuses(&["results", "another run", "--overwrite"]);
    let frames = || {
        let names = std::fs::read_dir(place.path("results")).expect("results");
        let names = names.map(|entry| entry.expect("a file").file_name());
        names
            .filter(|name| name.to_string_lossy().starts_with("frame-"))
            .count()
    };
    let before = frames();
    place
        .aero(&[&other[..], &["--set", "output.frames=1", "--overwrite"]].concat())
        .succeeds();
    // None of a longer run is taken for one of the shorter.
    assert!(before > 2 && frames() == 2, "{before} {}", frames());
}

#[test]
fn two_runs_share_no_folder_and_the_dead_hold_none() {
    let place = Workplace::new();
    place.write("scene.toml", BOX);
    let long = [&RUN[..], &["--set", "end_time=1e9"]].concat();
    let mut first = std::process::Command::new(assert_cmd::cargo::cargo_bin("aero"))
        .current_dir(place.path(""))
        .args(&long)
        .stderr(std::process::Stdio::null())
        .spawn()
        .expect("the program");
    let begun = std::time::Instant::now();
    while !place.path("results/run.toml").exists() {
        assert!(begun.elapsed().as_secs() < 60, "it does not begin");
        std::thread::sleep(std::time::Duration::from_millis(20));
    }
    let second = place.aero(&RUN);
    first.kill().expect("a process");
    first.wait().expect("its end");
    second.refuses(&["another run is writing", "results"]);
    // The file stays, as after a crash; nobody holds it.
    assert!(place.path("results/.lock").exists());
    place.run(BOX, &[]).succeeds();
}

/// The compression corner about points that stay, without an end.
const CORNER: &str = r#"
dimension = 2
spacing = 0.125
stop = "steady"

[scheme]
motion = "fixed"

[free_stream]
mach = 2.5
density = 1.0
pressure = 0.7142857142857143

[domain]
min = [-1.0, 0.0]
max = [3.0, 3.0]

[domain.sides]
x_min = "inlet"
x_max = "outlet"
y_min = "body"
y_max = "free-stream"

[[body]]
name = "ramp"
shape = { compression_corner = { angle = 20.0 } }
reference_area = 1.0
"#;

#[test]
fn a_run_that_stops_when_it_is_steady_needs_no_end() {
    let place = Workplace::new();
    place.run(CORNER, &[]).succeeds();
    let summary = place.json("results/summary.json");
    let reason = summary["stop_reason"].as_str().expect("a reason");
    assert!(reason.starts_with("settled"), "{reason}");
    place
        .run(&box_with("end_time = 0.02", ""), &[])
        .refuses(&["end_time", "stop = \"steady\""]);
}

/// Before the first run, not after the last.
#[test]
fn a_scene_without_a_body_is_refused_a_study_before_it_runs() {
    let place = Workplace::new();
    place.write("box.toml", BOX);
    place
        .aero(&["converge", "box.toml", "--out", "study"])
        .refuses(&["no body in a stream"]);
    assert!(!place.path("study").exists());
}

#[test]
fn a_scene_converges_to_oblique_shock_theory() {
    let place = Workplace::new();
    place.write("ramp.toml", CORNER);
    let arguments = [
        "converge",
        "ramp.toml",
        "--out",
        "study",
        "--set",
        "spacing=0.03125",
    ];
    let answer = place.aero(&arguments);
    answer.succeeds();
    assert!(answer.out.contains("order"), "{}", answer.out);
    assert!(place.path("study/converge.svg").exists());
    let second = std::fs::read_to_string(place.path("study/spacing-2/run.toml")).expect("a scene");
    let start = second
        .lines()
        .find(|line| line.starts_with("initial.frame"));
    assert!(
        start.is_some_and(|line| line.contains("spacing-1/frame-")),
        "{second}"
    );
    let rows = place.json("study/converge.json");
    let row = &rows[0];
    // These three show none.
    assert!(row.get("order").is_some(), "{row}");
    assert_eq!(
        (row["body"].as_str(), row["coefficient"].as_str()),
        (Some("ramp"), Some("cd"))
    );
    assert_eq!(row["spacings"].as_array().map(Vec::len), Some(3));
    // The ramp from x = 0 to 3 at 20 degrees, under the pressure behind its shock: Cp = 0.50535 (NACA 1135) over its height.
    let exact = 0.50535 * 3.0 * 20_f64.to_radians().tan();
    let [value, band] = ["value", "band"].map(|key| row[key].as_f64().expect("a number"));
    assert!(
        (value - exact).abs() < band + 1e-3,
        "{value} +- {band}, {exact}"
    );
    assert!((value / exact - 1.0).abs() < 0.01, "{value} {exact}");
    place.aero(&arguments).refuses(&["study", "--overwrite"]);
}

/// A triangle from a file beside the scene.
const OUTLINE: &str = r#"
dimension = 2
spacing = 0.1
end_time = 0.02

[free_stream]
mach = 2.0
density = 1.0
pressure = 0.7142857142857143

[domain]
min = [-1.0, -1.0]
max = [2.0, 1.0]

[domain.sides]
x_min = "inlet"
x_max = "outlet"
y_min = "free-stream"
y_max = "free-stream"

[[body]]
name = "vane"
shape = { polygon_file = { file = "outlines/vane.txt" } }
"#;

#[test]
fn a_scene_that_was_run_runs_again_from_anywhere() {
    let place = Workplace::new();
    for folder in ["scenes/outlines", "elsewhere"] {
        std::fs::create_dir_all(place.path(folder)).expect("a folder");
    }
    place.write("scenes/scene.toml", OUTLINE);
    place.write("scenes/outlines/vane.txt", "0 0\n0.8 -0.4\n0.8 0.4\n");
    let run = ["run", "scenes/scene.toml", "--out", "results"];
    place.aero(&run).succeeds();
    std::fs::rename(
        place.path("results/run.toml"),
        place.path("elsewhere/it.toml"),
    )
    .expect("a scene");
    place
        .aero(&["run", "elsewhere/it.toml", "--out", "again"])
        .succeeds();
    let [one, other] = ["results", "again"]
        .map(|folder| std::fs::read(place.path(&format!("{folder}/history.csv"))).expect("rows"));
    assert_eq!(one, other);
    // Whole paths and their ends are the same scene, another file is another one.
    place
        .aero(&["run", "scenes/scene.toml", "--out", "again"])
        .succeeds();
    place.write("scenes/vane.txt", "0 0\n0.7 -0.4\n0.8 0.4\n");
    let other = "body.vane.shape={polygon_file={file=\"vane.txt\"}}";
    place
        .aero(&["run", "scenes/scene.toml", "--out", "again", "--set", other])
        .refuses(&["another run", "--overwrite"]);
}
