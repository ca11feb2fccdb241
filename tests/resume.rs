//! A run that was stopped goes on as if it never had been: same bits in every frame, every row of
//! the history, whatever stopped it.

mod support;

use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use support::{BOX, Workplace};

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

/// Waits until a checkpoint is there.
fn await_checkpoint(folder: &Path) {
    let start = Instant::now();
    while !folder.join("checkpoint").exists() {
        assert!(start.elapsed() < Duration::from_secs(60), "no checkpoint");
        std::thread::sleep(Duration::from_millis(1));
    }
}

/// All that a run wrote but what depends on the clock.
fn results(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let mut files: Vec<_> = std::fs::read_dir(folder)
        .expect("the results")
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| !path.ends_with("summary.json"))
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

/// Runs `scene` once in one go, and once with so many kills at odd moments.
fn kill_and_resume(scene: &str, kills: u32) {
    let place = Workplace::new();
    place.run(scene, &["--threads", "1"]).succeeds();
    let whole = Instant::now();
    assert!(start(&place, "timed", &[]).wait().unwrap().success());
    let whole = whole.elapsed();
    // The golden ratio spreads the moments evenly over the run, whatever their number.
    let moment = |kill: u32| whole.mul_f64((f64::from(kill) * 0.618_033_988_75).fract());
    let mut killed = 0;
    for kill in 1..=kills {
        let mut run = start(&place, "killed", &["--resume"]);
        std::thread::sleep(moment(kill));
        if run.try_wait().unwrap().is_none() {
            killed += 1;
        }
        run.kill().expect("the run is mine to kill");
        run.wait().expect("the run ends");
        if place.path("killed/summary.json").exists() && !place.path("killed/checkpoint").exists() {
            assert_same(&place, "results", "killed");
            std::fs::remove_dir_all(place.path("killed")).unwrap();
        }
    }
    assert!(killed > 0, "every run ended before it was killed");
    let mut last = start(&place, "killed", &["--resume"]);
    assert!(last.wait().unwrap().success());
    assert_same(&place, "results", "killed");
}

#[test]
fn a_run_killed_a_few_times_ends_with_the_same_bits() {
    kill_and_resume(STREAM, 6);
    kill_and_resume(&STREAM.replace("[scheme]", "[scheme]\nshifting = true"), 3);
}

#[test]
#[ignore = "minutes: 200 rounds of a stream, a tube and space"]
fn a_run_killed_two_hundred_times_ends_with_the_same_bits() {
    kill_and_resume(STREAM, 100);
    kill_and_resume(
        &BOX.replace("frames = 2", "frames = 2\ncheckpoint_seconds = 0")
            .replace(
                "[initial",
                "[scheme]\nshield = true\nshifting = true\n[initial",
            ),
        50,
    );
    kill_and_resume(
        &STREAM
            .replace("[scheme]", "[scheme]\nequations = \"paper\"")
            .replace("\"free-stream\"", "\"symmetry\""),
        50,
    );
}

#[test]
fn an_interrupted_run_leaves_a_frame_and_goes_on() {
    let place = Workplace::new();
    let scene = STREAM.replace("frames = 4", "frames = 1");
    place.run(&scene, &["--threads", "1"]).succeeds();
    let mut run = start(&place, "cut", &[]);
    await_checkpoint(&place.path("cut"));
    let signal = Command::new("kill")
        .args(["-INT", &run.id().to_string()])
        .status();
    assert!(signal.unwrap().success());
    assert_eq!(run.wait().unwrap().code(), Some(1));
    let summary = place.json("cut/summary.json");
    let reason = summary["stop_reason"].as_str().unwrap();
    assert!(reason.starts_with("interrupted (step "), "{reason}");
    let frames = std::fs::read_to_string(place.path("cut/run.pvd")).unwrap();
    assert_eq!(frames.matches("<DataSet").count(), 2);

    let answer = place.aero(&["run", "scene.toml", "--out", "cut", "--resume"]);
    answer.succeeds();
    let same = |name: &str| {
        let read = |out: &str| std::fs::read(place.path(&format!("{out}/{name}"))).unwrap();
        assert!(read("results") == read("cut"), "{name} differs");
    };
    same("frame-000001.vtp");
    same("surface-000001.vtp");
    same("history.csv");
    same("run.pvd");
}

#[test]
fn a_finished_run_has_nothing_to_resume() {
    let place = Workplace::new();
    place.run(BOX, &[]).succeeds();
    let answer = place.run(BOX, &["--resume"]);
    answer.succeeds();
    assert!(answer.out.contains("came to its end"), "{}", answer.out);
}

#[test]
fn a_run_that_never_began_starts_from_the_beginning() {
    let place = Workplace::new();
    let answer = place.run(BOX, &["--resume"]);
    answer.succeeds();
    assert!(answer.err.contains("no checkpoint in"), "{}", answer.err);
}

/// A folder with the checkpoint of a run that was killed.
fn killed() -> Workplace {
    let place = Workplace::new();
    place.write("scene.toml", STREAM);
    let mut run = start(&place, "results", &[]);
    await_checkpoint(&place.path("results"));
    run.kill().unwrap();
    run.wait().unwrap();
    place
}

#[test]
fn another_scene_is_not_resumed() {
    let place = killed();
    place
        .run(STREAM, &["--resume", "--set", "free_stream.mach=3"])
        .refuses(&["cannot go on", "mach = 2.0", "mach = 3", "leave out"]);
    // What does not change a bit may change.
    place
        .run(STREAM, &["--resume", "--set", "title=again"])
        .succeeds();
}

#[test]
fn a_damaged_checkpoint_is_refused() {
    let place = killed();
    let path = place.path("results/checkpoint");
    let mut bytes = std::fs::read(&path).unwrap();
    let middle = bytes.len() / 2;
    bytes[middle] ^= 64;
    std::fs::write(&path, bytes).unwrap();
    place
        .run(STREAM, &["--resume"])
        .refuses(&["checkpoint", "damaged", "leave out `--resume`"]);
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_reported_and_the_last_checkpoint_kept() {
    let place = killed();
    // The device that is always full.
    let part = place.path("results/checkpoint.part");
    let _ = std::fs::remove_file(&part);
    std::os::unix::fs::symlink("/dev/full", &part).unwrap();
    let answer = place.run(STREAM, &["--resume"]);
    assert_eq!(answer.status, 1, "{}", answer.err);
    for words in [
        "No space left",
        "checkpoint",
        "go on from it with `--resume`",
    ] {
        assert!(answer.err.contains(words), "{}", answer.err);
    }
    place.run(STREAM, &["--resume"]).succeeds();
    place.write("scene.toml", STREAM);
    let whole = place.aero(&["run", "scene.toml", "--out", "whole", "--threads", "1"]);
    whole.succeeds();
    let read = |name: &str| std::fs::read(place.path(name)).unwrap();
    assert!(read("whole/history.csv") == read("results/history.csv"));
    assert!(read("whole/frame-000004.vtp") == read("results/frame-000004.vtp"));
}

#[test]
fn a_folder_that_cannot_be_is_reported() {
    let place = Workplace::new();
    place.write("scene.toml", BOX);
    place.write("file", "in the way");
    let answer = place.aero(&["run", "scene.toml", "--out", "file/results"]);
    assert_eq!(answer.status, 1);
    assert!(
        answer.err.contains("cannot write `file/results`"),
        "{}",
        answer.err
    );
}
