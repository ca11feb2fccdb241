//! Points that stay where they are, through the command line.

use crate::support::{BOX, PRESSURE_RATIO, Workplace, box_with, fixed_wedge, read_vtp};

#[test]
fn the_wedge_settles_on_the_force_that_theory_has() {
    let place = Workplace::new();
    place
        .run(&fixed_wedge(), &["--set", "spacing=0.125"])
        .succeeds();
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

/// Nothing in it changes by a twentieth from cell to cell; a bend asks for one halving.
#[test]
fn a_flow_too_slow_for_points_to_be_added_is_told_so() {
    let rest = box_with(
        "density = 0.125, pressure = 0.1",
        "density = 1.0, pressure = 1.0",
    );
    let rod = "shape = { circle = { radius = 0.15 } }\nplace = { translate = [0.5, 0.25] }";
    let scene = format!("{rest}\n[[body]]\nname = \"rod\"\n{rod}\n");
    let told = "`scheme.refine = 2` was asked for, and no point has a smaller spacing than 0.025:";
    let place = Workplace::new();
    let settings = ["scheme.motion=fixed", "scheme.refine=2"];
    let settings = settings.map(|setting| ["--set", setting]).concat();
    let answer = place.run(&scene, &settings);
    answer.succeeds();
    assert!(answer.out.contains(told), "{}", answer.out);
    let summary = place.json("results/summary.json");
    let warnings = summary["warnings"].to_string();
    assert!(warnings.contains(told), "{warnings}");
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
        place
            .run(&fixed_wedge(), &[&march[..], more].concat())
            .succeeds();
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
    place.run(&fixed_wedge(), &settings).succeeds();
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
    Workplace::new().run(&fixed_wedge(), &too_few).refuses(&[
        "scheme.refine",
        "100 points",
        "larger `spacing`",
    ]);
}

#[test]
fn minutes_are_turned_into_points_once() {
    let place = Workplace::new();
    let settings = [
        "--set",
        "spacing=0.25",
        "--set",
        "scheme.refine={minutes=0.02}",
    ];
    let answer = place.run(&fixed_wedge(), &settings);
    answer.succeeds();
    assert!(
        answer.err.contains("refine = { points = "),
        "{}",
        answer.err
    );
    let scene = std::fs::read_to_string(place.path("results/run.toml")).unwrap();
    assert!(scene.contains("scheme.refine.points = "), "{scene}");
    let again = [&["run", "scene.toml", "--out", "results"], &settings[..]].concat();
    let again = place.aero(&again);
    again.succeeds();
    assert!(
        again.err.contains("as the run in the folder before"),
        "{}",
        again.err
    );
    // The scene as it was run is one that can be run.
    let taken = place.aero(&["run", "results/run.toml", "--out", "taken"]);
    taken.succeeds();
    let [history, same] = ["results", "taken"].map(|folder| {
        let path = place.path(&format!("{folder}/history.csv"));
        std::fs::read_to_string(path).unwrap()
    });
    assert_eq!(history, same);
    // A run in time is given halvings.
    let marched = [
        &settings[..],
        &["--set", "stop=end-time", "--set", "end_time=0.5"],
    ]
    .concat();
    let answer = Workplace::new().run(&fixed_wedge(), &marched);
    answer.succeeds();
    assert!(answer.err.contains("refine = "), "{}", answer.err);
    let both = ["--set", "scheme.refine={minutes=1, points=1000}"];
    Workplace::new()
        .run(&fixed_wedge(), &both)
        .refuses(&["scheme.refine", "one of"]);
    for (table, word) in [
        ("{flow=1}", "both `flow = N` and `bodies = M`"),
        (
            "{flow=1, bodies=11}",
            "11 is not a number of halvings from 0 to 10",
        ),
    ] {
        let setting = format!("scheme.refine={table}");
        Workplace::new()
            .run(&fixed_wedge(), &["--set", &setting])
            .refuses(&["scheme.refine", word]);
    }
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
        ("skip_undisturbed", "false"),
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

/// A third of a spacing is left between the wall and the side that it is to close.
#[test]
fn a_side_that_its_body_does_not_reach_is_refused() {
    let lowered = fixed_wedge().replace("corner = [0.0, 0.0]", "corner = [0.0, -0.02]");
    assert_ne!(lowered, fixed_wedge());
    Workplace::new().run(&lowered, &[]).refuses(&[
        "side `y_min`",
        "closed by a body",
        "at (",
        "reach across",
    ]);
}

#[test]
fn the_courant_number_of_a_scene_is_that_of_its_steps() {
    let scene = BOX.replace("[domain]\n", "[scheme]\nmotion = \"fixed\"\n\n[domain]\n");
    let steps = |cfl: &str| {
        let place = Workplace::new();
        let cfl = format!("scheme.cfl={cfl}");
        let settings = [
            "--set",
            "end_time=0.4",
            "--set",
            "output.frames=1",
            "--set",
            &cfl,
        ];
        place.run(&scene, &settings).succeeds();
        place.json("results/summary.json")["steps"]
            .as_f64()
            .unwrap()
    };
    let ratio = steps("0.2") / steps("0.8");
    assert!((3.0..5.0).contains(&ratio), "{ratio}");
    Workplace::new()
        .run(
            &scene,
            &["--set", "scheme.cfl=0.4", "--set", "scheme.time=settle"],
        )
        .refuses(&["scheme.cfl", "scheme.time = \"accurate\""]);
}
