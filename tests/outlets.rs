//! Ways to end a flow compared, through the command line.

use crate::support::Workplace;

#[test]
fn sound_leaves_by_every_outlet_and_a_picture_shows_the_ramp() {
    let place = Workplace::new();
    let order = ["validate", "outlets", "--quick", "--out", "outlets"];
    let answer = place.aero(&[&order[..], &["--set", "spacing=1"]].concat());
    answer.succeeds();
    assert!(answer.err.contains("--set changes nothing of it"));
    assert!(!answer.out.contains("FAIL"), "{}", answer.out);
    let rows = place.json("outlets/validation.json");
    let rows = rows.as_array().expect("a list");
    for name in [
        "characteristic",
        "do-nothing",
        "hybrid",
        "mirror",
        "modified do-nothing",
        "evolved characteristics",
    ] {
        let name = format!(", {name}:");
        let of =
            |row: &&serde_json::Value| row["quantity"].as_str().is_some_and(|q| q.contains(&name));
        assert_eq!(rows.iter().filter(of).count(), 3, "{name}");
    }
    assert!(place.path("outlets/outlets-ramp.png").exists());
}
