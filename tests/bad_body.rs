//! Every body that makes no sense is refused with one clear error and status 2.

use crate::support::{BOX, Workplace, box_with, octahedron};

/// `BOX` with a circle in it, and one line of the circle in place of another.
fn circle_with(old: &str, new: &str) -> String {
    let circle = r#"
[[body]]
name = "post"
shape = { circle = { radius = 0.1 } }
place = { translate = [0.5, 0.25] }
"#;
    assert!(circle.contains(old), "`{old}` is not in the body");
    format!("{BOX}{}", circle.replace(old, new))
}

#[track_caller]
fn refused(scene: &str, words: &[&str]) {
    Workplace::new().run(scene, &[]).refuses(words);
}

#[test]
fn a_corner_of_95_degrees_is_refused() {
    let shape = "shape = { compression_corner = { angle = 95.0 } }";
    let scene = circle_with("shape = { circle = { radius = 0.1 } }", shape);
    refused(
        &scene,
        &["body `post`", "angle is 95 degrees", "between 0 and 90"],
    );
}

#[test]
fn a_body_outside_the_domain_is_refused_with_both_extents() {
    let scene = circle_with("[0.5, 0.25]", "[5.0, 0.25]");
    refused(
        &scene,
        &[
            "body `post`",
            "outside the domain",
            "4.9 to 5.1 in x",
            "place.translate",
        ],
    );
}

#[test]
fn a_body_in_one_dimension_is_refused() {
    let scene = circle_with("name = \"post\"", "name = \"post\"")
        .replace("dimension = 2", "dimension = 1")
        .replace("[0.0, 0.0]", "[0.0]")
        .replace("[1.0, 0.5]", "[1.0]")
        .replace("y_min = \"periodic\"\ny_max = \"periodic\"\n", "");
    refused(&scene, &["body `post`", "dimension 1 holds no bodies"]);
}

#[test]
fn two_bodies_of_one_name_are_refused() {
    let scene = circle_with("[0.5, 0.25]", "[0.3, 0.25]");
    let second = circle_with("[0.5, 0.25]", "[0.7, 0.25]");
    let scene = scene + second.strip_prefix(BOX).unwrap();
    refused(&scene, &["body `post`", "another body has this name"]);
}

#[test]
fn an_unknown_shape_is_shown_with_its_place_and_those_there_are() {
    let scene = circle_with("circle = { radius", "sircle = { radius");
    refused(
        &scene,
        &[
            "line 26",
            "^^^^^^",
            "unknown variant `sircle`",
            "`circle`",
            "`stl`",
        ],
    );
}

#[test]
fn an_unknown_key_of_a_shape_is_shown_with_its_place() {
    let scene = circle_with("radius = 0.1", "radius = 0.1, diameter = 0.2");
    refused(
        &scene,
        &[
            "line 26",
            "^^^^^^^^",
            "unknown field `diameter`",
            "`radius`",
        ],
    );
}

#[test]
fn a_radius_below_zero_is_refused() {
    refused(
        &circle_with("radius = 0.1", "radius = -0.1"),
        &["body `post`", "radius is -0.1"],
    );
}

#[test]
fn a_shape_of_the_wrong_dimension_is_refused() {
    let place = Workplace::new();
    place.write("box.stl", octahedron("box"));
    let scene = circle_with("circle = { radius = 0.1 }", "stl = { file = \"box.stl\" }");
    place
        .run(&scene, &[])
        .refuses(&["body `post`", "dimension 3", "dimension 2"]);
}

#[test]
fn vectors_of_the_wrong_length_in_a_body_are_refused() {
    refused(
        &circle_with("[0.5, 0.25]", "[0.5]"),
        &["body `post`", "place.translate", "holds 1 numbers"],
    );
    let motion = "[0.5, 0.25] }\nmotion = { velocity = [1.0, 0.0, 0.0] }\n#";
    refused(
        &circle_with("[0.5, 0.25]", motion),
        &["body.post.motion.velocity", "holds 3 numbers"],
    );
    let spin = "[0.5, 0.25] }\nmotion = { angular_velocity = [0.0, 0.0, 1.0] }\n#";
    refused(
        &circle_with("[0.5, 0.25]", spin),
        &["body.post.motion.angular_velocity", "a number in 2D"],
    );
}

#[test]
fn angular_velocities_over_time_that_make_no_sense_are_refused() {
    let spin = |table: &str| {
        let motion = format!("[0.5, 0.25] }}\nmotion = {{ angular_velocity = {table} }}\n#");
        circle_with("[0.5, 0.25]", &motion)
    };
    let table = |values: &str| spin(&format!("{{ table = {{ {values} }} }}"));
    refused(
        &table("times = [0.0, 1.0], rates = [1.0]"),
        &["angular_velocity.table", "2 times and 1 rates"],
    );
    refused(
        &table("times = [0.0, 0.0], rates = [1.0, 2.0]"),
        &["angular_velocity.table.times", "must increase"],
    );
    refused(
        &table("times = [0.0], rates = [1.0], axis = [0.0, 0.0, 1.0]"),
        &["angular_velocity.table.axis", "left out in 2D"],
    );
    refused(
        &spin("{ cosine = { amplitude = [0.0, 0.0, 1.0], period = 1.0 } }"),
        &["angular_velocity.cosine.amplitude", "a number in 2D"],
    );
    refused(
        &spin("{ cosine = { amplitude = 1.0, period = 0.0 } }"),
        &["0 is not a positive number"],
    );
    refused(&spin("{ sine = { amplitude = 1.0 } }"), &["`cosine`"]);
}

#[test]
fn a_name_that_cannot_be_a_file_name_is_refused() {
    refused(
        &circle_with("\"post\"", "\"a/b\""),
        &["line 25", "^^^^^", "`a/b` is not a name"],
    );
}

#[test]
fn a_body_too_small_for_the_spacing_is_refused() {
    let scene = circle_with("radius = 0.1", "radius = 0.001");
    refused(&scene, &["body `post`", "too coarse", "spacing of at most"]);
}

#[test]
fn a_missing_file_of_points_is_named() {
    let scene = circle_with(
        "circle = { radius = 0.1 }",
        "polygon_file = { file = \"none.dat\" }",
    );
    refused(&scene, &["body `post`", "cannot read", "none.dat"]);
}

#[test]
fn ghosts_too_fine_for_memory_are_refused() {
    let place = Workplace::new();
    place.write("scene.toml", circle_with("", ""));
    let arguments = "pack scene.toml --spacing 1e-12 --layers 5";
    let answer = place.aero(&arguments.split(' ').collect::<Vec<_>>());
    answer.refuses(&["body.post.spacing", "particles", "would fit"]);
}

#[test]
fn ghosts_much_finer_than_the_gas_are_refused_with_the_finest_spacing() {
    let spaced = |spacing: &str| {
        let name = "name = \"post\"";
        circle_with(name, &format!("{name}\nspacing = {spacing}"))
    };
    for (spacing, finer) in [("0.0062", "8.06452 times"), ("1e-12", "times as fine")] {
        refused(
            &spaced(spacing),
            &["body.post.spacing", finer, "set at least 0.00625"],
        );
    }
    Workplace::new().run(&spaced("0.00625"), &[]).succeeds();
    // A part of a huge body: it has a wall here, and its plane of symmetry far away.
    let scene = include_str!("../cases/biconvex.toml")
        .replace("spacing = 0.0125 ", "spacing = 0.2 ")
        .replace("wall = \"slip\"", "place = { scale = 1000.0 }");
    let words = [
        "body.aerofoil.spacing",
        "32 times as fine",
        "160 layers",
        "set at least 0.025",
    ];
    refused(&scene, &words);
}

#[test]
fn ghosts_so_coarse_that_gas_leaks_are_refused_with_the_coarsest_spacing() {
    let scene = circle_with("name = \"post\"", "name = \"post\"\nspacing = 0.08");
    refused(
        &scene,
        &["body.post.spacing", "1.6 times as coarse", "at most 0.075"],
    );
}

#[test]
fn a_body_that_leaves_no_room_for_gas_is_refused() {
    let scene = box_with(
        "[output]",
        "[[body]]\nname = \"all\"\nshape = { half_space = { height = 0.6 } }\n\n[output]",
    );
    refused(&scene, &["gas"]);
}
