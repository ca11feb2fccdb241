//! Kills at any moment.

use std::collections::BTreeMap;
use std::path::Path;
use std::time::{Duration, Instant, SystemTime};

use super::{STREAM, assert_same, start};
use crate::support::{BOX, Workplace};

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
