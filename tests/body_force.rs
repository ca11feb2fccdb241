//! A force that accelerates all gas.

use std::path::Path;

use crate::support::Workplace;

fn channel() -> String {
    let scene = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/poiseuille.toml");
    std::fs::read_to_string(scene).expect("the scene")
}

#[test]
fn a_channel_settles_to_its_parabola() {
    let place = Workplace::new();
    let settings = ["stop=steady", "spacing=0.1", "domain.max=[0.4, 1.0]"];
    let settings: Vec<&str> = settings.iter().flat_map(|set| ["--set", set]).collect();
    place.run(&channel(), &settings).succeeds();
    let history = std::fs::read_to_string(place.path("results/history.csv")).expect("a history");
    let mut lines = history.lines();
    let names: Vec<&str> = lines.next().expect("names").split(',').collect();
    let last: Vec<&str> = lines.last().expect("a last line").split(',').collect();
    let value = |name: &str| -> f64 {
        let column = names.iter().position(|n| *n == name).expect("a column");
        last[column].parse().expect("a number")
    };
    // Two thirds of the speed in the middle, less what ten cells leave out.
    let mean = value("momentum_x") / value("mass");
    assert!((mean - 2.0 / 3.0).abs() < 0.02, "{mean}");
}

#[test]
fn a_force_is_told_before_the_run() {
    let place = Workplace::new();
    let scene = place.write("scene.toml", channel());
    let answer = place.aero(&["check".as_ref(), scene.as_os_str()]);
    answer.succeeds();
    assert!(
        answer
            .out
            .contains("a force accelerates all gas by [0.8, 0.0]"),
        "{}",
        answer.out
    );
}

#[test]
fn forces_that_nothing_holds_up_are_refused() {
    #[track_caller]
    fn set(settings: &[&str], words: &[&str]) {
        let settings: Vec<&str> = settings.iter().flat_map(|set| ["--set", set]).collect();
        Workplace::new().run(&channel(), &settings).refuses(words);
    }
    set(
        &["domain.sides.y_min=symmetry", "body_force=[0.8, -1.0]"],
        &[
            "`body_force`",
            "domain.sides.y_min",
            "let it lie along that side",
        ],
    );
    set(
        &["body_force=[0.8]"],
        &["`body_force`", "holds 1 numbers", "give 2"],
    );
}
