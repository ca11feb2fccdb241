//! Halves of bodies that end at a mirror count as the whole, however they end there.

use crate::support::forces::{FIXED, MOVING, scene};
use crate::support::{Workplace, ascii_stl};

/// The force on the body of a scene.
fn force(place: &Workplace, scene: &str, motion: &str) -> [f64; 3] {
    place.run(scene, &["--set", motion]).succeeds();
    let force = &place.json("results/summary.json")["bodies"]["body"]["force_gauge"];
    std::array::from_fn(|k| force[k].as_f64().unwrap())
}

#[test]
fn half_an_outline_at_a_mirror_has_the_force_of_the_whole() {
    let of = |points: &str| {
        let shape = format!("polygon = {{ points = {points} }}");
        scene(2, 0.1, &shape, "")
            .replace("min = [-1.2, -1.0]", "min = [-0.4, 0.0]")
            .replace("y_min = \"free-stream\"", "y_min = \"symmetry\"")
    };
    let whole = of("[[0.0, 0.0], [0.5, -0.12], [1.0, 0.0], [0.5, 0.12]]");
    let halves = ["0.0", "1e-7", "-1e-7"]
        .map(|end| of(&format!("[[0.0, {end}], [1.0, {end}], [0.5, 0.12]]")));
    let place = Workplace::new();
    for motion in [MOVING, FIXED] {
        let expected = force(&place, &whole, motion);
        assert!(expected[0] > 0.0 && expected[1].abs() < 1e-9 * expected[0]);
        for half in &halves {
            let off = force(&place, half, motion)[0] / expected[0] - 1.0;
            assert!(off.abs() < 1e-12, "{off}: {motion}: {half}");
        }
        let answer = place.run(&halves[0], &["--set", motion]);
        assert!(
            answer.err.contains("a mirror, which makes it whole"),
            "{}",
            answer.err
        );
    }
    // Too far off to be half of one, too near for gas to come between.
    let short = of("[[0.0, 0.01], [1.0, 0.01], [0.5, 0.12]]");
    let answer = place.run(&short, &["--set", FIXED]);
    answer.succeeds();
    let told = "`body`: stands on the side `y_min`, and its forces are its own";
    assert!(answer.out.contains(told), "{}", answer.out);
}

/// The diamond of a wing, from its root on to a tip of so much of its chord, and its image.
fn tapered(root: f64, tip: f64, is_closed: bool, is_whole: bool) -> String {
    let section = |z: f64, part: f64| {
        [[0.0, 0.0], [0.5, -0.12], [1.0, 0.0], [0.5, 0.12]].map(|[x, y]| [part * x, part * y, z])
    };
    let (a, b) = (section(root, 1.0), section(0.6, tip));
    let mut facets = Vec::new();
    for (i, j) in [(0, 1), (1, 2), (2, 3), (3, 0)] {
        facets.extend([[a[i], a[j], b[j]], [a[i], b[j], b[i]]]);
    }
    facets.extend([[b[0], b[1], b[2]], [b[0], b[2], b[3]]]);
    if is_closed {
        facets.extend([[a[0], a[2], a[1]], [a[0], a[3], a[2]]]);
    }
    if is_whole {
        let image = |[x, y, z]: [f64; 3]| [x, y, -z];
        let images: Vec<_> = facets
            .iter()
            .map(|&[a, b, c]| [b, a, c].map(image))
            .collect();
        facets.extend(images);
    }
    ascii_stl("wing", &facets)
}

/// The same, as wide at its tip.
fn wing(root: f64, is_closed: bool, is_whole: bool) -> String {
    tapered(root, 1.0, is_closed, is_whole)
}

#[test]
fn half_a_file_at_a_mirror_has_the_force_of_the_whole_closed_or_open() {
    let scene = scene(3, 0.1, "stl = { file = \"wing.stl\" }", "incidence = 3.0")
        .replace("min = [-1.2, -1.0, -1.0]", "min = [-0.4, -0.6, 0.0]")
        .replace("max = [1.4, 1.0, 1.0]", "max = [1.2, 0.6, 1.0]")
        .replace("z_min = \"free-stream\"", "z_min = \"symmetry\"");
    let place = Workplace::new();
    place.write("wing.stl", wing(0.0, false, true));
    let expected = force(&place, &scene, FIXED);
    assert!(expected[1] > 0.0 && expected[2].abs() < 1e-9 * expected[1]);
    for (root, is_closed) in [(0.0, true), (0.0, false), (2e-6, true), (-2e-6, false)] {
        place.write("wing.stl", wing(root, is_closed, false));
        assert_eq!(force(&place, &scene, FIXED), expected, "{root} {is_closed}");
    }
}

#[test]
fn half_a_file_is_made_whole_where_a_scene_says_which_way_the_other_half_lies() {
    let entry = "stl = { file = \"wing.stl\" }";
    let whole = scene(3, 0.1, entry, "incidence = 3.0")
        .replace("min = [-1.2, -1.0, -1.0]", "min = [-0.4, -0.6, -1.0]")
        .replace("max = [1.4, 1.0, 1.0]", "max = [1.2, 0.6, 1.0]");
    let half = |way: &str| {
        let told = format!("stl = {{ file = \"wing.stl\", half = \"{way}\" }}");
        whole.replace(entry, &told)
    };
    let place = Workplace::new();
    let ghosts = |scene: &str| {
        place.write("scene.toml", scene);
        place
            .aero(&["pack", "scene.toml", "--out", "packed"])
            .succeeds();
        std::fs::read(place.path("packed/scene-ghosts.vtp")).unwrap()
    };
    place.write("wing.stl", tapered(0.0, 0.5, false, true));
    let expected = ghosts(&whole);
    for is_closed in [true, false] {
        place.write("wing.stl", tapered(0.0, 0.5, is_closed, false));
        assert!(ghosts(&half("-z")) == expected, "{is_closed}");
    }
    for (way, words) in [("+x", "toward +x"), ("w", "not a direction of the file")] {
        place.run(&half(way), &[]).refuses(&[words]);
    }
    let packed = place.aero(&["pack", "wing.stl", "--half", "-z", "--spacing", "0.05"]);
    packed.succeeds();
    let told = "joined the other half of the body, toward -z";
    assert!(packed.out.contains(told), "{}", packed.out);
}

#[test]
fn half_a_file_is_flown_whole_if_that_is_said_and_told_of_if_not() {
    let place = Workplace::new();
    place.write("whole.stl", tapered(0.0, 0.5, false, true));
    place.write("open.stl", tapered(0.0, 0.5, false, false));
    place.write("closed.stl", tapered(0.0, 0.5, true, false));
    let flown = |file: &str, more: &[&str]| {
        let common = ["fly", file, "--mach", "2", "--incidence", "3"];
        let common = common
            .into_iter()
            .chain(["--minutes", "0.05", "--overwrite"]);
        let asked: Vec<&str> = common
            .chain(["--scene", "flown.toml"])
            .chain(more.iter().copied())
            .collect();
        place.aero(&asked)
    };
    let scene = |file: &str, more: &[&str]| {
        let answer = flown(file, more);
        answer.succeeds();
        let text = std::fs::read_to_string(place.path("flown.toml")).unwrap();
        let lines = text.lines().filter(|line| {
            let is_its_own = ["title", "name", "shape"].map(|key| line.starts_with(key));
            !is_its_own.contains(&true)
        });
        (lines.collect::<Vec<_>>().join("\n"), text, answer.out)
    };
    let (whole, _, out) = scene("whole.stl", &[]);
    assert!(!out.contains("--half"), "{out}");
    let (joined, text, out) = scene("open.stl", &["--half", "-z"]);
    assert_eq!(joined, whole);
    assert!(text.contains(", half = \"-z\" }"), "{text}");
    assert!(out.contains("joined the other half") && !out.contains("--half"));
    // As it is, it is flown with a word, or refused with one where it is open.
    let asks = "flat where it ends toward -z of the file";
    let (alone, text, out) = scene("closed.stl", &["--fill"]);
    assert!(alone != whole && out.contains(asks), "{out}");
    assert!(text.contains(", fill = true }"), "{text}");
    flown("open.stl", &[]).refuses(&["`--half -z`", "half = \"-z\"", "`--fill`"]);
}
