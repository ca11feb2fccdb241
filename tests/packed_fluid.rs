//! Fluid that conforms to a body takes the place of the lattice where the scene asks.

use crate::support::Workplace;

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
    assert!(lattice < packed, "{lattice} {packed}");
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
