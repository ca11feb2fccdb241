//! Every scene in `cases/stress/` takes a few steps, and comes to its end where that costs little.

use crate::support::Workplace;

/// Scenes that cost more than a moment, with what makes them small.
const SMALL: [(&str, &[&str]); 12] = [
    ("blunt-body", &["spacing=0.125", "end_time=0.05"]),
    ("expansion-corner", &["spacing=0.1", "end_time=0.2"]),
    ("finned-tail", &["spacing=0.02"]),
    ("gresho", &["spacing=0.03125", "end_time=0.02"]),
    ("kelvin-helmholtz", &["spacing=0.03125", "end_time=0.02"]),
    ("le-blanc", &["spacing=0.03"]),
    ("noh-2", &["spacing=0.05", "end_time=0.1"]),
    ("noh-3", &["spacing=0.1", "end_time=0.1"]),
    ("reflection", &["spacing=0.005"]),
    ("sedov-3", &["spacing=0.1", "end_time=0.05"]),
    ("sharp-trailing-edge", &["spacing=0.05", "end_time=0.1"]),
    ("thin-plate", &["spacing=0.04", "end_time=0.1"]),
];

#[test]
fn every_scene_comes_to_its_end() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/stress");
    let mut names: Vec<String> = std::fs::read_dir(&folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .map(|path| path.file_stem().unwrap().to_string_lossy().into_owned())
        .collect();
    names.sort();
    assert!(names.len() > 20);
    for (name, _) in SMALL {
        assert!(names.iter().any(|known| known == name), "{name}");
    }
    for name in names {
        let place = Workplace::new();
        let small = SMALL.iter().find(|(known, _)| *known == name);
        let coarse: &[&str] = small.map_or(&["output.frames=1"], |(_, settings)| settings);
        let scene = folder.join(format!("{name}.toml"));
        let mut arguments = vec!["run".to_owned(), scene.display().to_string()];
        for setting in coarse {
            arguments.extend(["--set".to_owned(), (*setting).to_owned()]);
        }
        place.aero(&arguments).succeeds();
        let summary = place.json(&format!("out/{name}/summary.json"));
        let end = summary["stop_reason"].as_str().unwrap();
        let came = end == "end time reached" || end.starts_with("settled");
        assert!(came, "{name}: {end}");
        assert!(summary["steps"].as_u64().unwrap() >= 3, "{name}");
        assert!(summary["min_energy"].as_f64().unwrap() > 0.0, "{name}");
    }
}

#[test]
fn a_formula_that_makes_no_sense_is_shown_with_its_place() {
    let scene = |density: &str| {
        format!(
            "dimension = 1\nspacing = 0.1\nend_time = 0.1\n[domain]\nmin = [0.0]\nmax = [1.0]\n\
             [domain.sides]\nx_min = \"wall\"\nx_max = \"wall\"\n[initial.field]\n\
             density = {density}\npressure = 1.0\n"
        )
    };
    let place = Workplace::new();
    place
        .run(&scene("\"1 + q\""), &[])
        .refuses(&["line 11, column 11", "^^^", "`q` is unknown"]);
    place.run(&scene("\"1 - 2 * x\""), &[]).refuses(&[
        "density at the start is -0.1",
        "(0.550000)",
        "`initial`",
    ]);
    place.run(&scene("\"if(x < 0.5, 1, 0)\""), &[]).succeeds();
    place
        .run(&scene("\"1 / 0\""), &[])
        .refuses(&["free_stream", "lowest corner"]);
}
