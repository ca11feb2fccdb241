//! Probes of a run: points and sections beside the history, lines beside frames.

use std::collections::BTreeMap;

use crate::support::{Workplace, box_with};

/// A stream through a tube at Mach 2, and what is read of it.
const STREAM: &str = r#"
dimension = 2
spacing = 0.05
end_time = 0.02

[free_stream]
mach = 2.0
density = 1.0
pressure = 1.0

[domain]
min = [0.0, 0.0]
max = [1.0, 0.5]

[domain.sides]
x_min = "inlet"
x_max = "outlet"
y_min = "symmetry"
y_max = "wall"

[output]
frames = 1

[[probe]]
name = "nose"
at = { point = [0.51, 0.0] }

[[probe]]
name = "along"
at = { line = { from = [0.1, 0.1], to = [0.9, 0.4], points = 11 } }

[[probe]]
name = "exit"
at = { section = { min = [0.7, 0.1], max = [0.7, 0.4] } }
"#;

/// Columns of a table by name.
fn columns(place: &Workplace, name: &str) -> BTreeMap<String, Vec<f64>> {
    let text = std::fs::read_to_string(place.path("results").join(name)).expect("a table");
    let mut lines = text.lines();
    let names: Vec<&str> = lines.next().expect("a header").split(',').collect();
    let mut columns = BTreeMap::<String, Vec<f64>>::new();
    for line in lines {
        let fields: Vec<&str> = line.split(',').collect();
        assert_eq!(fields.len(), names.len(), "{line}");
        for (name, field) in names.iter().zip(fields) {
            let number = field.parse().unwrap_or(f64::NAN);
            columns.entry((*name).to_owned()).or_default().push(number);
        }
    }
    columns
}

#[track_caller]
fn all_are(columns: &BTreeMap<String, Vec<f64>>, name: &str, wanted: f64) {
    let values = columns.get(name).unwrap_or_else(|| panic!("no `{name}`"));
    for value in values {
        let scale = wanted.abs().max(1.0);
        assert!(
            (value - wanted).abs() < 1e-5 * scale,
            "{name}: {value} for {wanted}"
        );
    }
}

#[test]
fn an_undisturbed_stream_is_read_as_what_it_is() {
    let speed = 2.0 * 1.4_f64.sqrt();
    for motion in ["with-the-gas", "fixed"] {
        let place = Workplace::new();
        let motion = format!("scheme.motion=\"{motion}\"");
        place.run(STREAM, &["--set", &motion]).succeeds();
        let read = columns(&place, "probes.csv");
        let history = columns(&place, "history.csv");
        assert_eq!(read["step"], history["step"]);
        all_are(&read, "nose.density", 1.0);
        all_are(&read, "nose.velocity_x", speed);
        all_are(&read, "nose.velocity_y", 0.0);
        all_are(&read, "nose.mach", 2.0);
        all_are(&read, "exit.area", 0.3);
        all_are(&read, "exit.mass_flux", 0.3 * speed);
        all_are(&read, "exit.momentum_flux_x", 0.3 * (speed * speed + 1.0));
        all_are(&read, "exit.momentum_flux_y", 0.0);
        let enthalpy = 3.5 + 0.5 * speed * speed;
        all_are(&read, "exit.enthalpy_flux", 0.3 * speed * enthalpy);
        all_are(&read, "exit.mean_pressure", 1.0);
        all_are(&read, "exit.mean_mach", 2.0);
        let line = columns(&place, "line-along-000001.csv");
        assert_eq!(line["distance"].len(), 11);
        assert!((line["distance"][10] - 0.8_f64.hypot(0.3)).abs() < 1e-12);
        all_are(&line, "pressure", 1.0);
    }
}

#[test]
fn a_section_about_an_axis_is_a_ring() {
    let scene = STREAM.replace("\"symmetry\"", "\"axis\"");
    let place = Workplace::new();
    place
        .run(&scene, &["--set", "scheme.motion=fixed"])
        .succeeds();
    let read = columns(&place, "probes.csv");
    let area = std::f64::consts::PI * (0.4_f64.powi(2) - 0.1_f64.powi(2));
    all_are(&read, "exit.area", area);
    all_are(&read, "exit.mass_flux", area * 2.0 * 1.4_f64.sqrt());
}

#[test]
fn probes_where_there_is_no_gas_are_refused_with_the_mend() {
    let place = Workplace::new();
    let body = "[[body]]\nname = \"post\"\nshape = { circle = { radius = 0.1 } }\nplace = { translate = [0.5, 0.25] }\n";
    let with = |probe: &str| {
        let start = STREAM.find("[[probe]]").expect("probes");
        format!("{}{body}[[probe]]\n{probe}\n", &STREAM[..start])
    };
    for (probe, words) in [
        (
            "name = \"in\"\nat = { point = [0.45, 0.25] }",
            ["probe.in", "body `post`", "at (0.4000, 0.2500)"],
        ),
        (
            "name = \"out\"\nat = { point = [1.5, 0.25] }",
            ["probe.out.at.point", "beyond the domain", "between 0 and 1"],
        ),
        (
            "name = \"flat\"\nat = { section = { min = [0.1, 0.1], max = [0.3, 0.3] } }",
            ["probe.flat", "no section", "the same along one axis"],
        ),
        (
            "name = \"short\"\nat = { line = { from = [0.1, 0.1], to = [0.1, 0.1] } }",
            ["probe.short", "without length", "two ends"],
        ),
        (
            "name = \"a\"\nat = { point = [0.1, 0.1] }\n[[probe]]\nname = \"a\"\nat = { point = [0.2, 0.1] }",
            ["probe.a", "this name already", "rename"],
        ),
    ] {
        place.run(&with(probe), &[]).refuses(&words);
    }
    let moved = "probe.in.at.point=[0.3, 0.25]";
    let inside = with("name = \"in\"\nat = { point = [0.45, 0.25] }");
    place
        .run(&inside, &["--set", moved, "--set", "end_time=1e-4"])
        .succeeds();
}

#[test]
fn a_run_that_goes_on_goes_on_with_its_tables() {
    let place = Workplace::new();
    place.run(STREAM, &[]).succeeds();
    let whole = columns(&place, "probes.csv");
    place.run(STREAM, &["--set", "end_time=0.01"]).succeeds();
    let resume = ["run", "scene.toml", "--out", "results", "--resume"];
    place.aero(&resume).succeeds();
    let prolonged = columns(&place, "probes.csv");
    assert!(prolonged["time"].len() >= whole["time"].len());
    assert!(prolonged["step"].windows(2).all(|pair| pair[1] > pair[0]));
    let none = box_with("frames = 2", "frames = 1");
    place.run(&none, &[]).succeeds();
    assert!(!place.path("other/probes.csv").exists());
}
