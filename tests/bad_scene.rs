//! Every scene that makes no sense is refused with one clear error and status 2.

use crate::support::{BOX, Workplace, box_with};

#[track_caller]
fn refused(scene: &str, words: &[&str]) {
    Workplace::new().run(scene, &[]).refuses(words);
}

#[test]
fn an_unknown_key_is_shown_with_its_place_in_the_file() {
    let scene = box_with("spacing = 0.05", "spacing = 0.05\nspcing = 0.1");
    refused(
        &scene,
        &[
            "scene.toml",
            "line 4, column 1",
            "^^^^^^",
            "unknown field `spcing`",
            "`spacing`",
        ],
    );
}

#[test]
fn an_unknown_side_is_shown_with_those_there_are() {
    let scene = box_with("x_max = \"wall\"", "x_max = \"wal\"");
    refused(
        &scene,
        &["line 12", "^^^^^", "unknown variant `wal`", "`free-stream`"],
    );
}

#[test]
fn an_unknown_precision_is_shown_with_those_there_are() {
    let scene = box_with("[domain]", "[scheme]\nprecision = \"half\"\n\n[domain]");
    refused(
        &scene,
        &["^^^^^^", "unknown variant `half`", "`double` or `mixed`"],
    );
}

#[test]
fn an_unknown_key_of_a_wall_is_shown_with_its_place() {
    let scene = box_with("x_max = \"wall\"", "x_max = { wall = { speed = 1.0 } }");
    refused(
        &scene,
        &["line 12", "^^^^^", "unknown field `speed`", "`velocity`"],
    );
}

#[test]
fn text_that_is_not_toml_is_shown_with_its_place() {
    refused("dimension == 2", &["scene.toml", "line 1", "^"]);
}

#[test]
fn a_negative_spacing_is_shown_with_its_place() {
    let scene = box_with("spacing = 0.05", "spacing = -0.05");
    refused(
        &scene,
        &[
            "line 3, column 11",
            "^^^^^",
            "-0.05 is not a positive number",
        ],
    );
}

#[test]
fn nan_and_infinity_are_refused_wherever_a_number_stands() {
    for (old, new) in [
        ("spacing = 0.05", "spacing = nan"),
        ("end_time = 0.02", "end_time = inf"),
        ("min = [0.0, 0.0]", "min = [nan, 0.0]"),
        ("position = 0.5", "position = -inf"),
    ] {
        refused(&box_with(old, new), &["^", "number"]);
    }
}

#[test]
fn a_dimension_of_four_is_refused() {
    refused(
        &box_with("dimension = 2", "dimension = 4"),
        &["line 2", "1, 2 or 3"],
    );
}

#[test]
fn a_missing_section_is_named() {
    let scene = BOX.split("[domain]").next().unwrap();
    refused(scene, &["missing field `domain`"]);
}

#[test]
fn a_missing_scene_file_is_named() {
    let answer = Workplace::new().aero(&["run", "nowhere.toml"]);
    answer.refuses(&["cannot read", "nowhere.toml"]);
}

#[test]
fn a_wall_that_gas_would_stick_to_without_viscosity_is_refused_with_the_mend() {
    let sticky = "x_max = { wall = { kind = \"no-slip\" } }";
    for motion in ["", "[scheme]\nmotion = \"fixed\"\n\n"] {
        let scene =
            box_with("x_max = \"wall\"", sticky).replace("[domain]", &format!("{motion}[domain]"));
        refused(
            &scene,
            &[
                "domain.sides.x_max",
                "`no-slip`",
                "add `viscosity` to [gas]",
                "use `slip`",
            ],
        );
    }
}

#[test]
fn what_a_wall_cannot_have_is_refused_with_the_mend() {
    for (wall, words) in [
        ("temperature = 300.0", "add `kind = \"no-slip\"`"),
        (
            "kind = \"no-slip\", temperature = 300.0, heat_flux = 1.0",
            "one of temperature and heat_flux",
        ),
        (
            "kind = \"no-slip\", temperature = -3.0",
            "not a positive number",
        ),
        (
            "velocity = [0.0, 1.0]",
            "does not feel how its surface moves",
        ),
        ("kind = \"no-slip\", velocity = [1.0]", "holds 1 numbers"),
        (
            "kind = \"no-slip\", temperature = 300.0",
            "gas.gas_constant",
        ),
    ] {
        let side = format!("x_max = {{ wall = {{ {wall} }} }}");
        let scene = box_with("x_max = \"wall\"", &side).replace(
            "[domain]",
            "[scheme]\nmotion = \"fixed\"\n\n[gas]\nviscosity = 1e-3\n\n[domain]",
        );
        refused(&scene, &[words]);
    }
}

#[test]
fn a_viscosity_that_makes_no_sense_is_refused_with_the_mend() {
    for (gas, words) in [
        ("viscosity = -1e-3", "-0.001 is not a positive number"),
        ("viscosity = { sutherland = {} }", "give `gas.gas_constant`"),
        ("viscosity = { reynolds = 100.0 }", "which is at rest"),
        ("prandtl = 0.7", "add `viscosity`"),
        ("viscosity = 1e-3\nprandtl = nan", "not a positive number"),
    ] {
        let fixed = format!("[scheme]\nmotion = \"fixed\"\n\n[gas]\n{gas}\n\n[domain]");
        refused(&box_with("[domain]", &fixed), &[words]);
    }
}

#[test]
fn viscous_particles_about_an_axis_are_refused_by_name() {
    let scene = box_with("[domain]", "[gas]\nviscosity = 1e-3\n\n[domain]");
    let scene = scene.replace("y_min = \"periodic\"", "y_min = \"axis\"");
    let scene = scene.replace("y_max = \"periodic\"", "y_max = \"wall\"");
    refused(&scene, &["gas.viscosity", "motion = \"fixed\""]);
}

#[test]
fn gas_without_any_viscosity_is_refused_by_name() {
    let scene = box_with(
        "[domain]",
        "[scheme]\nartificial_dissipation = false\n\n[domain]",
    );
    refused(
        &scene,
        &["scheme.artificial_dissipation", "give the gas one"],
    );
}

#[test]
fn a_periodic_side_opposite_to_a_wall_is_refused() {
    let scene = box_with("y_max = \"periodic\"", "y_max = \"wall\"");
    refused(
        &scene,
        &[
            "domain.sides.y_min",
            "opposite",
            "make both periodic or neither",
        ],
    );
}

#[test]
fn a_missing_side_and_a_side_too_many_are_refused() {
    refused(
        &box_with("y_min = \"periodic\"\n", ""),
        &["domain.sides.y_min", "missing"],
    );
    let scene = box_with("y_min", "z_max = \"outlet\"\ny_min");
    refused(&scene, &["domain.sides.z_max", "dimension 2"]);
}

#[test]
fn a_domain_without_extent_is_refused() {
    refused(
        &box_with("max = [1.0, 0.5]", "max = [0.0, 0.5]"),
        &["domain.max", "exceed min"],
    );
    refused(
        &box_with("max = [1.0, 0.5]", "max = [-1.0, 0.5]"),
        &["domain.max", "exceed min"],
    );
}

#[test]
fn a_domain_thinner_than_a_spacing_is_refused() {
    let scene = box_with("max = [1.0, 0.5]", "max = [1.0, 0.04]");
    refused(&scene, &["domain.max, y", "less than one spacing"]);
}

#[test]
fn a_closed_axis_of_no_whole_number_of_spacings_is_refused_with_a_good_spacing() {
    let scene = box_with("spacing = 0.05", "spacing = 0.03");
    refused(
        &scene,
        &["domain.max, x", "33.3333 spacings", "set spacing = 0.0303"],
    );
}

#[test]
fn a_periodic_axis_below_twice_the_support_is_refused() {
    let scene = box_with("max = [1.0, 0.5]", "max = [1.0, 0.4]");
    refused(
        &scene,
        &["domain.max, y", "its own image", "widen it to 0.45"],
    );
}

#[test]
fn vectors_of_the_wrong_length_are_refused() {
    let scene = box_with("max = [1.0, 0.5]", "max = [1.0, 0.5, 0.5]");
    refused(&scene, &["domain.max", "holds 3 numbers", "dimension 2"]);
    let scene = box_with("pressure = 1.0 }", "pressure = 1.0, velocity = [1.0] }");
    refused(
        &scene,
        &["initial.riemann.left.velocity", "holds 1 numbers"],
    );
}

#[test]
fn a_diaphragm_outside_the_domain_is_refused() {
    refused(
        &box_with("position = 0.5", "position = 1.5"),
        &["initial.riemann.position", "0 to 1"],
    );
}

#[test]
fn an_inlet_without_a_free_stream_is_refused() {
    let scene = box_with("x_min = \"wall\"", "x_min = \"inlet\"");
    refused(&scene, &["free_stream", "missing", "inlet"]);
}

#[test]
fn an_inlet_that_the_stream_leaves_by_is_refused() {
    let stream = "[free_stream]\nmach = 2.0\ndensity = 1.0\npressure = 1.0\n";
    let scene = box_with("x_max = \"wall\"", "x_max = \"inlet\"") + stream;
    refused(
        &scene,
        &["domain.sides.x_max", "is an inlet", "speed of -2.3"],
    );
}

#[test]
fn an_overdetermined_free_stream_is_refused() {
    let with = |lines: &str| format!("{BOX}\n[free_stream]\npressure = 1.0\n{lines}\n");
    refused(
        &with("density = 1.0"),
        &["free_stream", "one of mach, speed and velocity"],
    );
    refused(
        &with("density = 1.0\nmach = 2.0\nspeed = 1.0"),
        &["one of mach, speed and velocity"],
    );
    refused(
        &with("density = 1.0\ntemperature = 300.0\nmach = 2.0"),
        &["one of density and temperature"],
    );
    refused(&with("mach = 2.0"), &["one of density and temperature"]);
    refused(
        &with("density = 1.0\nmach = 2.0\ndirection = [0.0, 0.0]"),
        &["free_stream.direction", "zero"],
    );
    refused(
        &with("density = 1.0\nmach = -2.0"),
        &["-2 is not zero or a positive number"],
    );
}

#[test]
fn frames_and_interval_together_are_refused() {
    refused(
        &box_with("frames = 2", "frames = 2\ninterval = 0.1"),
        &["output", "not both"],
    );
    refused(
        &box_with("frames = 2", "frames = 0"),
        &["0 is not a whole number above zero"],
    );
}

#[test]
fn more_particles_than_memory_are_refused_before_they_are_made() {
    let scene = box_with("spacing = 0.05", "spacing = 1e-8");
    let start = std::time::Instant::now();
    refused(&scene, &["spacing", "5.0e15 particles", "GB", "would fit"]);
    assert!(start.elapsed().as_secs() < 10);
}

#[test]
fn a_formula_of_any_depth_is_refused_in_words() {
    let (before, _) = BOX.split_once("[initial").expect("an initial state");
    for opening in ["(", "-", "1+"] {
        let density = opening.repeat(100_000);
        let field = format!("[initial.field]\npressure = 1.0\ndensity = \"{density}\"\n");
        refused(&format!("{before}{field}"), &["density", "too long"]);
    }
}

#[test]
fn a_side_closed_by_no_body_is_refused() {
    let scene = box_with("x_max = \"wall\"", "x_max = \"body\"");
    refused(&scene, &["domain.sides.x_max", "no body is near"]);
}

#[test]
fn zero_threads_are_refused() {
    let answer = Workplace::new().run(BOX, &["--threads", "0"]);
    assert_eq!(answer.status, 2);
}

#[test]
fn a_reservoir_takes_a_slow_stream_that_comes_straight_in() {
    let stream = |velocity: &str| {
        let stream = format!(
            "\n[free_stream]\ndensity = 1.0\npressure = 1.0\nvelocity = {velocity}\n[domain]\n"
        );
        box_with("x_min = \"wall\"", "x_min = \"reservoir\"").replace("\n[domain]\n", &stream)
    };
    for velocity in ["[2.0, 0.0]", "[-0.1, 0.0]", "[0.5, 0.5]"] {
        refused(
            &stream(velocity),
            &["domain.sides.x_min", "below the speed of sound", "1.18"],
        );
    }
    let two = stream("[0.3, 0.0]").replace("x_max = \"wall\"", "x_max = \"free-stream\"");
    refused(&two, &["domain.sides.x_min", "close the others"]);
    Workplace::new().run(&stream("[0.3, 0.0]"), &[]).succeeds();
}
