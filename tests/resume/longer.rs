//! Runs that have come to their end, and go on to a later one.

use super::{STREAM, assert_same, results};
use crate::support::Workplace;

/// `STREAM` with frames that a later end does not move, none of them at the ends.
fn stream(end: f64) -> String {
    STREAM
        .replace("end_time = 0.25", &format!("end_time = {end}"))
        .replace("frames = 4", "interval = 0.06")
}

/// The same about points that stay.
fn points(end: f64) -> String {
    stream(end)
        .replace("extrapolation = \"wm\"", "motion = \"fixed\"")
        .replace("{ wall = { velocity = 0.05 } }", "\"symmetry\"")
        .replace(
            "motion = { angular_velocity = 1.0, velocity = [0.1, 0.0] }",
            "",
        )
}

/// The same by viscous particles.
fn viscous(end: f64) -> String {
    format!("{}\n[gas]\nviscosity = 0.01\n", stream(end))
}

/// Runs a scene in one go, into a folder of its own.
fn run_whole(place: &Workplace, scene: &str) {
    place.write("scene.toml", scene);
    let arguments = ["run", "scene.toml", "--out", "whole"];
    place.aero(&arguments).succeeds();
}

/// Runs `short`, makes it longer by `settings`, and compares with `long` in one go.
fn prolong(short: &str, settings: &[&str], long: &str) {
    let place = Workplace::new();
    run_whole(&place, long);
    place.run(short, &[]).succeeds();
    let mut more = vec!["--resume"];
    for setting in settings {
        more.extend(["--set", setting]);
    }
    place.run(short, &more).succeeds();
    assert_same(&place, "whole", "results");
    let again = place.run(short, &more);
    again.succeeds();
    assert!(again.out.contains("came to its end"), "{}", again.out);
}

#[test]
fn a_longer_run_has_the_bits_of_one_that_never_stopped() {
    for (short, long) in [(0.25, 0.4), (0.24, 0.36)] {
        prolong(
            &stream(short),
            &[&format!("end_time={long}")],
            &stream(long),
        );
        prolong(
            &points(short),
            &[&format!("end_time={long}")],
            &points(long),
        );
    }
    prolong(&viscous(0.1), &["end_time=0.16"], &viscous(0.16));
}

#[test]
fn a_run_that_was_to_be_steady_goes_on_watched_or_not() {
    let steady = |scene: String| scene.replace("spacing", "stop = \"steady\"\nspacing");
    prolong(
        &steady(stream(0.25)),
        &["end_time=0.4"],
        &steady(stream(0.4)),
    );
    let place = Workplace::new();
    let scene = steady(stream(0.25));
    place.run(&scene, &[]).succeeds();
    let more = [
        "--resume",
        "--set",
        "end_time=0.4",
        "--set",
        "stop=end-time",
    ];
    place.run(&scene, &more).succeeds();
    run_whole(&place, &stream(0.4));
    let [one, other] = ["results", "whole"].map(|name| results(&place.path(name)));
    let told = |files: Vec<(String, Vec<u8>)>| {
        let kept = files.into_iter().filter(|(name, _)| name != "run.toml");
        kept.collect::<Vec<_>>()
    };
    assert!(told(one) == told(other));
}

#[test]
fn counted_frames_go_on_at_their_interval() {
    let place = Workplace::new();
    place.run(STREAM, &[]).succeeds();
    place
        .run(STREAM, &["--resume", "--set", "end_time=0.4"])
        .succeeds();
    let whole = STREAM.replace("frames = 4", "interval = 0.0625");
    let whole = whole.replace("end_time = 0.25", "end_time = 0.4");
    run_whole(&place, &whole);
    for name in [
        "run.pvd",
        "history.csv",
        "frame-000005.vtp",
        "frame-000007.vtp",
    ] {
        let read = |out: &str| std::fs::read(place.path(&format!("{out}/{name}"))).unwrap();
        assert!(read("results") == read("whole"), "{name} differs");
    }
}

#[test]
fn what_cannot_be_made_longer_is_refused_and_left_as_it_was() {
    let place = Workplace::new();
    place.run(STREAM, &[]).succeeds();
    let before = results(&place.path("results"));
    let more = ["--resume", "--set", "end_time=0.5", "--set"];
    for (setting, words) in [
        ("spacing=0.04", ["spacing = 0.05", "spacing = 0.04"]),
        (
            "body.post.name=pole",
            ["name = \"post\"", "name = \"pole\""],
        ),
        ("output.frames=8", ["frames = 4", "frames = 8"]),
        ("end_time=0.1", ["t = 0.25", "end_time = 0.1"]),
        ("stop=steady", ["stop = \"steady\"", "cannot go on"]),
    ] {
        let answer = place.run(STREAM, &[&more[..], &[setting]].concat());
        answer.refuses(&[words[0], words[1], "`--resume`"]);
        assert!(results(&place.path("results")) == before, "{setting}");
    }
    let settles = points(0.25).replace(
        "motion = \"fixed\"",
        "motion = \"fixed\"\ntime = \"settle\"",
    );
    place.run(&settles, &[]).succeeds();
    place
        .run(&settles, &["--resume", "--set", "end_time=0.5"])
        .refuses(&["came to its end", "settled", "leave out `--resume`"]);
}
