//! Signals, full disks, damaged checkpoints, other scenes, and runs with nothing to go on from.

use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};

use crate::support::{BOX, Workplace};
use crate::{STREAM, start};

/// Waits until a checkpoint is there.
fn await_checkpoint(folder: &Path) {
    let start = Instant::now();
    while !folder.join("checkpoint").exists() {
        assert!(start.elapsed() < Duration::from_secs(60), "no checkpoint");
        std::thread::sleep(Duration::from_millis(1));
    }
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
