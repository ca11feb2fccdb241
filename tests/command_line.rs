//! What can be typed besides `pack`, `run` and `validate`.

mod support;

use support::Workplace;

#[test]
fn a_new_scene_is_written_once_and_never_over_another() {
    let place = Workplace::new();
    let answer = place.aero(&["new", "wedge"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    assert!(answer.out.contains("aero run wedge.toml"), "{}", answer.out);
    place
        .aero(&["new", "wedge"])
        .refuses(&["`wedge.toml` is there already", "aero new wedge FILE"]);
    assert_eq!(place.aero(&["new", "tube", "mine.toml"]).status, 0);
    let answer = place.aero(&[
        "run",
        "mine.toml",
        "--set",
        "end_time=0.001",
        "--out",
        "results",
    ]);
    assert_eq!(answer.status, 0, "{}", answer.err);
}

#[test]
fn kinds_are_listed_and_slips_of_the_finger_understood() {
    let place = Workplace::new();
    assert!(place.aero(&["new"]).out.contains("body"));
    place
        .aero(&["new", "cilinder"])
        .refuses(&["did you mean `cylinder`?"]);
    place
        .aero(&["validate", "wegde"])
        .refuses(&["did you mean `wedge`?"]);
    let answer = place.aero(&["rnu", "wedge.toml"]);
    assert_eq!(answer.status, 2);
    assert!(answer.err.contains("'run'"), "{}", answer.err);
}

#[test]
fn shells_and_manuals_are_served() {
    let place = Workplace::new();
    assert!(
        place
            .aero(&["completions", "bash"])
            .out
            .contains("validate")
    );
    let manual = place.aero(&["man"]).out;
    assert!(
        manual.contains(".TH aero") && manual.contains("resume"),
        "{manual}"
    );
}
