//! Manufactured solutions, through the command line.

use std::path::Path;

use crate::support::Workplace;

fn mms() -> String {
    let scene = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/mms.toml");
    std::fs::read_to_string(scene).expect("the scene")
}

/// The scene of the project, coarse and short.
const SMALL: [&str; 4] = ["--set", "spacing=0.05", "--set", "end_time=0.05"];

#[test]
fn sources_drive_both_motions_and_no_drift_is_told() {
    for motion in ["with-the-gas", "fixed"] {
        let place = Workplace::new();
        let motion = format!("scheme.motion={motion}");
        let settings = [&SMALL[..], &["--set", &motion]].concat();
        place.run(&mms(), &settings).succeeds();
        let summary = place.json("results/summary.json");
        assert_eq!(summary["stop_reason"], "end time reached");
        assert!(summary["conservation"].is_null());
    }
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    for motion in ["scheme.motion=with-the-gas", "scheme.motion=fixed"] {
        let frame = |threads| {
            let place = Workplace::new();
            let settings = [&SMALL[..], &["--set", motion, "--threads", threads]].concat();
            place.run(&mms(), &settings).succeeds();
            std::fs::read(place.path("results/frame-000005.vtp")).expect("the last frame")
        };
        assert!(frame("1") == frame("2"));
    }
}

#[test]
fn a_solution_that_makes_mass_is_none_of_particles() {
    let heavier = [
        &SMALL[..],
        &["--set", "manufactured.density=\"1 + 0.1 * t\""],
    ]
    .concat();
    Workplace::new().run(&mms(), &heavier).refuses(&[
        "`manufactured`",
        "makes mass",
        "particles keep their mass",
        "scheme.motion = \"fixed\"",
    ]);
    let of_points = [&heavier[..], &["--set", "scheme.motion=fixed"]].concat();
    Workplace::new().run(&mms(), &of_points).succeeds();
}

#[test]
fn what_a_solution_does_not_fit_is_refused() {
    #[track_caller]
    fn set(settings: &[&str], words: &[&str]) {
        let settings: Vec<&str> = settings.iter().flat_map(|set| ["--set", set]).collect();
        let settings = [&SMALL[..], &settings].concat();
        Workplace::new().run(&mms(), &settings).refuses(words);
    }
    let fixed = "scheme.motion=fixed";
    set(
        &[fixed, "manufactured.pressure=\"1 + 0.1 * x\""],
        &["`domain.sides.x_min`", "is periodic", "give it this period"],
    );
    set(
        &["domain.sides.y_min=wall", "domain.sides.y_max=wall"],
        &[
            "`domain.sides.y_min`",
            "is closed",
            "let its velocity along y vanish",
        ],
    );
    set(
        &[
            fixed,
            "manufactured.velocity=[0.1, 0.0]",
            "domain.sides.y_min=symmetry",
            "domain.sides.y_max=symmetry",
            "manufactured.pressure=\"1 + 0.1 * sin(2 * pi * y)\"",
        ],
        &["`domain.sides.y_min`", "is a mirror", "choose `wall`"],
    );
    set(
        &["domain.sides.x_min=outlet", "domain.sides.x_max=outlet"],
        &[
            "`domain.sides.x_min`",
            "is no side of a manufactured solution",
        ],
    );
    set(
        &[fixed, "scheme.time=settle"],
        &["`manufactured`", "scheme.time = \"accurate\""],
    );
    set(
        &["initial.field={ density = 1.0 }"],
        &["`initial`", "leave out [manufactured]"],
    );
    set(
        &["manufactured.density=\"cos(90 * t) + 0.5\"", fixed],
        &["`manufactured.density`", "is -", "and t = 0."],
    );
    set(
        &["manufactured.velocity=[0.1]"],
        &["`manufactured.velocity`", "holds 1 formulas", "give 2"],
    );
    set(
        &["manufactured.density=\"1 + q\""],
        &["`q` is unknown; there are x, y, z, r, t, dx, pi"],
    );
}
