//! `aero fly`: from a file to coefficients with their bands and a report that opens by itself.

use std::f64::consts::TAU;

use crate::support::Workplace;
use crate::support::turned::{cone, turned};
use aero_validation::exact::cone::cone_flow;

/// A cylinder with a cone before it and a groove around it, its tip at the origin.
const GROOVED: [[f64; 2]; 8] = [
    [0.0, 0.0],
    [1.0, 0.5],
    [1.4, 0.5],
    [1.4, 0.4],
    [1.6, 0.4],
    [1.6, 0.5],
    [1.8, 0.5],
    [1.8, 0.0],
];

/// A ring, straight inside, with a ridge outside.
const RING: [[f64; 2]; 4] = [[0.0, 0.3], [0.5, 0.34], [1.0, 0.3], [0.0, 0.3]];

/// What faces away in a groove has the body behind it: its drag goes with that of the groove's other side.
#[test]
fn only_what_has_no_body_behind_it_is_base_and_grooves_get_points_of_their_own() {
    let place = Workplace::new();
    place.write("grooved.stl", turned(&GROOVED, 48));
    let flight = ["fly", "grooved.stl", "--mach", "2", "--spacing", "0.03"];
    place.aero(&flight).succeeds();
    let found = place.json("out/grooved-fly/fly.json");
    for level in found["levels"].as_array().expect("runs") {
        let number = |key: &str| level[key].as_f64().unwrap_or_else(|| panic!("{key}"));
        // The groove has 0.36 of the frontal area.
        assert!((number("base_area") - 1.0).abs() < 0.01, "{level}");
        assert!(number("finest") < 0.2 * number("spacing"), "{level}");
    }
}

const FLIGHT: [&str; 8] = [
    "fly",
    "cone.stl",
    "--mach",
    "3",
    "--spacing",
    "0.008",
    "--threads",
    "2",
];

/// The stream through a ring that is straight inside stays as it is: all of the drag is made outside, and a plane through the axis shows it.
#[test]
fn a_ring_is_flown_in_a_plane_through_its_axis() {
    let place = Workplace::new();
    place.write("ring.stl", turned(&RING, 96));
    let flight = ["fly", "ring.stl", "--mach", "2", "--spacing", "0.05"];
    let answer = place.aero(&flight);
    answer.succeeds();
    assert!(
        answer.out.contains("a body of revolution"),
        "{}",
        answer.out
    );
    let point = &place.json("out/ring-fly/fly.json")["points"][0];
    let number = |key: &str| point[key].as_f64().unwrap_or_else(|| panic!("{key}"));
    let (value, band) = (number("cd"), number("cd_band"));
    // By runs down to 1.5e-3 m.
    let right = 0.1699;
    assert!((value - right).abs() < band, "{value} {band}");
    assert!(band < 0.1 * right, "{band}");
    let scene = std::fs::read_to_string(place.path("out/ring-fly/scene.toml")).expect("a scene");
    assert!(scene.contains("y_min = \"axis\""), "{scene}");
}

#[test]
fn the_drag_of_a_cone_lies_in_its_band_and_the_report_needs_nothing_else() {
    let place = Workplace::new();
    place.write("cone.stl", cone(72));
    let answer = place.aero(&FLIGHT);
    answer.succeeds();
    for word in [
        "-z of the file",
        "body of revolution",
        "this will take about",
        "cd, drag",
    ] {
        assert!(answer.out.contains(word), "`{word}` in {}", answer.out);
    }
    let found = place.json("out/cone-fly/fly.json");
    let point = &found["points"][0];
    let number = |key: &str| point[key].as_f64().unwrap_or_else(|| panic!("{key}"));
    let theory = cone_flow(3.0, 20_f64.to_radians(), 1.4).expect("an attached shock");
    let exact = theory.pressure_coefficient;
    let (value, band) = (number("cd_forebody"), number("cd_forebody_band"));
    assert!((value - exact).abs() < band, "{value} +- {band}, {exact}");
    assert!((value / exact - 1.0).abs() < 0.05, "{value} {exact}");
    // Nothing is known of a base but that it lies between no drag and a vacuum.
    let base = number("cd_base");
    assert!(base > 0.0 && base < 2.0 / (1.4 * 9.0), "{base}");
    assert!(number("cd_base_band") > 1.0 / (1.4 * 9.0) - 1e-3);
    assert!(
        found["levels"]
            .as_array()
            .is_some_and(|runs| runs.len() == 4)
    );
    let page = std::fs::read_to_string(place.path("out/cone-fly/report.html")).expect("a page");
    assert!(page.contains("data:image/png;base64,") && page.contains("Schlieren"));
    for outside in ["src=\"http", "href=\"http", "<script", "@import"] {
        assert!(!page.contains(outside), "{outside}");
    }
    // What is there is not written over unasked.
    place
        .aero(&FLIGHT)
        .refuses(&["out/cone-fly", "--overwrite"]);
}

#[test]
fn a_body_is_swept_from_its_file() {
    let place = Workplace::new();
    place.write("cone.stl", cone(72));
    let sweep = |more: &[&str]| place.aero(&[&["sweep", "cone.stl"], more].concat());
    sweep(&["--mach", "2.5,3", "--spacing", "0.015"]).succeeds();
    let points = place.json("out/cone-sweep/sweep.json");
    let drags = [2.5, 3.0].map(|mach| {
        let rows = points.as_array().expect("a list");
        let row = rows.iter().find(|row| row["mach"] == mach).expect("a row");
        assert!(row["settled"] == true && row["points_or_particles"].as_u64() > Some(500));
        row["cd"].as_f64().expect("a drag")
    });
    for row in points.as_array().expect("rows") {
        let number = |key: &str| row[key].as_f64().unwrap_or_else(|| panic!("{key}"));
        assert!(
            (number("cd_forebody") + number("cd_base") - number("cd")).abs() < 1e-12,
            "{row}"
        );
        assert!(
            number("cd_forebody") > 0.0 && number("cd_base") > 0.0,
            "{row}"
        );
    }
    // Less of a faster stream, by cone and base alike.
    assert!(drags[0] > drags[1] && drags[1] > 0.3, "{drags:?}");
    sweep(&["--incidence", "0..4:2"]).refuses(&["--mach 1.5,2,3"]);
    place.write("a.toml", "");
    place
        .aero(&["sweep", "a.toml", "--mach", "2,3", "--altitude", "12km"])
        .refuses(&["is a scene", "--set"]);
}

#[test]
fn a_scene_is_written_as_it_would_be_run() {
    let place = Workplace::new();
    place.write("cone.stl", cone(36));
    let more = [
        "--incidence",
        "5",
        "--altitude",
        "12km",
        "--minutes",
        "0.4",
        "--scene",
        "it.toml",
    ];
    place.aero(&[&FLIGHT[..], &more].concat()).succeeds();
    let scene = std::fs::read_to_string(place.path("it.toml")).expect("a scene");
    for line in [
        "incidence = 5.0",
        "altitude = 12000.0",
        "z_min = \"symmetry\"",
        "y_min = \"free-stream\"",
    ] {
        assert!(scene.contains(line), "`{line}` in {scene}");
    }
    assert!(!place.path("out").exists());
}

#[test]
fn a_scene_holds_all_that_is_asked_of_a_flight_in_a_box_that_its_waves_leave() {
    let place = Workplace::new();
    place.write("cone.stl", cone(36));
    let scene = |mach: &str, roll: &str| {
        let air = "--pressure 2e4 --temperature 250";
        let how = "--incidence 5 --sideslip 3 --unit mm --axis -z,+x --motion with-the-gas";
        let line = format!(
            "fly cone.stl --mach {mach} --roll {roll} {air} {how} --spacing 1e-4 --minutes 0.2 --scene it.toml --overwrite"
        );
        let answer = place.aero(&line.split(' ').collect::<Vec<_>>());
        answer.succeeds();
        assert!(answer.out.contains("up is +x"), "{}", answer.out);
        std::fs::read_to_string(place.path("it.toml")).expect("a scene")
    };
    let scenes = [scene("1.5", "0"), scene("3", "30")];
    for line in [
        "mach = 1.5",
        "pressure = 20000.0",
        "temperature = 250.0",
        "incidence = 5.0",
        "sideslip = 3.0",
        "unit = \"mm\"",
        "stop = \"steady\"",
        "z_min = \"free-stream\"",
    ] {
        assert!(scenes[0].contains(line), "`{line}` in {}", scenes[0]);
    }
    assert!(!scenes[0].contains("fixed"), "{}", scenes[0]);
    let [slow, fast] = scenes.map(|scene| scene.parse::<toml::Table>().expect("TOML"));
    assert_ne!(slow["body"][0]["place"], fast["body"][0]["place"]);
    // Shocks stand steeper in a slower stream.
    let [slow, fast] = [slow, fast].map(|scene| scene["domain"]["max"][1].as_float());
    assert!(slow > fast.map(|top| 1.5 * top), "{slow:?} {fast:?}");
}

#[test]
fn a_flight_at_an_incidence_has_lift_moment_and_centre_of_pressure_with_their_bands() {
    let place = Workplace::new();
    place.write("cone.stl", cone(36));
    let answer = place.aero(&[
        "fly",
        "cone.stl",
        "--mach",
        "3",
        "--incidence",
        "5",
        "--spacing",
        "0.2",
        "--minutes",
        "1",
    ]);
    answer.succeeds();
    let found = place.json("out/cone-fly/fly.json");
    let point = &found["points"][0];
    let number = |key: &str| point[key].as_f64().unwrap_or_else(|| panic!("{key}"));
    for key in ["cl", "cd", "centre_of_pressure", "lift_to_drag"] {
        assert!(number(key) > 0.0, "{point}");
    }
    for key in ["cd_band", "cl_band", "cm_band", "centre_of_pressure_band"] {
        assert!(number(key).is_finite() && number(key) > 0.0, "{point}");
    }
    assert!((number("lift_to_drag") * number("cd") / number("cl") - 1.0).abs() < 1e-9);
    let levels = found["levels"].as_array().expect("runs");
    assert!(
        levels.len() > 2 && levels.iter().all(|level| level["settled"] == true),
        "{found}"
    );
    let second = std::fs::read_to_string(place.path("out/cone-fly/spacing-2/run.toml"));
    let second = second.expect("a scene");
    let start = second
        .lines()
        .find(|line| line.starts_with("initial.frame"));
    assert!(
        start.is_some_and(|line| line.contains("spacing-1/frame-")),
        "{second}"
    );
}

#[test]
fn a_spacing_far_below_the_body_is_halved_down_to_and_its_time_is_one_that_can_be() {
    let place = Workplace::new();
    place.write("cone.stl", cone(36));
    let told = |incidence: &str, spacing: &str| {
        let asked = ["fly", "cone.stl", "--mach", "3", "--incidence", incidence];
        let more = ["--spacing", spacing, "--scene", "it.toml", "--overwrite"];
        let answer = place.aero(&[&asked[..], &more].concat());
        answer.succeeds();
        let scene = std::fs::read_to_string(place.path("it.toml")).expect("a scene");
        let scene: toml::Table = scene.parse().expect("TOML");
        let number = |value: &toml::Value| {
            let whole = value.as_integer().map(|n| n as f64);
            whole.or(value.as_float()).expect("a number")
        };
        let halvings = number(&scene["scheme"]["refine"]["flow"]);
        assert!(number(&scene["scheme"]["refine"]["bodies"]) >= halvings);
        let finest = number(&scene["spacing"]) / 2_f64.powf(halvings);
        let asked: f64 = spacing.parse().expect("a number");
        assert!((finest / asked - 1.0).abs() < 1e-9, "{finest}");
        (halvings, answer.out)
    };
    assert_eq!(told("2", "0.05").0, 1.0);
    // In a plane through its axis, where two are usual.
    let (halvings, out) = told("0", "0.00002");
    assert!(halvings >= 4.0, "{halvings}");
    // Hours, not months, and how to ask for less.
    let time = out.split("will take about ").nth(1).expect("a time");
    let minutes: f64 = time
        .split(' ')
        .next()
        .and_then(|n| n.parse().ok())
        .expect(time);
    assert!(minutes < 3000.0 && out.contains("--minutes N"), "{out}");
}

/// A body slower than sound is felt far away on all sides; where its gas comes to rest cells are finer than elsewhere. A spheroid has no drag.
#[test]
fn a_slow_stream_has_far_sides_and_fine_noses() {
    let place = Workplace::new();
    let line: Vec<[f64; 2]> = (0..=48)
        .map(|k| {
            let (sine, cosine) = (TAU * f64::from(k) / 96.0).sin_cos();
            [1.0 - cosine, if k % 48 == 0 { 0.0 } else { 0.5 * sine }]
        })
        .collect();
    place.write("spheroid.stl", turned(&line, 96));
    let flight = ["fly", "spheroid.stl", "--mach", "0.4", "--spacing", "0.04"];
    place.aero(&flight).succeeds();
    let scene = std::fs::read_to_string(place.path("out/spheroid-fly/scene.toml"));
    let scene: toml::Table = scene.expect("a scene").parse().expect("TOML");
    let domain = &scene["domain"];
    for side in ["x_min", "x_max", "y_max"] {
        assert_eq!(domain["sides"][side].as_str(), Some("free-stream"));
    }
    let ends = ["min", "max"].map(|end| domain[end][0].as_float().expect("a number"));
    assert!(ends[0] < -8.0 && ends[1] > 10.0, "{ends:?}");
    let refine = |key: &str| {
        scene["scheme"]["refine"][key]
            .as_integer()
            .expect("halvings")
    };
    assert!(refine("flow") >= 4 && refine("bends") > refine("bodies"));
    let found = place.json("out/spheroid-fly/fly.json");
    let point = &found["points"][0];
    let number = |key: &str| point[key].as_f64().unwrap_or_else(|| panic!("{key}"));
    assert!(number("cd").abs() < 0.05, "{point}");
    // What a base may add is bounded by what is measured, not by a vacuum, which is at 9 here.
    assert!(number("cd_base_band") < 0.6, "{point}");
}

#[test]
fn what_cannot_be_flown_is_refused_with_the_mend() {
    let place = Workplace::new();
    place.write("cone.stl", cone(12));
    let fly = |more: &[&str]| place.aero(&[&["fly", "cone.stl"], more].concat());
    fly(&["--mach", "0.8", "--motion", "with-the-gas"]).refuses(&["leave out `--motion"]);
    for (more, word) in [
        (
            ["--mach", "2", "--axis", "w"],
            "not a direction of the file",
        ),
        (["--mach", "2", "--pressure", "1e5"], "--temperature"),
        (["--mach", "2", "--altitude", "high"], "12km"),
    ] {
        let answer = fly(&more);
        assert_eq!(answer.status, 2, "{}", answer.err);
        assert!(answer.err.contains(word), "{}", answer.err);
    }
    place
        .aero(&["fly", "nothing.stl", "--mach", "2"])
        .refuses(&["nothing.stl"]);
    place.write("it.toml", "mine");
    for (path, word) in [
        (".", "is a folder"),
        ("it.toml", "--overwrite"),
        ("none/it.toml", "its folder"),
    ] {
        fly(&["--mach", "2", "--scene", path]).refuses(&[path, word]);
    }
    assert_eq!(
        std::fs::read_to_string(place.path("it.toml")).unwrap(),
        "mine"
    );
    for command in ["run", "check", "converge"] {
        place
            .aero(&[command, "cone.stl"])
            .refuses(&["aero fly cone.stl", "aero pack cone.stl"]);
    }
}

/// A cup flies with its hollow ahead: its shock goes farther aside than that of any front that boxes are laid out for.
#[test]
fn a_side_that_is_too_near_is_moved_and_the_runs_begin_anew() {
    let place = Workplace::new();
    let cup = [
        [0.4, 0.0],
        [0.35, 0.5],
        [0.0, 1.0],
        [0.5, 1.05],
        [1.0, 0.9],
        [1.0, 0.0],
    ];
    place.write("cup.stl", turned(&cup, 96));
    let flight = ["fly", "cup.stl", "--mach", "1.5", "--spacing", "0.1"];
    let answer = place.aero(&[&flight[..], &["--axis=-z,+y"]].concat());
    answer.succeeds();
    let told = format!("{}{}", answer.out, answer.err);
    assert!(told.contains("side `y_max` is too near"), "{told}");
    assert!(!told.contains("throws waves back"), "{told}");
    let found = place.json("out/cup-fly/fly.json");
    let levels = found["levels"].as_array().expect("runs");
    assert_eq!(levels.len(), 4, "{levels:?}");
    // The box that is told is the one that was computed.
    let scene = std::fs::read_to_string(place.path("out/cup-fly/scene.toml")).expect("a scene");
    let corner = scene.lines().find(|line| line.starts_with("max"));
    let high = corner
        .and_then(|line| line.split(", ").nth(1))
        .expect("two");
    let high: f64 = high.trim_end_matches(']').parse().expect("a number");
    let before: f64 = answer.out.split(" x ").nth(1).expect("a box")[..5]
        .parse()
        .expect("a number");
    assert!(high > 1.2 * before, "{before}: {scene}");
}
