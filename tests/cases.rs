//! Every scene in `cases/` takes a few steps, coarser and shorter than it is meant to be.

use crate::support::Workplace;

/// Each scene with what makes it small.
const SMALL: [(&str, &[&str]); 58] = [
    ("aerofoil", &["end_time=0.03", "stop=end-time"]),
    ("apollo", &["end_time=0.002", "spacing=0.5"]),
    ("apollo-axisymmetric", &["end_time=0.005", "spacing=0.4"]),
    ("backward-step", &["end_time=0.5"]),
    ("becker", &["end_time=1.0"]),
    (
        "biconvex",
        &[
            "end_time=0.05",
            "spacing=0.05",
            "body.aerofoil.spacing=0.025",
        ],
    ),
    ("blown-sphere", &["end_time=0.2", "spacing=0.2"]),
    ("bump", &["end_time=0.3", "spacing=0.0625", "stop=end-time"]),
    ("cavity", &["end_time=0.02"]),
    ("cone", &["end_time=0.1", "spacing=0.05"]),
    ("cone-faceted", &["end_time=0.1", "spacing=0.1"]),
    (
        "cone-incidence",
        &[
            "end_time=0.05",
            "stop=end-time",
            "scheme.refine=0",
            "spacing=0.1",
        ],
    ),
    ("couette", &["end_time=1e-9", "stop=end-time"]),
    ("couette-hot", &["end_time=2e-7", "stop=end-time"]),
    (
        "crossing",
        &["end_time=0.2", "stop=end-time", "spacing=0.04"],
    ),
    ("cylinder", &["end_time=0.2", "spacing=0.125"]),
    (
        "cylinder-shedding",
        &["end_time=3.0", "spacing=1.0", "scheme.refine=1"],
    ),
    (
        "cylinder-viscous",
        &["end_time=3.0", "stop=end-time", "scheme.refine=0"],
    ),
    ("diamond", &["end_time=0.1", "stop=end-time"]),
    ("double-mach", &["end_time=0.02", "spacing=0.05"]),
    ("duct", &["end_time=0.1"]),
    (
        "flat-plate",
        &["end_time=1e-4", "stop=end-time", "scheme.refine=0"],
    ),
    (
        "flat-plate-askew",
        &["end_time=1e-4", "stop=end-time", "scheme.refine=0"],
    ),
    (
        "flat-plate-subsonic",
        &["end_time=1e-4", "stop=end-time", "scheme.refine=0"],
    ),
    ("helium-bubble", &["end_time=1e-5", "spacing=0.005"]),
    (
        "hemisphere-hot",
        &[
            "end_time=2e-5",
            "spacing=0.1",
            "stop=end-time",
            "scheme.refine=0",
        ],
    ),
    (
        "hemisphere-viscous",
        &[
            "end_time=1e-5",
            "spacing=0.0125",
            "stop=end-time",
            "scheme.refine=0",
        ],
    ),
    (
        "hemisphere-viscous-hot",
        &[
            "end_time=1e-5",
            "spacing=0.0125",
            "stop=end-time",
            "scheme.refine=0",
        ],
    ),
    ("hot-shock", &["end_time=1e-4", "spacing=0.02"]),
    ("intake", &["end_time=0.2", "spacing=0.125"]),
    ("jet", &["end_time=0.2", "spacing=0.1"]),
    ("jet-underexpanded", &["end_time=0.4", "spacing=0.1"]),
    ("mms", &["end_time=0.05"]),
    ("mms-3d", &["spacing=0.1"]),
    (
        "nozzle",
        &["end_time=0.0002", "spacing=0.002701713333333333"],
    ),
    (
        "nozzle-back-pressure",
        &["end_time=0.0002", "spacing=0.002701713333333333"],
    ),
    ("pitching", &["end_time=0.1", "spacing=0.05"]),
    ("poiseuille", &["end_time=0.01"]),
    (
        "polar",
        &[
            "end_time=0.1",
            "scheme.refine=0",
            "spacing=0.05",
            "stop=end-time",
        ],
    ),
    ("sod", &["end_time=0.005"]),
    ("sod-1d", &["end_time=0.01"]),
    ("sound", &["end_time=0.02"]),
    ("sphere", &["end_time=0.2", "spacing=0.25"]),
    (
        "sphere-axisymmetric",
        &[
            "end_time=0.2",
            "spacing=0.2",
            "stop=end-time",
            "scheme.refine=0",
        ],
    ),
    (
        "sphere-stl",
        &[
            "end_time=0.2",
            "spacing=0.25",
            "body.sphere.shape.tessellated.around=48",
        ],
    ),
    ("square", &["end_time=0.00005"]),
    ("step", &["end_time=0.05", "spacing=0.05"]),
    ("store", &["end_time=0.0005", "spacing=0.06"]),
    ("supersonic-vortex", &["end_time=0.1", "stop=end-time"]),
    ("taylor-couette", &["end_time=0.2"]),
    ("taylor-green", &["end_time=0.02"]),
    ("transonic", &["end_time=0.03", "stop=end-time"]),
    ("two-gases", &["end_time=2e-5"]),
    ("vortices-liquid", &["end_time=0.02"]),
    ("water-hammer", &["end_time=1e-4"]),
    ("wedge", &["end_time=0.1", "spacing=0.125"]),
    (
        "wedge-fixed",
        &["end_time=0.1", "spacing=0.125", "stop=end-time"],
    ),
    (
        "wedge-hot",
        &["end_time=1e-4", "spacing=0.125", "stop=end-time"],
    ),
];

fn folder() -> std::path::PathBuf {
    std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("cases")
}

#[test]
fn every_scene_takes_a_few_steps() {
    for (name, settings) in SMALL {
        let place = Workplace::new();
        let scene = folder().join(format!("{name}.toml"));
        let mut arguments = vec!["run".to_owned(), scene.display().to_string()];
        for setting in settings.iter().chain(&["output.frames=1"]) {
            arguments.extend(["--set".to_owned(), (*setting).to_owned()]);
        }
        place.aero(&arguments).succeeds();
        let summary = place.json(&format!("out/{name}/summary.json"));
        assert_eq!(summary["case"], name);
        assert_eq!(summary["stop_reason"], "end time reached");
        assert!(summary["steps"].as_u64().unwrap() >= 3, "{name}");
    }
}

#[test]
fn no_scene_is_left_out_of_these_tests() {
    let mut names: Vec<String> = std::fs::read_dir(folder())
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|ending| ending == "toml"))
        .map(|path| path.file_stem().unwrap().to_string_lossy().into_owned())
        .collect();
    names.sort();
    assert_eq!(names, SMALL.map(|(name, _)| name));
}
