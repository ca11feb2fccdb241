//! Wall treatments compared, through the command line.

use crate::support::Workplace;

#[test]
fn treatments_keep_their_orders_and_a_picture_shows_them() {
    let place = Workplace::new();
    let order = ["validate", "mms-walls", "--quick", "--out", "walls"];
    let answer = place.aero(&[&order[..], &["--set", "spacing=1"]].concat());
    answer.succeeds();
    assert!(answer.err.contains("--set changes nothing of it"));
    assert!(!answer.out.contains("FAIL"), "{}", answer.out);
    let rows = place.json("walls/validation.json");
    let rows = rows.as_array().expect("a list");
    for name in [
        "Adami",
        "Colagrossi",
        "Esmaili",
        "Hashemi",
        "Marongiu",
        "Marrone",
        "Randles",
        "Takeda",
    ] {
        let of =
            |row: &&serde_json::Value| row["quantity"].as_str().is_some_and(|q| q.contains(name));
        assert!(rows.iter().filter(of).count() >= 4, "{name}");
    }
    assert!(rows.iter().all(|row| row["case"] == "mms-walls"));
    for picture in ["straight-lattice", "concave-packed"] {
        assert!(
            place
                .path(&format!("walls/mms-walls-{picture}.png"))
                .exists()
        );
    }
}
