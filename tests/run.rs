//! A run writes every file that it promises, and they read back.

use crate::support::{Answer, BOX, Workplace, read_surface, read_vtp, vtp_array};

const PARTICLE_ARRAYS: [&str; 11] = [
    "velocity",
    "density",
    "pressure",
    "energy",
    "mach",
    "smoothing_length",
    "volume",
    "mass",
    "entropy",
    "kind",
    "id",
];

const SUMMARY_KEYS: [&str; 21] = [
    "case",
    "scheme",
    "extrapolation",
    "dimension",
    "spacing",
    "particles",
    "steps",
    "end_time",
    "stop_reason",
    "wall_seconds",
    "cpu_seconds",
    "threads",
    "particle_updates_per_cpu_second",
    "neighbours_mean",
    "conservation",
    "bodies",
    "leaked",
    "returned",
    "mirror_fallbacks",
    "min_density",
    "min_energy",
];

#[test]
fn frames_hold_every_array_for_every_particle() {
    let place = Workplace::new();
    place.run(BOX, &[]).succeeds();
    for number in 0..3 {
        let (points, arrays) = read_vtp(&place.path(&format!("results/frame-00000{number}.vtp")));
        assert_eq!(points, 200);
        let names: Vec<&str> = arrays.iter().map(|(name, _)| name.as_str()).collect();
        assert_eq!(names, PARTICLE_ARRAYS);
        for (name, length) in &arrays {
            let components = if name == "velocity" { 3 } else { 1 };
            assert_eq!(*length, components * points, "{name}");
        }
    }
}

#[test]
fn masses_are_those_of_the_history_and_entropy_is_that_over_the_stream() {
    let place = Workplace::new();
    place.run(BOX, &[]).succeeds();
    let array = |number: u32, name: &str| {
        vtp_array(
            &place.path(&format!("results/frame-00000{number}.vtp")),
            name,
        )
    };
    let kinds = array(2, "kind");
    let gas = array(2, "mass").into_iter().zip(kinds);
    let mass: f64 = gas
        .filter(|(_, kind)| *kind == 0.0)
        .map(|(mass, _)| mass)
        .sum();
    let text = std::fs::read_to_string(place.path("results/history.csv")).expect("text");
    let column = text.lines().next().expect("a header").split(',');
    let column = column
        .clone()
        .position(|name| name == "mass")
        .expect("a mass");
    let last = text.lines().last().expect("a row").split(',').nth(column);
    let told: f64 = last.expect("a field").parse().expect("a number");
    assert!((mass / told - 1.0).abs() < 1e-12, "{mass} {told}");
    // The left state is what others are measured by.
    let right = (0.1_f64 / 1.0).ln() - 1.4 * (0.125_f64 / 1.0).ln();
    let kinds = array(0, "kind");
    for (entropy, kind) in array(0, "entropy").into_iter().zip(kinds) {
        let near = entropy.abs().min((entropy - right).abs());
        assert!(kind != 0.0 || near < 1e-12, "{entropy}");
    }
    let stream = "free_stream={ pressure = 1e5, temperature = 250.0, gas_constant = 290.0, velocity = [0.0, 0.0] }";
    place.run(BOX, &["--set", stream]).succeeds();
    let state = |name: &str| array(0, name)[0];
    let temperature = state("pressure") / (state("density") * 290.0);
    assert!((state("temperature") / temperature - 1.0).abs() < 1e-12);
}

/// Gas at rest in a closed tube, whose steps are far shorter than sound needs to cross it.
const TUBE: &str = r#"
dimension = 1
spacing = 0.0025
stop = "steady"

[domain]
min = [0.0]
max = [1.0]

[domain.sides]
x_min = "wall"
x_max = "wall"

[initial.riemann]
position = 0.5
left = { density = 1.0, pressure = 1.0 }
right = { density = 1.0, pressure = 1.0 }

[output]
frames = 1
"#;

/// A gas at rest is steady as soon as it can be told: after three windows, each as long as sound needs to cross the tube. How long the
/// run might have been is of no matter.
#[test]
fn a_steady_run_ends_early_and_says_why_wherever_its_end_is() {
    let place = Workplace::new();
    let marched = [
        "--set",
        "scheme={ motion = \"fixed\", time = \"accurate\" }",
    ];
    for motion in [&[][..], &marched] {
        let steps = [&[][..], &["--set", "end_time=1e9"]].map(|end| {
            place.run(TUBE, &[motion, end].concat()).succeeds();
            let summary = place.json("results/summary.json");
            let reason = summary["stop_reason"].as_str().unwrap();
            assert!(reason.starts_with("steady: "), "{reason}");
            let end = summary["end_time"].as_f64().unwrap();
            assert!((2.5..2.7).contains(&end), "{end}");
            summary["steps"].as_u64().unwrap()
        });
        assert!(steps[0] > 1000 && steps[0] == steps[1], "{steps:?}");
    }
    place.run(TUBE, &["--set", "end_time=0.02"]).succeeds();
    let summary = place.json("results/summary.json");
    let reason = summary["stop_reason"].as_str().unwrap();
    assert!(reason.contains("too early to tell"), "{reason}");
}

#[test]
fn the_collection_lists_the_frames_at_their_exact_times() {
    let place = Workplace::new();
    place.run(BOX, &[]).succeeds();
    let text = std::fs::read_to_string(place.path("results/run.pvd")).unwrap();
    for (time, number) in [("0.0", 0), ("0.01", 1), ("0.02", 2)] {
        let entry = format!("timestep=\"{time}\" part=\"0\" file=\"frame-00000{number}.vtp\"");
        assert!(text.contains(&entry), "{entry} is missing in {text}");
    }
    assert_eq!(text.matches("<DataSet").count(), 3);
}

#[test]
fn the_summary_holds_every_key() {
    let place = Workplace::new();
    place.run(BOX, &["--threads", "1"]).succeeds();
    let summary = place.json("results/summary.json");
    for key in SUMMARY_KEYS {
        assert!(!summary[key].is_null(), "`{key}` is missing");
    }
    assert_eq!(summary["case"], "scene");
    assert_eq!(summary["scheme"], "conservative");
    assert_eq!(summary["end_time"], 0.02);
    assert_eq!(summary["stop_reason"], "end time reached");
    assert_eq!(summary["threads"], 1);
    for key in ["mass", "momentum", "energy"] {
        let drift = summary["conservation"][key].as_f64().unwrap();
        assert!(drift.abs() < 1e-3, "{key} drifts by {drift}");
    }
}

#[test]
fn the_history_has_a_row_per_step_and_the_end_in_the_last() {
    let place = Workplace::new();
    place.run(BOX, &[]).succeeds();
    let text = std::fs::read_to_string(place.path("results/history.csv")).unwrap();
    let mut lines = text.lines();
    let header = lines.next().unwrap();
    assert!(header.starts_with("step,time,dt,x_min.fx,"), "{header}");
    assert!(header.ends_with(",mass,momentum_x,momentum_y,momentum_z,energy"));
    let columns = header.split(',').count();
    let rows: Vec<Vec<f64>> = lines
        .map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect())
        .collect();
    assert!(rows.iter().all(|row| row.len() == columns));
    let steps = place.json("results/summary.json")["steps"]
        .as_u64()
        .unwrap();
    assert_eq!(rows.len() as u64, steps);
    assert_eq!(rows[rows.len() - 1][1], 0.02);
}

#[test]
fn no_half_written_file_is_left() {
    let place = Workplace::new();
    place.run(BOX, &[]).succeeds();
    let names = std::fs::read_dir(place.path("results")).unwrap();
    for name in names {
        let name = name.unwrap().file_name();
        assert!(!name.to_string_lossy().contains(".part"), "{name:?}");
    }
}

#[test]
fn results_go_to_a_folder_of_the_scene_unless_told_otherwise() {
    let place = Workplace::new();
    place.write("quiet.toml", BOX);
    let answer = place.aero(&["run", "quiet.toml"]);
    answer.succeeds();
    assert!(
        answer.out.contains("results in `out/quiet`"),
        "{}",
        answer.out
    );
    assert!(place.path("out/quiet/summary.json").exists());
}

#[test]
fn a_folder_that_cannot_be_made_is_named() {
    let place = Workplace::new();
    place.write("taken", "a file");
    place.write("scene.toml", BOX);
    let answer = place.aero(&["run", "scene.toml", "--out", "taken/results"]);
    assert_eq!(answer.status, 1);
    assert!(
        answer.err.contains("cannot write `taken/results`"),
        "{}",
        answer.err
    );
}

#[test]
fn the_same_scene_gives_the_same_bytes_on_one_thread_and_on_two() {
    let frames = ["1", "2"].map(|threads| {
        let place = Workplace::new();
        place.run(BOX, &["--threads", threads]).succeeds();
        std::fs::read(place.path("results/frame-000002.vtp")).unwrap()
    });
    assert!(frames[0] == frames[1]);
}

#[test]
fn a_run_that_fails_leaves_its_last_good_frame_and_says_where_and_why() {
    let place = Workplace::new();
    // The energy of this gas is beyond what a number can hold.
    let answer = place.run(BOX, &["--set", "initial.riemann.left.pressure=1e308"]);
    check_failed(
        &place,
        &answer,
        &["no longer finite", "particle", "step 0", "time 0"],
    );
}

#[test]
fn a_run_whose_time_step_collapses_stops() {
    let place = Workplace::new();
    let stream = "free_stream={ density = 0.125, pressure = 0.1, velocity = [0.0, 0.0] }";
    let steady = [
        "--set",
        stream,
        "--set",
        "stop=steady",
        "--set",
        "end_time=1e9",
    ];
    for stop in [&[][..], &steady] {
        let hot = ["--set", "initial.riemann.left.pressure=1e150"];
        let answer = place.run(BOX, &[&hot, stop].concat());
        check_failed(
            &place,
            &answer,
            &["the time step collapsed to", "step 1001"],
        );
    }
}

#[track_caller]
fn check_failed(place: &Workplace, answer: &Answer, words: &[&str]) {
    assert_eq!(answer.status, 1, "{}", answer.err);
    for word in ["error: the run stopped: "].iter().chain(words) {
        assert!(
            answer.err.contains(word),
            "`{word}` is missing in: {}",
            answer.err
        );
    }
    let summary = place.json("results/summary.json");
    let reason = summary["stop_reason"].as_str().unwrap();
    assert!(answer.err.contains(reason), "{reason}");
    assert!(summary["end_time"].as_f64().unwrap() < 0.02);
    let text = std::fs::read_to_string(place.path("results/run.pvd")).unwrap();
    let last = format!("frame-{:06}.vtp", text.matches("<DataSet").count() - 1);
    assert!(text.contains(&last));
    let (points, _) = read_vtp(&place.path(&format!("results/{last}")));
    assert_eq!(points, 200);
}

#[test]
fn a_body_has_its_surface_and_its_loads_on_record() {
    let place = Workplace::new();
    let body = r#"
[free_stream]
mach = 0.5
density = 1.0
pressure = 1.0

[[body]]
name = "post"
shape = { circle = { radius = 0.1 } }
place = { translate = [0.5, 0.25] }
"#;
    let scene = BOX
        .replace("\"wall\"", "\"free-stream\"")
        .replace("[initial.riemann]", "[other]");
    let start = scene.find("[other]").unwrap();
    let end = scene.find("[output]").unwrap();
    let scene = format!("{}{body}{}", &scene[..start], &scene[end..]);
    place.run(&scene, &[]).succeeds();
    let surface = read_surface(&place.path("results/surface-000002.vtp"));
    assert!(surface.cells.len() > 8);
    let names: Vec<&str> = surface.arrays.keys().map(String::as_str).collect();
    let known = [
        "area",
        "body",
        "friction",
        "mach",
        "normal",
        "pressure",
        "pressure_coefficient",
    ];
    assert_eq!(names, known);
    let post = &place.json("results/summary.json")["bodies"]["post"];
    let area = post["reference_area"].as_f64().expect("a number");
    assert!((area - 0.2).abs() < 1e-12, "{area}");
    for key in ["force", "moment", "cd", "cl", "cm", "cd_mean", "cl_mean"] {
        assert!(!post[key].is_null(), "`{key}` is missing");
    }
    let history = std::fs::read_to_string(place.path("results/history.csv")).unwrap();
    assert!(history.starts_with("step,time,dt,post.fx,post.fy,post.fz,post.mx,"));
}

#[test]
fn frames_may_show_a_region_alone() {
    let place = Workplace::new();
    place.run(BOX, &[]).succeeds();
    let (all, _) = read_vtp(&place.path("results/frame-000002.vtp"));
    let region = "output.region={ min = [0.25, 0.0], max = [0.5, 0.5] }";
    place.run(BOX, &["--set", region]).succeeds();
    let (shown, _) = read_vtp(&place.path("results/frame-000002.vtp"));
    assert!(0 < shown && 2 * shown < all, "{shown} of {all}");
    place
        .run(
            BOX,
            &["--set", "output.region={ min = [0.5], max = [0.5] }"],
        )
        .refuses(&["output.region.min", "dimension 2"]);
    let empty = "output.region={ min = [0.5, 0.0], max = [0.5, 1.0] }";
    place
        .run(BOX, &["--set", empty])
        .refuses(&["output.region", "empty along x", "give a `max`"]);
}

#[test]
fn compressed_frames_are_smaller() {
    let place = Workplace::new();
    let size = |settings: &[&str]| {
        place.run(BOX, settings).succeeds();
        let path = place.path("results/frame-000000.vtp");
        std::fs::metadata(path).unwrap().len()
    };
    let (plain, compressed) = (size(&["--set", "output.compress=false"]), size(&[]));
    assert!(2 * compressed < plain, "{compressed} of {plain} bytes");
}
