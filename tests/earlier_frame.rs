//! A run may start from a frame that an earlier one has left.

use crate::support::{BOX, Workplace, box_with};

/// Twice as fine as the earlier run, from its last frame.
const FINER: [&str; 4] = [
    "--set",
    "spacing=0.025",
    "--set",
    "initial={ frame = \"earlier/frame-000002.vtp\" }",
];

fn earlier(place: &Workplace, more: &[&str]) {
    place.write("scene.toml", BOX);
    let run = ["run", "scene.toml", "--out", "earlier", "--overwrite"];
    place.aero(&[&run, more].concat()).succeeds();
}

/// Mass in the last row of the history.
fn mass(place: &Workplace, folder: &str) -> f64 {
    let text = std::fs::read_to_string(place.path(&format!("{folder}/history.csv"))).expect("text");
    let mut lines = text.lines();
    let header = lines.next().expect("a header");
    let column = header.split(',').position(|name| name == "mass");
    let last = lines.next_back().expect("a row");
    let field = last.split(',').nth(column.expect("a column of mass"));
    field.expect("a mass").parse().expect("a number")
}

#[test]
fn a_fine_run_takes_over_the_flow_of_a_coarse_one() {
    let place = Workplace::new();
    for more in [vec![], vec!["--set", "output.compress=true"]] {
        earlier(&place, &more);
        let stream = [
            "--set",
            "free_stream={ density = 1.0, pressure = 1.0, velocity = [0.0, 0.0] }",
        ];
        place.run(BOX, &[&FINER[..], &stream].concat()).succeeds();
        let (coarse, fine) = (mass(&place, "earlier"), mass(&place, "results"));
        assert!((fine / coarse - 1.0).abs() < 0.01, "{coarse} {fine}");
    }
}

#[test]
fn a_file_that_is_no_frame_is_refused() {
    let place = Workplace::new();
    place.write("notes.vtp", "these are notes");
    place.write("empty.vtp", "");
    let refused = |frame: &str, words: &[&str]| {
        let setting = format!("initial={{ frame = \"{frame}\" }}");
        let stream = "free_stream={ density = 1.0, pressure = 1.0, velocity = [0.0, 0.0] }";
        let answer = place.run(BOX, &["--set", &setting, "--set", stream]);
        answer.refuses(&[&["initial.frame", frame, "frame-NNNNNN.vtp"], words].concat());
    };
    refused("nothing.vtp", &["cannot be read"]);
    refused("notes.vtp", &["no VTK file"]);
    refused("empty.vtp", &["no VTK file"]);
    earlier(&place, &[]);
    let whole = std::fs::read(place.path("earlier/frame-000002.vtp")).expect("a frame");
    for share in [1, 2, 5, 9] {
        place.write("cut.vtp", &whole[..whole.len() * share / 10]);
        refused("cut.vtp", &[]);
    }
}

#[test]
fn a_scene_starts_in_one_way_only() {
    let scene = box_with(
        "[initial.riemann]",
        "[initial]\nframe = \"x.vtp\"\n[initial.riemann]",
    );
    Workplace::new()
        .run(&scene, &[])
        .refuses(&["`initial`", "one of riemann, field and frame"]);
}

#[test]
fn another_stream_and_a_trend_go_with_a_frame_and_are_checked_as_such() {
    let place = Workplace::new();
    earlier(&place, &[]);
    let refused = |settings: &[&str], words: &[&str]| {
        let stream = "free_stream={ density = 1.0, pressure = 1.0, velocity = [1.0, 0.0] }";
        let sets = settings.iter().flat_map(|setting| ["--set", setting]);
        let more: Vec<&str> = ["--set", stream].into_iter().chain(sets).collect();
        place.run(BOX, &more).refuses(words);
    };
    let alone = "initial={ stream = { mach = 2.0, density = 1.0, pressure = 1.0 } }";
    refused(&[alone], &["`initial.stream`", "`initial.frame`"]);
    let frame = "initial={ frame = \"earlier/frame-000002.vtp\", ";
    let bad = format!("{frame}stream = {{ density = 1.0, pressure = 1.0 }} }}");
    refused(&[&bad], &["`initial.stream`", "mach, speed and velocity"]);
    let far = format!("{frame}trend = {{ frame = \"x.vtp\", part = 2.0 }} }}");
    refused(&[&far], &["at most 1"]);
    let gone = format!("{frame}trend = {{ frame = \"x.vtp\", part = 1.0 }} }}");
    refused(&[&gone], &["`initial.trend.frame`", "cannot be read"]);
}
