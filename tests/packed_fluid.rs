//! Gas begins in the room that bodies leave it; fluid that conforms to one takes the place of the lattice where the scene asks.

use crate::support::{Workplace, read_surface};

/// A gas at rest around a post.
const REST: &str = r#"
dimension = 2
spacing = 0.05
end_time = 0.2

[free_stream]
density = 1.0
pressure = 1.0
velocity = [0.0, 0.0]

[domain]
min = [-1.0, -1.0]
max = [1.0, 1.0]

[domain.sides]
x_min = "periodic"
x_max = "periodic"
y_min = "periodic"
y_max = "periodic"

[[body]]
name = "post"
shape = { circle = { radius = 0.23 } }
packed_fluid = true

[output]
frames = 1
"#;

#[test]
fn a_gas_at_rest_around_a_packed_body_stays_closer_to_rest() {
    let least_density = |scene: &str| {
        let place = Workplace::new();
        place.run(scene, &[]).succeeds();
        let summary = place.json("results/summary.json");
        assert_eq!(summary["leaked"], 0);
        summary["min_density"].as_f64().unwrap()
    };
    let packed = least_density(REST);
    let lattice = least_density(&REST.replace("packed_fluid = true", ""));
    println!("{packed} {lattice}");
    assert!(packed > 0.99, "{packed}");
    assert!(lattice > 0.94 && lattice < packed, "{lattice} {packed}");
}

/// However the lattice meets walls.
#[test]
fn gas_at_rest_presses_walls_off_the_lattice_with_its_pressure_from_the_start() {
    for sides in ["periodic", "free-stream"] {
        for (width, turned) in [(0.61, 0), (0.63, 0), (0.62, 10), (0.63, 30), (0.61, 45)] {
            let shape = format!(
                "shape = {{ rectangle = {{ width = {width}, height = {width} }} }}\n\
                 place = {{ rotate = {turned}.0, translate = [0.013, 0.021] }}"
            );
            let scene = REST
                .replace("shape = { circle = { radius = 0.23 } }", &shape)
                .replace("packed_fluid = true", "")
                .replace("periodic", sides)
                .replace("end_time = 0.2", "end_time = 1e-3");
            let place = Workplace::new();
            place.run(&scene, &[]).succeeds();
            let surface = read_surface(&place.path("results/surface-000000.vtp"));
            let pressure = &surface.arrays["pressure"];
            let mean = pressure.iter().sum::<f64>() / pressure.len() as f64;
            let least = pressure.iter().copied().fold(f64::INFINITY, f64::min);
            println!("{sides} {width} {turned}: {mean:.3} {least:.3}");
            assert!((mean - 1.0).abs() < 0.07 && least > 0.72, "{mean} {least}");
        }
    }
}

#[test]
fn packed_fluid_that_something_would_cut_is_refused() {
    let refused = |old: &str, new: &str, words: &[&str]| {
        assert!(REST.contains(old));
        Workplace::new()
            .run(&REST.replace(old, new), &[])
            .refuses(words);
    };
    let spacing = "packed_fluid = true\nspacing = 0.025";
    refused(
        "packed_fluid = true",
        spacing,
        &["body `post`", "0.05", "0.025"],
    );
    refused(
        "min = [-1.0, -1.0]",
        "min = [-1.0, -0.5]",
        &["body `post`", "y_min"],
    );
    let two = "packed_fluid = true\nplace = { translate = [-0.3, 0.0] }\n\n[[body]]\nname = \"other\"\n\
               shape = { circle = { radius = 0.23 } }\nplace = { translate = [0.3, 0.0] }";
    refused(
        "packed_fluid = true",
        two,
        &["body `post`", "`other`", "move them apart"],
    );
}
