//! What a run tells of itself while it goes and at its end.

use crate::support::Workplace;

/// Gas of 288 K about a plate less than a spacing thick.
const PLATE: &str = r#"
dimension = 2
spacing = 0.05
end_time = 0.2

[gas]
gas_constant = 287.0

[free_stream]
mach = 2.0
pressure = 101325.0
temperature = 288.0
incidence = 3.0

[domain]
min = [-0.4, -0.5]
max = [1.4, 0.5]

[domain.sides]
x_min = "inlet"
x_max = "outlet"
y_min = "free-stream"
y_max = "free-stream"

[[body]]
name = "plate"
shape = { polygon = [[[0.0, 0.0], [0.5, -0.02], [1.0, 0.0], [0.5, 0.02]]] }
reference_area = 1.0
reference_length = 1.0
"#;

/// Dynamic pressure: `0.7 p M^2`.
#[test]
fn a_run_says_in_words_what_it_is_about_to_do() {
    let place = Workplace::new();
    place.write("plate.toml", PLATE);
    let halt = ["run", "plate.toml", "--set", "end_time=1e-5"];
    let ran = place.aero(&halt);
    ran.succeeds();
    for words in [
        "plate: 2 dimensions, spacing 0.05",
        "particles that move with the gas, to t = 1.0000e-5",
        "Mach 2.0000, pressure 1.01325e5",
        "temperature 288.00 K, dynamic pressure 2.83710e5",
        "side x_min at -0.4: the free stream comes in",
        "body `plate`: 20.0 x 0.8 spacings",
        "its thinnest part",
    ] {
        assert!(ran.err.contains(words), "`{words}` in {}", ran.err);
    }
    assert!(!ran.err.contains("Reynolds"), "{}", ran.err);
    let viscous = ["run", "plate.toml", "--set", "end_time=1e-5", "--overwrite"];
    let viscous = [
        &viscous[..],
        &["--set", "gas.viscosity={ reynolds = 2000.0 }"],
    ]
    .concat();
    let ran = place.aero(&viscous);
    assert!(
        ran.err.contains("Reynolds number: 2.00000e3"),
        "{}",
        ran.err
    );
}

#[test]
fn a_run_says_at_its_end_whether_its_forces_have_settled() {
    let place = Workplace::new();
    place.write("plate.toml", PLATE);
    let told = |settings: &[&str]| {
        let run = ["run", "plate.toml", "--overwrite"];
        let ran = place.aero(&[&run[..], settings].concat());
        ran.succeeds();
        let summary = place.json("out/plate/summary.json");
        (ran.out, summary)
    };
    let (early, summary) = told(&["--set", "end_time=4e-4"]);
    let swing = summary["bodies"]["plate"]["settled_percent"].as_f64();
    let swing = swing.expect("a number");
    let words = format!("not settled: +- {swing:.1} %");
    assert!(swing > 1.0 && early.contains(&words), "{swing}: {early}");
    let settles = ["--set", "stop=\"steady\"", "--set", "scheme.motion=fixed"];
    let about_the_tail = ["--set", "body.plate.moment_centre=[1.0, 0.0]"];
    let (settled, summary) = told(&[&settles[..], &about_the_tail].concat());
    assert!(settled.contains("settled after"), "{settled}");
    assert!(!settled.contains("not settled"), "{settled}");
    check_coefficients(&place, &summary["bodies"]["plate"]);
}

/// The history ends with the coefficients of the summary, those of both axes are one force, and lift before the point of the moments is
/// nose up. Thin plates have their lift in their middle [Liepmann & Roshko 1957, section 4.17].
fn check_coefficients(place: &Workplace, plate: &serde_json::Value) {
    let names = ["cd", "cl", "cm", "ca", "cn"];
    let [cd, cl, cm, ca, cn] = names.map(|name| plate[name].as_f64().expect(name));
    let text = std::fs::read_to_string(place.path("out/plate/history.csv")).expect("a history");
    let mut columns = text.lines().next().expect("a header").split(',');
    let first = columns.position(|name| name == "plate.cd").expect("cd");
    let names: Vec<&str> = columns.take(2).collect();
    assert_eq!(names, ["plate.cl", "plate.cm"]);
    let last = text.lines().last().expect("a row").split(',').skip(first);
    let last: Vec<f64> = last
        .take(3)
        .map(|cell| cell.parse().expect("a number"))
        .collect();
    for (last, told) in last.iter().zip([cd, cl, cm]) {
        assert!((last - told).abs() < 1e-12, "{last} {told}");
    }
    let (sin, cos) = 3_f64.to_radians().sin_cos();
    assert!((ca * cos + cn * sin - cd).abs() < 1e-12 && (cn * cos - ca * sin - cl).abs() < 1e-12);
    assert!(cl > 0.05 && (cm / cl - 0.5).abs() < 0.1, "{cl} {cm}");
}

/// What a person sees who watches from a terminal.
#[test]
#[cfg(target_os = "linux")]
fn the_bar_shows_drag_and_lift() {
    let place = Workplace::new();
    place.write("plate.toml", PLATE);
    let program = assert_cmd::cargo::cargo_bin("aero");
    let run = format!(
        "stty cols 200; '{}' run plate.toml --set end_time=2e-4",
        program.display()
    );
    let terminal = std::process::Command::new("script")
        .current_dir(place.path(""))
        .args(["-qefc", &run, "/dev/null"])
        .stdin(std::process::Stdio::null())
        .output();
    let Ok(seen) = terminal else {
        return;
    };
    let seen = String::from_utf8_lossy(&seen.stdout);
    assert!(
        seen.contains('%') && seen.contains(", cd ") && seen.contains(", cl "),
        "{seen}"
    );
}

/// The fan has no dissipation among particles; points that stay know it.
#[test]
fn particles_behind_a_convex_corner_are_told_of() {
    let scene = r#"
dimension = 2
spacing = 0.1
end_time = 0.5
[free_stream]
mach = 2.0
density = 1.4
pressure = 1.0
[domain]
min = [-1.0, -1.0]
max = [2.0, 1.0]
[domain.sides]
x_min = "inlet"
x_max = "outlet"
y_min = "body"
y_max = "free-stream"
[[body]]
name = "corner"
shape = { expansion_corner = { angle = 15.0, corner = [0.0, 0.0] } }
"#;
    for (angle, motion, is_told) in [
        ("15.0", "with-the-gas", true),
        ("5.0", "with-the-gas", false),
        ("15.0", "fixed", false),
    ] {
        let place = Workplace::new();
        let angle = format!("body.corner.shape.expansion_corner.angle={angle}");
        let motion = format!("scheme.motion={motion}");
        let ran = place.run(scene, &["--set", &angle, "--set", &motion]);
        ran.succeeds();
        let words = "behind the sharp convex bend at (0.0000, 0.0000)";
        let told = format!("{}{}", ran.out, ran.err);
        assert_eq!(told.contains(words), is_told, "{angle} {motion}: {told}");
    }
}

/// A block whose top turns down by 15 degrees at x = 0, from side to side.
const ROOF: &str = "v -3 -3 -1\nv 4 -3 -1\nv 4 -1.0718 -1\nv 0 0 -1\nv -3 0 -1\n\
    v -3 -3 2\nv 4 -3 2\nv 4 -1.0718 2\nv 0 0 2\nv -3 0 2\n\
    f 5 4 3 2 1\nf 6 7 8 9 10\nf 1 2 7 6\nf 2 3 8 7\nf 3 4 9 8\nf 4 5 10 9\nf 5 1 6 10\n";

#[test]
fn particles_behind_a_convex_edge_in_space_are_told_of() {
    let place = Workplace::new();
    place.write("roof.obj", ROOF);
    let scene = r#"
dimension = 3
spacing = 0.1
end_time = 0.1
[free_stream]
mach = 2.0
density = 1.4
pressure = 1.0
[domain]
min = [-0.6, -0.6, 0.0]
max = [0.8, 0.6, 0.4]
[domain.sides]
x_min = "inlet"
x_max = "outlet"
y_min = "body"
y_max = "free-stream"
z_min = "symmetry"
z_max = "symmetry"
[[body]]
name = "roof"
shape = { stl = { file = "roof.obj", unit = "m" } }
"#;
    for (mach, is_told) in [("2.0", true), ("0.8", false)] {
        let ran = place.run(scene, &["--set", &format!("free_stream.mach={mach}")]);
        ran.succeeds();
        let told = format!("{}{}", ran.out, ran.err);
        let words = "behind sharp convex edges, as that at (0.0000, 0.0000, 0.3778)";
        assert_eq!(told.contains(words), is_told, "{mach}: {told}");
    }
}
