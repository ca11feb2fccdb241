//! Viscous flows of points that stay and of particles, through the command line.

use crate::support::Workplace;

/// A cylinder whose surface turns in a slow stream: friction, heat and lift.
const CYLINDER: &str = r#"
dimension = 2
spacing = 0.2
end_time = 1.0

[gas]
gas_constant = 1.0
viscosity = { reynolds = 20.0 }

[scheme]
motion = "fixed"

[free_stream]
mach = 0.3
density = 1.0
pressure = 1.0

[domain]
min = [-2.0, -2.0]
max = [3.0, 2.0]

[domain.sides]
x_min = "inlet"
x_max = { outlet = { pressure = 1.0 } }
y_min = "free-stream"
y_max = "free-stream"

[[body]]
name = "cylinder"
shape = { circle = { radius = 0.5 } }
wall = { kind = "no-slip", temperature = 1.2, angular_velocity = 0.5 }

[output]
frames = 1
"#;

/// The same by particles.
fn by_particles() -> String {
    CYLINDER.replace("[scheme]\nmotion = \"fixed\"\n", "")
}

#[test]
fn friction_and_heat_stand_in_the_summary_and_on_the_surface() {
    for (scene, columns) in [
        (CYLINDER.to_owned(), vec!["friction", "heat_flux"]),
        (by_particles(), vec!["friction"]),
    ] {
        let place = Workplace::new();
        place.run(&scene, &[]).succeeds();
        let body = &place.json("results/summary.json")["bodies"]["cylinder"];
        let number = |key: &str, k: usize| body[key][k].as_f64().expect("a number");
        // The stream drags, and what turns counter-clockwise drags it up before and down behind.
        assert!(number("friction", 0) > 0.0 && number("friction", 0) < number("force_gauge", 0));
        assert!(body["heat"].as_f64().expect("a number") > 0.0, "{body}");
        assert!(number("moment", 2) < 0.0, "{body}");
        let surface = std::fs::read(place.path("results/surface-000001.vtp")).expect("a surface");
        let text = String::from_utf8_lossy(&surface);
        for column in columns {
            assert!(text.contains(column), "{column}");
        }
    }
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    for scene in [CYLINDER.to_owned(), by_particles()] {
        let frame = |threads: &str| {
            let place = Workplace::new();
            place.run(&scene, &["--threads", threads]).succeeds();
            std::fs::read(place.path("results/frame-000001.vtp")).expect("the last frame")
        };
        assert!(frame("1") == frame("2"));
    }
}

#[test]
fn a_surface_that_would_move_across_itself_is_refused() {
    // Fine enough for its layer, of which nothing is told then.
    let wall = CYLINDER
        .replace("angular_velocity = 0.5", "velocity = [0.1, 0.0]")
        .replace("spacing = 0.2", "spacing = 0.1");
    Workplace::new().run(&wall, &[]).refuses(&[
        "`cylinder`",
        "across itself",
        "a velocity along it",
    ]);
}

#[test]
fn gas_without_viscosity_has_neither_friction_nor_heat() {
    let place = Workplace::new();
    let inviscid = CYLINDER
        .replace("viscosity = { reynolds = 20.0 }", "")
        .replace("wall = { kind", "# wall = { kind");
    place.run(&inviscid, &[]).succeeds();
    let body = &place.json("results/summary.json")["bodies"]["cylinder"];
    assert!(body["friction"].is_null() && body["heat"].is_null());
}
