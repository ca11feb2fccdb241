//! `aero check`, and what `aero run` refuses before it starts.

use crate::support::Workplace;

/// A plane scene in a stream at Mach 2 with these bodies.
fn scene(sides: &str, bodies: &str) -> String {
    format!(
        r#"
dimension = 2
spacing = 0.05
end_time = 0.1

[free_stream]
mach = 2.0
density = 1.4
pressure = 1.0

[domain]
min = [-1.0, 0.0]
max = [1.0, 1.0]

[domain.sides]
x_min = "inlet"
x_max = "outlet"
{sides}

{bodies}
"#
    )
}

const ON_A_WALL: &str = "y_min = \"wall\"\ny_max = \"free-stream\"";
const CLOSED_BY_A_BODY: &str = "y_min = \"body\"\ny_max = \"free-stream\"";

fn block(name: &str, [x0, x1]: [f64; 2], [y0, y1]: [f64; 2]) -> String {
    format!(
        "[[body]]\nname = \"{name}\"\nshape = {{ rectangle = {{ width = {}, height = {} }} }}\nplace = {{ translate = [{}, {}] }}\n",
        x1 - x0,
        y1 - y0,
        0.5 * (x0 + x1),
        0.5 * (y0 + y1)
    )
}

/// What both commands say of a scene that they refuse.
fn refusal(text: &str) -> String {
    let place = Workplace::new();
    place.write("scene.toml", text);
    let said = ["check", "run"].map(|command| {
        let answer = place.aero(&[command, "scene.toml"]);
        answer.refuses(&[]);
        answer.err
    });
    assert_eq!(said[0], said[1]);
    said[0].clone()
}

#[test]
fn a_wall_that_ends_in_a_buffer_is_refused_with_the_mend() {
    let floor = block("floor", [-3.0, 1.1], [-0.5, 0.2]);
    let said = refusal(&scene(CLOSED_BY_A_BODY, &floor));
    assert!(
        said.contains("body `floor`: ends inside the buffer of side `x_max`"),
        "{said}"
    );
    assert!(said.contains("carry it on past x = 1.35"), "{said}");
}

/// Points have no gas behind the side.
#[test]
fn a_body_that_ends_on_an_outlet_is_told_to_particles_alone() {
    let ramp = "[[body]]\nname = \"ramp\"\nshape = { polygon = { points = [[0.0, 0.0], [1.0, 0.0], [1.0, 0.2]] } }";
    let place = Workplace::new();
    place.write("scene.toml", scene(ON_A_WALL, ramp));
    for (motion, is_told) in [("with-the-gas", true), ("fixed", false)] {
        let motion = format!("scheme.motion={motion}");
        let answer = place.aero(&["check", "scene.toml", "--set", &motion]);
        answer.succeeds();
        let told = answer.out.contains("`ramp`: ends on the side `x_max`");
        assert_eq!(told, is_told, "{motion}: {}", answer.out);
        assert!(
            !answer.out.contains("spacings from the side `x_max`"),
            "{}",
            answer.out
        );
    }
}

#[test]
fn a_body_through_a_free_stream_side_is_refused() {
    let pillar = block("pillar", [0.0, 0.2], [0.5, 1.2]);
    let said = refusal(&scene(ON_A_WALL, &pillar));
    assert!(
        said.contains("passes through the free-stream side `y_max`"),
        "{said}"
    );
}

/// What lies beyond a period comes in at the other side as a body of its own alone; what runs through both sides is a wall along them.
#[test]
fn a_body_across_a_periodic_side_is_refused_without_its_copy_and_taken_with_it() {
    const PERIODIC: &str = "y_min = \"periodic\"\ny_max = \"periodic\"";
    let post = block("post", [0.0, 0.2], [0.8, 1.2]);
    let said = refusal(&scene(PERIODIC, &post));
    for words in [
        "body `post`: crosses the periodic side `y_max` near (0.",
        ", 1.0000), and what lies beyond does not come in at `y_min`",
        "moved by [0.0, -1.0]",
    ] {
        assert!(said.contains(words), "`{words}` in {said}");
    }
    assert_eq!(said.matches("crosses").count(), 1, "{said}");
    let other = block("other", [0.4, 0.6], [-0.2, 0.2]);
    let said = refusal(&scene(PERIODIC, &(post.clone() + &other)));
    assert_eq!(said.matches("crosses").count(), 2, "{said}");
    let copy = block("copy", [0.0, 0.2], [-0.2, 0.2]);
    let through = block("wall", [0.0, 0.2], [-0.5, 1.5]);
    for bodies in [post + &copy, through] {
        let place = Workplace::new();
        place.write("scene.toml", scene(PERIODIC, &bodies));
        place.aero(&["check", "scene.toml"]).succeeds();
    }
}

#[test]
fn a_body_through_both_symmetry_planes_leaves_no_gap_to_them() {
    let mirrors = "y_min = \"symmetry\"\ny_max = \"symmetry\"";
    let slanted = "[[body]]\nname = \"row\"\nshape = { polygon = { points = [[0.0, -1.0], [0.6, 2.0], [-0.2, 2.0]] } }\n";
    let place = Workplace::new();
    place.write("scene.toml", scene(mirrors, slanted));
    let answer = place.aero(&["check", "scene.toml"]);
    answer.succeeds();
    assert!(!answer.out.contains("leaves a gap"), "{}", answer.out);
    // Across it reaches from one plane to the other.
    assert!(answer.out.contains("area 1, "), "{}", answer.out);
}

#[test]
fn gas_that_bodies_enclose_is_refused() {
    let walls = [
        block("left", [-0.4, -0.2], [-0.1, 0.5]),
        block("right", [0.2, 0.4], [-0.1, 0.5]),
        block("lid", [-0.4, 0.4], [0.45, 0.6]),
    ];
    let said = refusal(&scene(ON_A_WALL, &walls.concat()));
    assert!(said.contains("enclose gas near"), "{said}");
}

#[test]
fn moving_bodies_that_pass_through_one_another_are_refused() {
    let moving = block("second", [0.1, 0.4], [0.3, 0.6]) + "motion = { velocity = [0.1, 0.0] }\n";
    let bodies = block("first", [-0.1, 0.2], [0.3, 0.6]) + &moving;
    let said = refusal(&scene(ON_A_WALL, &bodies));
    assert!(
        said.contains("bodies `first` and `second`: pass through one another"),
        "{said}"
    );
}

#[test]
fn a_check_tells_sides_bodies_and_cost_and_draws_a_picture() {
    let place = Workplace::new();
    let boxes = block("step", [0.0, 0.3], [-0.2, 0.3]) + &block("cap", [0.0, 0.3], [0.3, 0.5]);
    place.write("scene.toml", scene(ON_A_WALL, &boxes));
    let answer = place.aero(&["check", "scene.toml", "--seconds", "0.05"]);
    answer.succeeds();
    let said = answer.out;
    for words in [
        "side x_min at -1: the free stream comes in",
        "touches side y_min",
        ", body `cap`\n",
        "touches body `step`\n",
        "GiB of memory",
        "minutes",
        "particles",
    ] {
        assert!(said.contains(words), "`{words}` is missing in {said}");
    }
    let picture = std::fs::read(place.path("out/scene/check.png")).unwrap();
    assert!(picture.len() > 1000);
}

/// Gas at Mach 0.5 through a tube whose outlet holds no pressure.
const TUBE: &str = r#"
dimension = 1
spacing = 0.05
end_time = 0.1

[free_stream]
mach = 0.5
density = 1.0
pressure = 1.0

[domain]
min = [0.0]
max = [1.0]

[domain.sides]
x_min = "inlet"
x_max = "outlet"
"#;

#[test]
fn warnings_are_the_same_in_the_check_the_run_and_the_summary() {
    let near = block("near", [-0.7, -0.2], [0.07, 0.85]);
    let scenes = [
        (
            scene(ON_A_WALL, &near),
            [
                "its shock may reach the inlet",
                "is 3.0 spacings from the side `y_max`",
                "leaves a gap of 1.4 spacings to the side `y_min`",
            ],
        ),
        (
            TUBE.to_owned(),
            [
                "`x_min`: the free stream crosses it at Mach 0.50",
                "`x_max`: the free stream crosses it at Mach 0.50",
                "gas leaves slower than sound through 100 % of the outlet `x_max`",
            ],
        ),
    ];
    for (scene, words) in scenes {
        let place = Workplace::new();
        place.write("scene.toml", scene);
        let checked = place.aero(&["check", "scene.toml", "--seconds", "0.05"]);
        let ran = place.aero(&["run", "scene.toml"]);
        checked.succeeds();
        ran.succeeds();
        let warnings = warnings(&place);
        // What only its end shows is no matter of the check.
        let late = ["gas leaves", "throws waves back", "than the integral of"];
        let is_known = |warning: &&String| !late.iter().any(|words| warning.contains(words));
        for warning in warnings.iter().filter(is_known) {
            assert!(checked.out.contains(warning), "{warning}");
        }
        for warning in &warnings {
            assert!(ran.out.contains(warning), "{warning}");
        }
        for words in words {
            assert!(
                warnings.iter().any(|w| w.contains(words)),
                "`{words}` in {warnings:?}"
            );
        }
    }
}

/// Those of the summary.
fn warnings(place: &Workplace) -> Vec<String> {
    let summary = place.json("out/scene/summary.json");
    let list = summary["warnings"].as_array().unwrap();
    list.iter()
        .map(|w| w.as_str().unwrap().to_owned())
        .collect()
}

/// As `aero check SCENE | head -1`.
#[test]
fn who_reads_no_further_breaks_nothing() {
    let place = Workplace::new();
    place.write("scene.toml", scene(ON_A_WALL, ""));
    let program = assert_cmd::cargo::cargo_bin("aero");
    let mut child = std::process::Command::new(program)
        .current_dir(place.path(""))
        .args(["check", "scene.toml"])
        .stdout(std::process::Stdio::piped())
        .stderr(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success() && said.is_empty(), "{said}");
}

/// What the scene shows before the run, and what only its end shows.
#[test]
fn bodies_that_overlap_and_a_wake_that_reaches_the_outlet_are_told_in_terminal_and_summary() {
    let place = Workplace::new();
    let bodies = block("near", [0.5, 0.9], [0.0, 0.4]) + &block("far", [0.4, 0.6], [0.2, 0.4]);
    let scene = scene(ON_A_WALL, &bodies).replace(
        "end_time = 0.1",
        "stop = \"steady\"\n\n[scheme]\nmotion = \"fixed\"",
    );
    place.write("scene.toml", &scene);
    let ran = place.aero(&["run", "scene.toml"]);
    ran.succeeds();
    let warnings = warnings(&place);
    for words in ["`near` and `far` overlap near (0.5", "a wake reaches it"] {
        assert!(
            warnings.iter().any(|w| w.contains(words)),
            "`{words}` in {warnings:?}"
        );
        assert!(ran.out.contains(words), "`{words}` in {}", ran.out);
    }
}

/// Spacings of 0.05: a gap of 0.025 and a slot of 0.06 let no gas through; bodies that touch, and a gap of 0.15, are as they are meant.
#[test]
fn gaps_too_narrow_for_gas_are_told_with_their_width_and_the_spacing_that_opens_them() {
    let said = |bodies: &str| {
        let place = Workplace::new();
        place.write("scene.toml", scene(ON_A_WALL, bodies));
        let answer = place.aero(&["check", "scene.toml"]);
        answer.succeeds();
        answer.out
    };
    let low = block("low", [-0.3, 0.1], [0.2, 0.4]);
    let apart = said(&(low.clone() + &block("high", [-0.3, 0.1], [0.425, 0.6])));
    for words in [
        "`low` and `high`: the gap between them is 0.50 spacings wide near (",
        "choose a spacing of 6.25e-3",
    ] {
        assert!(apart.contains(words), "`{words}` in {apart}");
    }
    let fork = "[[body]]\nname = \"fork\"\nshape = { polygon = { points = [[-0.3, 0.3], [0.1, 0.3], [0.1, 0.4], \
                [-0.1, 0.4], [-0.1, 0.46], [0.1, 0.46], [0.1, 0.6], [-0.3, 0.6]] } }\n";
    let slot = said(fork);
    let words = "body `fork`: a slot in it is 1.20 spacings wide near (";
    assert!(slot.contains(words), "`{words}` in {slot}");
    for above in [0.4, 0.55] {
        let quiet = said(&(low.clone() + &block("high", [-0.3, 0.1], [above, 0.7])));
        assert!(!quiet.contains("spacings wide"), "{quiet}");
    }
}
