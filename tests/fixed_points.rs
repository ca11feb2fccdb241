//! Points that stay where they are, through the command line.

mod support;

use std::path::Path;

use support::{BOX, Workplace, box_with, read_vtp};

/// The pressure behind the Mach 2.5, 20 degree shock over that before it: NACA Report 1135 (1953), eq. 128.
const PRESSURE_RATIO: f64 = 3.2109;

fn wedge() -> String {
    let scene = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/wedge-fixed.toml");
    std::fs::read_to_string(scene).expect("the scene")
}

#[test]
fn the_wedge_settles_on_the_force_that_theory_has() {
    let place = Workplace::new();
    place.run(&wedge(), &["--set", "spacing=0.125"]).succeeds();
    let summary = place.json("results/summary.json");
    assert_eq!(summary["motion"], "fixed");
    let reason = summary["stop_reason"].as_str().unwrap();
    assert!(reason.starts_with("settled"), "{reason}");
    assert!(summary["conservation"].is_null());
    // Absolute pressure on a ramp three long, at 20 degrees.
    let force = &summary["bodies"]["ramp"]["force"][0];
    let height = 3.0 * 20.0_f64.to_radians().tan();
    let exact = PRESSURE_RATIO / 1.4 * height;
    let error = force.as_f64().unwrap() / exact - 1.0;
    assert!(error.abs() < 0.005, "{error}");
}

#[test]
fn any_number_of_threads_and_a_run_in_two_parts_give_the_same_bits() {
    let march = [
        "--set",
        "stop=end-time",
        "--set",
        "end_time=0.5",
        "--set",
        "spacing=0.125",
    ];
    let frame = |more: &[&str]| {
        let place = Workplace::new();
        place.run(&wedge(), &[&march[..], more].concat()).succeeds();
        std::fs::read(place.path("results/frame-000020.vtp")).expect("the last frame")
    };
    assert!(frame(&["--threads", "1"]) == frame(&["--threads", "2"]));
    let refined = |threads| frame(&["--threads", threads, "--set", "scheme.refine=1"]);
    assert!(refined("1") == refined("2"));
}

#[test]
fn points_are_added_at_the_shock_and_told_of() {
    let place = Workplace::new();
    let settings = ["--set", "spacing=0.25", "--set", "scheme.refine=2"];
    place.run(&wedge(), &settings).succeeds();
    let summary = place.json("results/summary.json");
    let counts: Vec<u64> = summary["points_per_level"]
        .as_array()
        .unwrap()
        .iter()
        .map(|count| count.as_u64().unwrap())
        .collect();
    assert_eq!(counts.len(), 3);
    assert_eq!(
        counts.iter().sum::<u64>(),
        summary["particles"]["fluid"].as_u64().unwrap()
    );
    assert!(counts[2] > counts[0], "{counts:?}");
    let (points, arrays) = read_vtp(&place.path("results/frame-000001.vtp"));
    let spacing = arrays.iter().find(|(name, _)| name == "spacing");
    assert_eq!(spacing.map(|(_, length)| *length), Some(points));
    let too_few = [
        "--set",
        "scheme.refine={ points = 100 }",
        "--set",
        "spacing=0.25",
    ];
    Workplace::new().run(&wedge(), &too_few).refuses(&[
        "scheme.refine",
        "100 points",
        "larger `spacing`",
    ]);
}

#[test]
fn what_points_that_stay_cannot_do_is_refused_by_name() {
    let fixed = |old: &str, new: &str| {
        let scene = box_with(old, new);
        scene.replace("[domain]\n", "[scheme]\nmotion = \"fixed\"\n\n[domain]\n")
    };
    let moving = fixed("x_max = \"wall\"", "x_max = { wall = { velocity = 0.5 } }");
    Workplace::new()
        .run(&moving, &[])
        .refuses(&["side `x_max` moves", "with-the-gas"]);
    let still = fixed("[domain]", "[domain]");
    for (key, value) in [
        ("equations", "paper"),
        ("shifting", "true"),
        ("precision", "mixed"),
    ] {
        let setting = format!("scheme.{key}={value}");
        Workplace::new()
            .run(&still, &["--set", &setting])
            .refuses(&[&format!("scheme.{key}"), "particles that move with the gas"]);
    }
    for setting in ["scheme.time=settle", "scheme.refine=2"] {
        let key = setting.split('=').next().unwrap();
        Workplace::new()
            .run(BOX, &["--set", setting])
            .refuses(&[key, "scheme.motion = \"fixed\""]);
    }
}
