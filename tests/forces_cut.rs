//! Forces on what sides cut or other solids cover are the integral of what `surface-*.vtp` shows, for particles and for points that
//! stay.

use crate::support::Workplace;
use crate::support::forces::{FIXED, MOVING, along, difference, mean_drag, scene};

/// Pressure coefficient of a wedge of 20 degrees at Mach 3 [NACA Report 1135 (1953), eqs 128 and 150], by its section of two slopes
/// where the domain ends.
const WEDGE: f64 = 0.439_90 * 2.0 * 0.363_970;

/// A wedge of 20 degrees at Mach 3, `length` long, whole and by halves.
fn wedges(spacing: f64, length: f64) -> [String; 2] {
    let height = 0.363_970 * length;
    let points = format!(
        "[[0.0, 0.0], [{length}, {}], [{length}, {height}]]",
        -height
    );
    let whole = scene(
        2,
        spacing,
        &format!("polygon = {{ points = {points} }}"),
        "",
    )
    .replace("mach = 2.0", "mach = 3.0")
    .replace("end_time = 0.2", "end_time = 1.2")
    .replace("min = [-1.2, -1.0]", "min = [-0.4, -1.0]")
    .replace("max = [1.4, 1.0]", "max = [1.0, 1.0]");
    let half = whole
        .replace("min = [-0.4, -1.0]", "min = [-0.4, 0.0]")
        .replace("y_min = \"free-stream\"", "y_min = \"symmetry\"");
    [whole, half]
}

#[test]
fn a_wedge_that_an_outlet_cuts_has_the_drag_of_its_pressure_whole_or_by_halves() {
    for scene in wedges(0.05, 1.5) {
        let off = mean_drag(&scene) / WEDGE - 1.0;
        assert!(off.abs() < 0.025, "{off} off");
    }
}

#[test]
fn a_body_has_twice_the_drag_of_its_half() {
    // Some of its ghosts stand on the plane of symmetry and face beyond it.
    let [whole, half] = wedges(0.054, 0.8).map(|scene| mean_drag(&scene));
    let off = half / whole - 1.0;
    assert!(off.abs() < 0.01, "{off} off");
}

/// Its mirror image goes with it.
#[test]
fn a_half_that_ends_in_a_mirror_moves_along_it_as_the_whole_does_and_not_through_it() {
    let moved = |lowest: f64, velocity: [f64; 2]| {
        let shape = format!("polygon = {{ points = [[0.0, 0.0], [0.8, {lowest}], [0.8, 0.3]] }}");
        let motion = format!("}} }}\nmotion = {{ velocity = {velocity:?} }}");
        scene(2, 0.05, &shape, "")
            .replace("min = [-1.2, -1.0]", "min = [-1.2, 0.0]")
            .replace("y_min = \"free-stream\"", "y_min = \"symmetry\"")
            .replacen("} }", &motion, 1)
    };
    let [whole, half] = [-0.3, 0.0].map(|lowest| mean_drag(&moved(lowest, [-0.2, 0.0])));
    assert!((half / whole - 1.0).abs() < 1e-9, "{half}, {whole}");
    let through = moved(-0.3, [0.0, 0.1]);
    let words = ["body.body.motion", "through the mirror", "y_min"];
    Workplace::new().run(&through, &[]).refuses(&words);
}

/// Nothing presses the foot of what stands on another solid, and where they are flush their surface is one.
#[test]
fn the_force_on_what_stands_on_another_solid_is_the_integral_of_its_surface() {
    let [upper, lower] = [0.55, 0.05].map(|height| {
        let block = scene(2, 0.05, "rectangle = { width = 0.63, height = 0.5 }", "");
        let block = block.replace("min = [-1.2, -1.0]", "min = [-1.2, -0.2]");
        let place = format!("}} }}\nplace = {{ translate = [0.0, {height}] }}");
        let block = block.replacen("} }", &place, 1);
        let on_the_floor = block.replace("y_min = \"free-stream\"", "y_min = \"wall\"");
        on_the_floor.replace("mach = 2.0", "mach = 0.5")
    });
    let below = "[[body]]\nname = \"below\"\nshape = { rectangle = { width = 1.4, height = 0.5 } }\n\
                 place = { translate = [0.0, 0.05] }\n[output]";
    let stacked = upper.replace("[output]", below);
    for scene in [&lower, &stacked] {
        for motion in [MOVING, FIXED] {
            let found = difference(scene, motion);
            assert!(found < 0.01, "{motion}: {found} %: {scene}");
        }
    }
    // Fins through a tube end where it does.
    let tube = "profile = { points = [[-0.9, 0.0], [-0.3, 0.25], [0.3, 0.25], [0.3, 0.0]] }";
    let fins =
        "[[body]]\nname = \"fins\"\nshape = { cuboid = { edges = [0.6, 0.07, 1.3] } }\n[output]";
    let tail = scene(3, 0.1, tube, "").replace("[output]", fins);
    let found = difference(&tail, FIXED);
    assert!(found < 1e-6, "{found} %");
    // Less than a fiftieth of it is spread as friction.
    let place = Workplace::new();
    let answer = place.run(&tail, &["--set", FIXED]);
    answer.succeeds();
    let told = answer.out.contains("`body`: its force is");
    assert!(!told, "{}", answer.out);
}

/// The rest of a wedge is beyond the outlet, of a half and of a meridian plane behind the mirror and around the axis.
#[test]
fn the_force_on_what_sides_cut_is_the_integral_of_its_surface() {
    const WORDS: &str = "than the integral of what its surface shows";
    let above = |scene: &str, side: &str| {
        scene
            .replace("min = [-1.2, -1.0]", "min = [-1.2, 0.0]")
            .replace("y_min = \"free-stream\"", &format!("y_min = {side:?}"))
    };
    let [wedge, _] = wedges(0.1, 2.0);
    let cone = scene(3, 0.1, "cone = { half_angle = 20.0, length = 2.8 }", "");
    let block = scene(2, 0.05, "rectangle = { width = 0.6, height = 0.5 }", "");
    let ball = scene(2, 0.1, "circle = { radius = 0.3 }", "");
    let place = Workplace::new();
    for scene in [&wedge, &cone, &above(&block, "axis"), &above(&ball, "axis")] {
        for motion in [MOVING, FIXED] {
            let found = along(scene, motion);
            assert!(found < 1e-6, "{motion}: {found} %: {scene}");
        }
    }
    // What is spread of it is told where it is much, as on a cone of a few cells, and nothing else.
    let run = |scene: &str, motion: &str| {
        let answer = place.run(scene, &["--set", motion]);
        answer.succeeds();
        let summary = place.json("results/summary.json");
        let told = summary["warnings"].as_array().expect("a list").clone();
        let told = told
            .iter()
            .any(|w| w.as_str().is_some_and(|w| w.contains(WORDS)));
        assert_eq!(told, answer.out.contains(WORDS), "{}", answer.out);
        told
    };
    assert!(run(&cone, MOVING));
    for scene in [&block, &above(&block, "symmetry")] {
        for motion in [MOVING, FIXED] {
            assert!(!run(scene, motion), "{motion}: {scene}");
        }
    }
    // Gas at rest presses it with nothing but what is rounded.
    let closed = block.replace("mach = 2.0", "mach = 0.0").replace(
        "x_min = \"inlet\"\nx_max = \"outlet\"",
        "x_min = \"wall\"\nx_max = \"wall\"",
    );
    let standing = closed
        .replace("min = [-1.2, -1.0]", "min = [-1.2, -0.25]")
        .replace("y_min = \"free-stream\"", "y_min = \"wall\"");
    for scene in [&closed, &standing] {
        for motion in [MOVING, FIXED] {
            assert!(!run(scene, motion), "{motion}: {scene}");
        }
    }
}
