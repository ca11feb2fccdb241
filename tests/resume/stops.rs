//! Signals, full disks, damaged checkpoints, other scenes, and runs with nothing to go on from.

use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};

use super::{STREAM, start};
use crate::support::{BOX, Workplace};

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

/// Waits until a process takes SIGTERM itself.
#[cfg(target_os = "linux")]
fn await_listening(id: u32) {
    const SIGTERM: u64 = 1 << (15 - 1);
    let caught = || {
        let status = std::fs::read_to_string(format!("/proc/{id}/status")).unwrap_or_default();
        let line = status.lines().find_map(|line| line.strip_prefix("SigCgt:"));
        line.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok())
    };
    let start = Instant::now();
    while caught().is_none_or(|mask| mask & SIGTERM == 0) {
        assert!(start.elapsed() < Duration::from_secs(60), "deaf");
        std::thread::sleep(Duration::from_millis(1));
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_signal_during_set_up_ends_the_run_at_once() {
    // Packing these takes many seconds, and the flow would need no more memory than small machines have.
    let scene = STREAM
        .replace("dimension = 2", "dimension = 3")
        .replace("spacing = 0.05", "spacing = 0.008")
        .replace("min = [0.0, 0.0]", "min = [0.0, 0.0, 0.0]")
        .replace("max = [1.0, 0.5]", "max = [1.0, 0.5, 1.0]")
        .replace(
            "y_max =",
            "z_min = \"free-stream\"\nz_max = \"free-stream\"\ny_max =",
        )
        .replace("circle = { radius = 0.1 }", "sphere = { radius = 0.2 }")
        .replace("[0.5, 0.25]", "[0.5, 0.25, 0.5]")
        .replace("motion = {", "# motion = {");
    for signal in ["-TERM", "-INT"] {
        let place = Workplace::new();
        place.write("scene.toml", &scene);
        let run = Command::new(env!("CARGO_BIN_EXE_aero"))
            .current_dir(place.path(""))
            .args(["run", "scene.toml", "--threads", "1", "--out", "cut"])
            .stderr(std::process::Stdio::piped())
            .spawn()
            .expect("the program runs");
        let id = run.id();
        await_listening(id);
        let sent = Command::new("kill")
            .args([signal, &id.to_string()])
            .status();
        assert!(sent.unwrap().success());
        let answer = run.wait_with_output().unwrap();
        let said = String::from_utf8_lossy(&answer.stderr);
        assert_eq!(answer.status.code(), Some(1), "{signal}: {said}");
        assert!(said.contains("interrupted while setting up"), "{said}");
        assert!(!place.path("cut/history.csv").exists());
    }
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
    let part = place.path("results/checkpoint-0.part");
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
