//! Bodies that the gas moves, through the command line.

use crate::support::Workplace;

/// A disc in the stream behind a shock that a piston drives into gas at rest.
const DISC: &str = r#"
dimension = 2
spacing = 0.1
end_time = 2.0

[free_stream]
mach = 0.0
density = 1.0
pressure = 0.7142857142857143

[domain]
min = [-3.0, -1.5]
max = [3.0, 1.5]

[domain.sides]
x_min = { wall = { velocity = 0.6944444444444444 } }
x_max = "wall"
y_min = "wall"
y_max = "wall"

[initial.riemann]
left = { density = 1.8620689655172413, pressure = 1.755952380952381, velocity = [0.6944444444444444, 0.0] }
right = { density = 1.0, pressure = 0.7142857142857143 }
position = -1.2

[[body]]
name = "disc"
shape = { circle = { radius = 0.5 } }
place = { translate = [0.0, 0.13] }

[body.motion]
acceleration = [0.0, -0.05]
free = { mass = 2.0, inertia = 0.25 }

[output]
frames = 2
"#;

/// A column of the history.
fn column(history: &str, name: &str) -> Vec<f64> {
    let mut rows = history.lines();
    let mut header = rows.next().expect("a header").split(',');
    let place = header.position(|column| column == name).expect(name);
    let cell = |row: &str| row.split(',').nth(place).expect("a cell").parse::<f64>();
    rows.map(|row| cell(row).expect("a number")).collect()
}

#[test]
fn a_swing_of_less_than_a_spacing_is_told() {
    let place = Workplace::new();
    // Heavy, and at rest but for what the gas does.
    let told = |mass: &str, end: &str| {
        let settings = ["--set", mass, "--set", end];
        place.run(DISC, &settings).succeeds();
        let summary = place.json("results/summary.json");
        let warnings = summary["warnings"].as_array().expect("a list").clone();
        let texts = warnings.iter().filter_map(|text| text.as_str());
        texts
            .filter(|text| text.contains("rows of gas do not follow"))
            .count()
    };
    assert_eq!(told("body.disc.motion.free.mass=20", "end_time=1"), 1);
    assert_eq!(told("body.disc.motion.free.mass=0.2", "end_time=2"), 0);
}

/// Speed along an axis that the force of a body of this `mass` and another `acceleration` have given it by the end, as it was at each step.
#[track_caller]
fn own_speed(history: &str, [name, axis]: [&str; 2], mass: f64, acceleration: f64) -> f64 {
    let of = |kind: &str| column(history, &format!("{name}.{kind}{axis}"));
    let steps = of("f").into_iter().zip(column(history, "dt"));
    let mut sum = 0.0;
    for ((force, dt), speed) in steps.zip(of("v")) {
        sum += (force / mass + acceleration) * dt;
        assert!(
            (sum - speed).abs() < 1e-12,
            "{name}, {axis}: {speed}, by its force {sum}"
        );
    }
    sum
}

#[test]
fn two_bodies_move_each_by_its_own_force() {
    let (scene, end) = DISC.split_once("[output]").expect("an output");
    let ball = "[[body]]\nname = \"ball\"\nshape = { circle = { radius = 0.3 } }\nplace = { translate = [-0.9, -0.8] }\n\
                motion = { free = { mass = 0.5, inertia = 0.05 } }\n";
    let place = Workplace::new();
    let scene = format!("{scene}{ball}[output]{end}");
    place.run(&scene, &["--set", "end_time=1.2"]).succeeds();
    let history = std::fs::read_to_string(place.path("results/history.csv")).expect("a history");
    for (name, mass, acceleration) in [("disc", 2.0, [0.0, -0.05]), ("ball", 0.5, [0.0; 2])] {
        let of = |axis, acceleration| own_speed(&history, [name, axis], mass, acceleration);
        let (along, across) = (of("x", acceleration[0]), of("y", acceleration[1]));
        assert!(along > 0.01 && across != 0.0, "{name}: {along} {across}");
    }
}

#[test]
fn a_body_in_space_moves_by_its_own_force() {
    let sphere = DISC
        .replace("dimension = 2", "dimension = 3")
        .replace("spacing = 0.1", "spacing = 0.2")
        .replace("end_time = 2.0", "end_time = 0.32")
        .replace("[-3.0, -1.5]", "[-1.6, -1.0, -1.0]")
        .replace("[3.0, 1.5]", "[1.2, 1.0, 1.0]")
        .replace(
            "y_max = \"wall\"",
            "y_max = \"wall\"\nz_min = \"wall\"\nz_max = \"wall\"",
        )
        .replace(
            "[0.6944444444444444, 0.0]",
            "[0.6944444444444444, 0.0, 0.0]",
        )
        .replace("velocity = [0.0, 0.0]", "velocity = [0.0, 0.0, 0.0]")
        .replace("position = -1.2", "position = -0.8")
        .replace("circle = { radius = 0.5 }", "sphere = { radius = 0.4 }")
        .replace("[0.0, 0.13]", "[0.0, 0.0, 0.1]")
        .replace("[0.0, -0.05]", "[0.0, 0.0, -0.5]")
        .replace("inertia = 0.25", "inertia = [0.1, 0.1, 0.1]");
    let place = Workplace::new();
    place.run(&sphere, &[]).succeeds();
    let history = std::fs::read_to_string(place.path("results/history.csv")).expect("a history");
    let speeds = [("x", 0.0), ("y", 0.0), ("z", -0.5)]
        .map(|(axis, acceleration)| own_speed(&history, ["disc", axis], 2.0, acceleration));
    assert!(speeds[0] > 0.01 && speeds[2] < -0.1, "{speeds:?}");
    let motion = &place.json("results/summary.json")["bodies"]["disc"]["motion"];
    for k in 0..3 {
        assert_eq!(
            motion["velocity"][k].as_f64(),
            column(&history, ["disc.vx", "disc.vy", "disc.vz"][k])
                .last()
                .copied()
        );
    }
}

#[test]
fn a_disc_that_a_shock_blows_away_moves_by_its_own_force() {
    let place = Workplace::new();
    let answer = place.run(DISC, &[]);
    answer.succeeds();
    let text = std::fs::read_to_string(place.path("results/history.csv")).expect("a history");
    let of = |name: &str| column(&text, name);
    for (axis, other) in [("x", 0.0), ("y", -0.05)] {
        let speed = own_speed(&text, ["disc", axis], 2.0, other);
        assert!(speed.abs() > 0.02, "{axis}: nothing moves");
    }
    // Nowhere does it move faster than the stream that blows it away.
    let fastest = of("disc.vx").into_iter().fold(0.0, f64::max);
    assert!(fastest > 0.2 && fastest < 0.6944, "{fastest}");
    let summary = place.json("results/summary.json");
    let motion = &summary["bodies"]["disc"]["motion"];
    let end = |key: &str, k: usize| motion[key][k].as_f64().expect("a number");
    assert_eq!(end("velocity", 0), *of("disc.vx").last().expect("a row"));
    assert!(end("position", 0) > 0.1 && end("position", 0) < 2.0);
    assert!(end("turn", 2).abs() > 0.0);
    assert!(answer.out.contains("moving at"), "{}", answer.out);
    let drift = summary["conservation"]["momentum"].as_f64();
    assert!(drift.expect("a number") < 1e-12);
}

/// The gas that its impulsive start drives into it is sent back by both of its halves.
#[test]
fn a_disc_that_a_plane_of_symmetry_halves_is_not_turned_by_what_it_sends_back() {
    let place = Workplace::new();
    let scene = "\
dimension = 2
spacing = 0.1
end_time = 0.3
[free_stream]
mach = 2.0
density = 1.0
pressure = 0.7142857142857143
[domain]
min = [-1.0, 1.0]
max = [2.0, 2.5]
[domain.sides]
x_min = \"inlet\"
x_max = \"outlet\"
y_min = \"symmetry\"
y_max = \"free-stream\"
[[body]]
name = \"disc\"
shape = { circle = { radius = 0.5 } }
place = { translate = [0.0, 1.0] }
motion = { free = { mass = 3.0, inertia = 1.0 } }
";
    place.run(scene, &[]).succeeds();
    let summary = place.json("results/summary.json");
    assert!(summary["returned"].as_u64() > Some(0), "{summary}");
    let motion = &summary["bodies"]["disc"]["motion"];
    let of = |key: &str, axis: usize| motion[key][axis].as_f64().unwrap();
    assert!(of("velocity", 0) > 0.01, "{motion}");
    assert!(of("angular_velocity", 2).abs() < 1e-12, "{motion}");
}

#[test]
fn check_says_how_a_body_is_free() {
    let place = Workplace::new();
    place.write("scene.toml", DISC);
    let answer = place.aero(&["check", "scene.toml"]);
    answer.succeeds();
    let wanted = "moved by the gas: 2 kg to a metre of depth, along x, y, about z";
    assert!(answer.out.contains(wanted), "{}", answer.out);
}

#[test]
fn what_no_free_body_can_be_is_refused_with_the_mend() {
    let free = "free = { mass = 2.0, inertia = 0.25 }";
    let refused = |from: &str, to: &str, words: &[&str]| {
        assert!(DISC.contains(from), "{from}");
        Workplace::new()
            .run(&DISC.replace(from, to), &[])
            .refuses(words);
    };
    refused(
        "inertia = 0.25",
        "constraints = [\"x\"]",
        &["body.disc.motion.free.inertia", "constraints"],
    );
    refused(
        "inertia = 0.25",
        "inertia = -1.0",
        &["body.disc.motion.free.inertia", "above zero"],
    );
    refused(
        "inertia = 0.25",
        "inertia = [1.0, 1.0, 1.0]",
        &["free.inertia", "a number in 2D"],
    );
    refused("mass = 2.0", "mass = 0.0", &["mass", "positive"]);
    refused(
        free,
        &format!("{free}\npivot = [0.0, 0.0]"),
        &["body.disc.motion.pivot", "free.centre"],
    );
    refused(
        free,
        "free = { mass = 2.0, constraints = [\"x\", \"y\", \"turn\"] }",
        &["body.disc.motion.free.constraints", "leave out `free`"],
    );
    refused(
        free,
        &format!("{free}\nangular_velocity = {{ cosine = {{ amplitude = 1.0, period = 1.0 }} }}"),
        &["body.disc.motion.angular_velocity", "prescribed"],
    );
    refused(
        "[0.0, 0.13]",
        "[0.0, 0.93]",
        &["body `disc` touches the side y_max", "more room"],
    );
    let fixed = DISC
        .replace("[gas]", "")
        .replace("spacing = 0.1", "spacing = 0.1\nscheme.motion = \"fixed\"");
    let fixed = fixed.replace(
        "x_min = { wall = { velocity = 0.6944444444444444 } }",
        "x_min = \"wall\"",
    );
    Workplace::new()
        .run(&fixed, &[])
        .refuses(&["disc", "moves"]);
}

/// It falls onto the floor: the run stops there, keeps what it has, and says where.
#[test]
fn a_body_that_falls_onto_a_wall_stops_the_run() {
    let scene = DISC.replace("[0.0, -0.05]", "[0.0, -3.0]");
    let place = Workplace::new();
    let answer = place.run(&scene, &[]);
    assert_eq!(answer.status, 1, "{}", answer.err);
    for word in [
        "body `disc` touches the side y_min",
        "contact is not modelled",
        "step",
    ] {
        assert!(answer.err.contains(word), "{word}: {}", answer.err);
    }
    assert!(place.path("results/run.pvd").exists());
}

#[test]
fn numbers_of_summaries_are_read_to_the_last_bit() {
    for text in [
        "1.961737502059051e-18",
        "5.0e-324",
        "1.7976931348623157e308",
    ] {
        let read: f64 = serde_json::from_str(text).expect("a number");
        assert_eq!(
            read.to_bits(),
            text.parse::<f64>().expect("a number").to_bits()
        );
    }
}
