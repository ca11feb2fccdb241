//! `--set` changes any value of a scene and says what it cannot change.

use crate::support::{BOX, Workplace};

#[test]
fn a_coarser_spacing_gives_fewer_particles() {
    let place = Workplace::new();
    place
        .run(
            BOX,
            &["--set", "domain.max=[1.0, 1.0]", "--set", "spacing=0.1"],
        )
        .succeeds();
    let summary = place.json("results/summary.json");
    assert_eq!(summary["spacing"], 0.1);
    assert_eq!(summary["particles"]["fluid"], 100);
}

#[test]
fn a_section_that_the_scene_lacks_can_be_set_with_bare_words() {
    let place = Workplace::new();
    let settings = [
        "--set",
        "scheme.equations=paper",
        "--set",
        "scheme.extrapolation=wm",
        "--set",
        "scheme.precision=mixed",
    ];
    place.run(BOX, &settings).succeeds();
    let summary = place.json("results/summary.json");
    assert_eq!(summary["scheme"], "paper");
    assert_eq!(summary["extrapolation"], "wm");
    assert_eq!(summary["precision"], "mixed");
}

#[test]
fn one_number_of_a_list_can_be_set() {
    let place = Workplace::new();
    place.run(BOX, &["--set", "domain.max.0=0.8"]).succeeds();
    assert_eq!(
        place.json("results/summary.json")["particles"]["fluid"],
        160
    );
}

#[test]
fn an_unknown_key_is_named() {
    let refused = |setting: &str, words: &[&str]| {
        Workplace::new()
            .run(BOX, &["--set", setting])
            .refuses(words);
    };
    refused("spcing=1", &["--set spcing=1", "unknown field `spcing`"]);
    refused(
        "scheme.cfll=1",
        &["--set scheme.cfll=1", "unknown field `cfll`"],
    );
    refused(
        "body.ramp.spacing=1",
        &["--set body.ramp.spacing=1", "ramp"],
    );
    refused("spacing.x=1", &["`spacing` is a float and has no key `x`"]);
    refused("domain=1", &["`domain` is a whole section"]);
    refused("spacing", &["no `=`"]);
    refused(
        "spacing=-1",
        &["--set spacing=-1", "-1 is not a positive number"],
    );
    refused(
        "spacing=coarse",
        &["--set spacing=coarse", "invalid type: string"],
    );
}

#[test]
fn a_comparison_takes_settings_for_all_its_runs_and_refuses_unknown_ones() {
    let place = Workplace::new();
    let case = ["validate", "supersonic-vortex", "--quick", "--set"];
    let answer = place.aero(&[&case[..], &["scheme.shifts=true"]].concat());
    answer.refuses(&["scheme", "shifts", "shifting"]);
    let tried = place.aero(&[&case[..], &["output.compress=true"]].concat());
    let words = ", with output.compress=true";
    assert!(tried.out.contains(words), "{}", tried.out);
}
