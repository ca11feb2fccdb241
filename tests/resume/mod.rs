//! A run that was stopped goes on as if it never had been: same bits in every frame, every row of
//! the history, whatever stopped it.

mod kills;
mod longer;
mod stops;

use std::path::Path;
use std::process::{Child, Command, Stdio};

use crate::support::Workplace;

/// A stream past a moving post: open sides, a body, moving ghosts; a checkpoint after every step.
const STREAM: &str = r#"
dimension = 2
spacing = 0.05
end_time = 0.25

[free_stream]
mach = 2.0
density = 1.0
pressure = 0.7142857142857143

[domain]
min = [0.0, 0.0]
max = [1.0, 0.5]

[domain.sides]
x_min = "inlet"
x_max = "outlet"
y_min = { wall = { velocity = 0.05 } }
y_max = "free-stream"

[[body]]
name = "post"
shape = { circle = { radius = 0.1 } }
place = { translate = [0.5, 0.25] }
motion = { angular_velocity = 1.0, velocity = [0.1, 0.0] }

[scheme]
extrapolation = "wm"

[output]
frames = 4
checkpoint_seconds = 0
"#;

/// A run that goes on in the background.
fn start(place: &Workplace, out: &str, more: &[&str]) -> Child {
    Command::new(env!("CARGO_BIN_EXE_aero"))
        .current_dir(place.path(""))
        .args(["run", "scene.toml", "--threads", "1", "--out", out])
        .args(more)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("the program runs")
}

/// All that a run wrote but what depends on the clock.
fn results(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let mut files: Vec<_> = std::fs::read_dir(folder)
        .expect("the results")
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| !path.ends_with("summary.json") && !path.ends_with("last-checkpoint"))
        .map(|path| {
            let name = path.file_name().expect("a name").to_string_lossy().into();
            (name, std::fs::read(path).expect("a file"))
        })
        .collect();
    files.sort();
    files
}

#[track_caller]
fn assert_same(place: &Workplace, one: &str, other: &str) {
    let (one_files, other_files) = (results(&place.path(one)), results(&place.path(other)));
    let names = |files: &[(String, Vec<u8>)]| files.iter().map(|f| f.0.clone()).collect::<Vec<_>>();
    assert_eq!(names(&one_files), names(&other_files));
    for (a, b) in one_files.iter().zip(&other_files) {
        assert!(a.1 == b.1, "{} differs", a.0);
    }
    let summary = |name: &str| {
        let mut summary = place.json(&format!("{name}/summary.json"));
        for key in [
            "wall_seconds",
            "cpu_seconds",
            "particle_updates_per_cpu_second",
            "peak_memory_bytes",
        ] {
            summary[key] = 0.into();
        }
        summary
    };
    assert_eq!(summary(one), summary(other));
}
