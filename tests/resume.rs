//! A run that was stopped goes on as if it never had been: same bits in every frame, every row of
//! the history, whatever stopped it.

mod support;

use std::collections::BTreeMap;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant, SystemTime};

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

/// `STREAM`, four times as long: a kill must have something to hit.
fn long_stream() -> String {
    STREAM.replace("end_time = 0.25", "end_time = 1.0")
}

/// What kills met.
#[derive(Clone, Copy, Debug, Default)]
struct Hits {
    /// Runs begun anew that had no checkpoint yet.
    before_the_first_checkpoint: u32,
    /// Runs gone on with that had written nothing yet.
    while_reading: u32,
    /// Runs between two files.
    while_stepping: u32,
    /// Runs in the midst of one, or of several.
    while_writing: u32,
    /// Runs whose last frame was there.
    at_the_end: u32,
    /// Runs that had come to their end by then.
    too_late: u32,
}

impl Hits {
    /// Runs that had a checkpoint and had got beyond where they began.
    fn count(&self) -> u32 {
        self.while_stepping + self.while_writing + self.at_the_end
    }
}

/// When each file of a run was last written.
fn written(folder: &Path) -> BTreeMap<String, SystemTime> {
    let Ok(entries) = std::fs::read_dir(folder) else {
        return BTreeMap::new();
    };
    // A file may go while its folder is read.
    entries
        .filter_map(|entry| {
            let entry = entry.ok()?;
            let name = entry.file_name().to_string_lossy().into_owned();
            Some((name, entry.metadata().ok()?.modified().ok()?))
        })
        .collect()
}

/// The last step in the history that the checkpoint in `folder` goes on from; none without one.
fn checkpointed_step(folder: &Path) -> Option<u64> {
    let bytes = std::fs::read(folder.join("checkpoint")).ok()?;
    let header = bytes.iter().position(|&byte| byte == b'\n').unwrap();
    // The scene, the times of the frames, the length of the history; the rest is the solver's.
    let start: (String, Vec<f64>, u64) = postcard::take_from_bytes(&bytes[header + 1..]).unwrap().0;
    let history = std::fs::read_to_string(folder.join("history.csv")).unwrap();
    let kept = &history[..usize::try_from(start.2).unwrap()];
    assert!(kept.ends_with('\n'), "the history is cut within a row");
    let last = kept.lines().last().unwrap();
    Some(last.split(',').next().unwrap().parse().unwrap_or(0))
}

/// Runs `scene` once in one go, and over and over with kills at odd moments, until `kills` of them have
/// hit a run that had a checkpoint and had got beyond it; then to its end.
fn kill_and_resume(scene: &str, kills: u32) -> Hits {
    let place = Workplace::new();
    place.run(scene, &["--threads", "1"]).succeeds();
    let frames = written(&place.path("results")).into_keys();
    let last_frame = frames.filter(|name| name.starts_with("frame-")).max();
    let last_frame = last_frame.unwrap();
    let whole = Instant::now();
    assert!(start(&place, "timed", &[]).wait().unwrap().success());
    let whole = whole.elapsed();

    let folder = place.path("killed");
    let mut hits = Hits::default();
    let mut step = None;
    for round in 1.. {
        if hits.count() == kills {
            break;
        }
        assert!(round < 10 * kills + 50, "too few kills hit: {hits:?}");
        let before = written(&folder);
        let is_new = |name: &str| {
            let now = written(&folder).remove(name);
            now.is_some() && now.as_ref() != before.get(name)
        };
        let mut run = start(&place, "killed", &["--resume"]);
        // The golden ratio spreads the moments evenly, whatever their number.
        let part = (f64::from(round) * 0.618_033_988_75).fract();
        if round % 6 == 0 {
            // The end is short: it must be waited for.
            while !is_new(&last_frame) && run.try_wait().unwrap().is_none() {
                std::thread::sleep(Duration::from_micros(100));
            }
            std::thread::sleep(Duration::from_secs_f64(0.003 * part));
        } else {
            std::thread::sleep(whole.mul_f64(0.5 * part));
        }
        run.kill().expect("the run is mine to kill");
        let status = run.wait().expect("the run ends");
        assert!(status.code().is_none() || status.success(), "{status}");

        let has_checkpoint = folder.join("checkpoint").exists();
        if !has_checkpoint && folder.join("summary.json").exists() {
            hits.too_late += 1;
            assert_same(&place, "results", "killed");
            std::fs::remove_dir_all(&folder).unwrap();
            step = None;
            continue;
        }
        assert!(status.code().is_none(), "it ended without its summary");
        let now = checkpointed_step(&folder);
        assert!(now >= step, "step {step:?} was lost, {now:?} is left");
        let parts = written(&folder).into_keys();
        let mut parts = parts.filter(|name| {
            Path::new(name)
                .extension()
                .is_some_and(|ending| ending == "part")
        });
        let hit = if !has_checkpoint {
            &mut hits.before_the_first_checkpoint
        } else if is_new(&last_frame) {
            &mut hits.at_the_end
        } else if parts.any(|name| is_new(&name)) {
            &mut hits.while_writing
        } else if now > step {
            &mut hits.while_stepping
        } else {
            &mut hits.while_reading
        };
        *hit += 1;
        step = now;
    }
    let mut last = start(&place, "killed", &["--resume"]);
    assert!(last.wait().unwrap().success());
    assert_same(&place, "results", "killed");
    println!("{hits:?}");
    hits
}

#[test]
fn a_run_killed_a_few_times_ends_with_the_same_bits() {
    kill_and_resume(&long_stream(), 6);
    kill_and_resume(
        &long_stream().replace("[scheme]", "[scheme]\nshifting = true"),
        3,
    );
}

#[test]
#[ignore = "half a minute: 200 kills of a stream, a tube and the published scheme"]
fn a_run_killed_two_hundred_times_ends_with_the_same_bits() {
    let scenes = [
        (long_stream(), 100),
        (
            BOX.replace("end_time = 0.02", "end_time = 1.0")
                .replace("frames = 2", "frames = 2\ncheckpoint_seconds = 0")
                .replace(
                    "[initial",
                    "[scheme]\nshield = true\nshifting = true\n[initial",
                ),
            50,
        ),
        (
            long_stream()
                .replace("[scheme]", "[scheme]\nequations = \"paper\"")
                .replace("\"free-stream\"", "\"symmetry\""),
            50,
        ),
    ];
    for (scene, kills) in scenes {
        let hits = kill_and_resume(&scene, kills);
        // Evenly spread moments find all of these.
        assert!(hits.while_stepping > 0, "{hits:?}");
        assert!(hits.while_writing > 0, "{hits:?}");
        assert!(hits.at_the_end > 0, "{hits:?}");
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
