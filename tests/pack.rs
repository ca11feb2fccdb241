//! `aero pack` writes ghosts and report for a mesh and for a scene, and they read back.

use crate::support::{BOX, Workplace, octahedron, read_vtp};

const GHOST_ARRAYS: [(&str, usize); 6] = [
    ("normal", 3),
    ("distance", 1),
    ("volume", 1),
    ("layer", 1),
    ("body", 1),
    ("face", 1),
];

const REPORT_KEYS: [&str; 15] = [
    "ghosts",
    "layer_counts",
    "density_std_percent",
    "density_max_percent",
    "shell_volume_error_percent",
    "wall_offset_max",
    "min_gap",
    "uncovered_area_percent",
    "hole_max",
    "hole_at",
    "coincident_ghosts",
    "volume_error_percent",
    "wall_seconds",
    "repairs",
    "warnings",
];

const TWO_POSTS: &str = r#"
[[body]]
name = "left"
shape = { circle = { radius = 0.1 } }
place = { translate = [0.25, 0.25] }
spacing = 0.02

[[body]]
name = "right"
shape = { rectangle = { width = 0.2, height = 0.2 } }
place = { translate = [0.75, 0.25] }
spacing = 0.02
"#;

fn check_ghosts(place: &Workplace, stem: &str) -> usize {
    let (points, arrays) = read_vtp(&place.path(&format!("{stem}-ghosts.vtp")));
    let expected: Vec<(String, usize)> = GHOST_ARRAYS
        .iter()
        .map(|&(name, components)| (name.to_owned(), components * points))
        .collect();
    assert_eq!(arrays, expected);
    let report = place.json(&format!("{stem}-pack.json"));
    for key in REPORT_KEYS {
        assert!(!report[key].is_null(), "`{key}` is missing");
    }
    assert_eq!(report["ghosts"], points);
    points
}

#[test]
fn a_mesh_is_packed_at_a_spacing_that_is_picked_and_explained() {
    let place = Workplace::new();
    place.write("gem.stl", octahedron("gem"));
    let answer = place.aero(&["pack", "gem.stl"]);
    answer.succeeds();
    assert!(
        answer.out.contains("gem: spacing 0.083 (picked: "),
        "{}",
        answer.out
    );
    assert!(check_ghosts(&place, "out/gem/gem") > 1000);
}

#[test]
fn a_mesh_in_millimetres_is_packed_in_metres() {
    let place = Workplace::new();
    place.write("gem.stl", octahedron("gem"));
    let arguments = "pack gem.stl --unit mm --spacing 0.0001 --layers 3 --out here";
    place
        .aero(&arguments.split(' ').collect::<Vec<_>>())
        .succeeds();
    check_ghosts(&place, "here/gem");
    let report = place.json("here/gem-pack.json");
    assert_eq!(report["layer_counts"].as_array().unwrap().len(), 3);
    assert_eq!(report["spacing"], 0.0001);
}

#[test]
fn a_body_as_large_as_a_house_is_asked_for_its_unit() {
    let place = Workplace::new();
    place.write("gem.stl", octahedron("gem").replace('1', "20"));
    let answer = place.aero(&["pack", "gem.stl", "--spacing", "2", "--layers", "2"]);
    answer.succeeds();
    assert!(answer.out.contains("--unit mm"), "{}", answer.out);
    for picture in ["slice", "wall"] {
        assert!(place.path(&format!("out/gem/gem-{picture}.png")).exists());
    }
}

#[test]
fn a_body_as_small_as_a_grain_is_asked_whether_its_unit_is_right() {
    let place = Workplace::new();
    place.write("gem.stl", octahedron("gem").replace('1', "0.5"));
    let answer = place.aero(&["pack", "gem.stl", "--unit", "mm", "--spacing", "0.0001"]);
    answer.succeeds();
    assert!(answer.out.contains("leave out `--unit`"), "{}", answer.out);
}

#[test]
fn bodies_with_nothing_half_way_between_them_show_a_slice() {
    let place = Workplace::new();
    let far: Vec<String> = octahedron("far")
        .lines()
        .map(|line| match line.strip_prefix("vertex ") {
            Some(numbers) => {
                let x: Vec<f64> = numbers
                    .split(' ')
                    .map(|word| word.parse().unwrap())
                    .collect();
                format!("vertex {} {} {}", x[0] + 5.0, x[1] + 5.0, x[2] + 5.0)
            }
            None => line.to_owned(),
        })
        .collect();
    place.write(
        "two.stl",
        format!("{}{}\n", octahedron("near"), far.join("\n")),
    );
    let answer = place.aero(&["pack", "two.stl", "--spacing", "0.2", "--layers", "2"]);
    answer.succeeds();
    assert!(place.path("out/two/two-slice.png").exists());
    assert!(
        !answer.err.contains('%'),
        "short work is silent: {}",
        answer.err
    );
}

#[test]
fn all_bodies_of_a_scene_are_packed_into_one_file() {
    let place = Workplace::new();
    place.write("posts.toml", format!("{BOX}{TWO_POSTS}"));
    place.aero(&["pack", "posts.toml"]).succeeds();
    check_ghosts(&place, "out/posts/posts");
    let report = place.json("out/posts/posts-pack.json");
    let bodies = report["bodies"].as_array().unwrap();
    assert_eq!(bodies.len(), 2);
    assert_eq!(bodies[1]["name"], "right");
    let sum = bodies
        .iter()
        .map(|body| body["ghosts"].as_u64().unwrap())
        .sum::<u64>();
    assert_eq!(report["ghosts"], sum);
}

#[test]
fn conforming_fluid_is_written_where_it_is_asked_for() {
    let place = Workplace::new();
    place.write("posts.toml", format!("{BOX}{TWO_POSTS}"));
    place
        .aero(&["pack", "posts.toml", "--fluid-layers", "3"])
        .succeeds();
    let (points, _) = read_vtp(&place.path("out/posts/posts-fluid.vtp"));
    assert!(points > 50, "{points}");
}

#[test]
fn what_cannot_be_packed_is_refused() {
    let refused = |name: &str, content: &str, more: &[&str], words: &[&str]| {
        let place = Workplace::new();
        place.write(name, content);
        place.aero(&[&["pack", name], more].concat()).refuses(words);
    };
    refused("empty.stl", "", &[], &["empty.stl", "empty"]);
    refused(
        "body.txt",
        "v 0 0 0",
        &[],
        &["body.txt", "no format of bodies"],
    );
    refused("bare.toml", BOX, &[], &["the scene has no bodies"]);
    refused("scene.toml", BOX, &["--unit", "mm"], &["--unit", "STL"]);
    let gem = octahedron("gem");
    let open = gem.replacen("facet normal", "#", 1);
    let open = open
        .split("endfacet")
        .skip(1)
        .collect::<Vec<_>>()
        .join("endfacet");
    refused("open.stl", &format!("solid open{open}"), &[], &["open.stl"]);
    refused(
        "gem.stl",
        &gem,
        &["--spacing", "5"],
        &["body `gem`", "too coarse"],
    );
    refused("gem.stl", &gem, &["--spacing", "1e-9"], &["particles"]);
    let answer = Workplace::new().aero(&["pack", "none.stl"]);
    answer.refuses(&["cannot read", "none.stl"]);
    for bad in ["0", "-1", "nan", "wide"] {
        let place = Workplace::new();
        place.write("gem.stl", &gem);
        let spacing = format!("--spacing={bad}");
        assert_eq!(place.aero(&["pack", "gem.stl", &spacing]).status, 2);
    }
}

/// A post with a foil of a fifth of a spacing on top.
const FOILED: &str = r#"
[[body]]
name = "foiled"
shape = { polygon = { points = [[0.3, 0.1], [0.5, 0.1], [0.5, 0.3], [0.401, 0.3], [0.401, 0.85], [0.399, 0.85], [0.399, 0.3], [0.3, 0.3]] } }
spacing = 0.02
allow_loss = true
"#;

#[test]
fn what_is_wrong_with_a_packing_is_told_by_every_command_in_the_same_words() {
    let place = Workplace::new();
    place.write("foil.toml", format!("{BOX}{FOILED}"));
    let packed = place.aero(&["pack", "foil.toml"]);
    packed.succeeds();
    let report = place.json("out/foil/foil-pack.json");
    let warning = report["warnings"][0].as_str().unwrap().to_owned();
    assert!(warning.contains("gas may pass through"), "{warning}");
    assert!(
        packed.out.contains(&format!("warning: {warning}")),
        "{}",
        packed.out
    );
    // The foil goes on beyond the box, which is periodic.
    let sides = ["domain.sides.y_min=wall", "domain.sides.y_max=wall"];
    let run = place.aero(&[
        "run",
        "foil.toml",
        "--set",
        "end_time=1e-4",
        "--set",
        sides[0],
        "--set",
        sides[1],
    ]);
    run.succeeds();
    assert!(run.err.contains(&warning), "{warning}: {}", run.err);
    let summary = place.json("out/foil/summary.json");
    let told = summary["warnings"][0].as_str().unwrap();
    assert!(told.contains("foiled") && told.contains(&warning), "{told}");
    assert!(summary["bodies"]["foiled"]["uncovered_area_percent"].is_number());
}

#[test]
fn the_loss_of_surface_may_be_allowed_by_flag_and_by_scene() {
    let place = Workplace::new();
    place.write("gem.stl", octahedron("gem"));
    let arguments = ["pack", "gem.stl", "--spacing", "0.2", "--allow-loss"];
    place.aero(&arguments).succeeds();
    let posts = TWO_POSTS.replacen("spacing = 0.02", "allow_loss = true", 1);
    place.write("posts.toml", format!("{BOX}{posts}"));
    place.aero(&["pack", "posts.toml"]).succeeds();
}
