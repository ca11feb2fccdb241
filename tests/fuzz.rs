//! Scenes from hell: whatever is in the file, there is an answer in time, and never a panic.
//!
//! Mutations of every scene in `cases/` are read, built and, where they are small, run for a step.
//! The same seed gives the same scenes.

use std::ops::ControlFlow;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, mpsc};
use std::time::{Duration, Instant};

use aero::run::{Place, RunError, Stopwatch, run_any};
use aero::scene::{Scene, SceneError};
use cpu_time::ProcessTime;

/// Longest time for an answer.
const LIMIT: Duration = Duration::from_secs(2);

/// Scenes that hold more are not packed and run: they may take longer, and rightly so.
const SMALL: f64 = 5000.0;

/// Values that a number may be replaced with.
const NUMBERS: [&str; 26] = [
    "0",
    "-1",
    "1",
    "2",
    "3",
    "4",
    "0.0",
    "-0.0",
    "1e-3",
    "-1e-3",
    "0.3333333333333333",
    "1e-300",
    "1e300",
    "-1e300",
    "1e12",
    "1e-12",
    "1e150",
    "nan",
    "inf",
    "-inf",
    "9223372036854775807",
    "99999999999999999999",
    "360",
    "-90.0",
    "0.5",
    "1000000",
];

/// What else may stand in the place of a value.
const VALUES: [&str; 18] = [
    "\"\"",
    "true",
    "[]",
    "{}",
    "[1.0]",
    "[0.0, 0.0]",
    "[0.0, 0.0, 0.0]",
    "[nan, 1.0]",
    "\"wall\"",
    "\"inlet\"",
    "\"outlet\"",
    "\"periodic\"",
    "\"symmetry\"",
    "\"free-stream\"",
    "\"body\"",
    "\"no-slip\"",
    "1979-05-27",
    "\"1 / (x - x)\"",
];

/// Lines that may come in anywhere.
const LINES: [&str; 17] = [
    "spacing = 10.0",
    "wall = \"no-slip\"",
    "place = { scale = 1000.0 }",
    "place = { translate = [0.1, 0.1] }",
    "place = { scale = 1e-9 }",
    "place = { rotate = 1e9 }",
    "motion = { velocity = [1e9, 0.0] }",
    "motion = { angular_velocity = 1e6 }",
    "name = \"😀 näme\"",
    "disorder = 0.49",
    "shield = true",
    "shifting = true",
    "[[body]]\nname = \"again\"\nshape = { circle = { radius = 0.3 } }",
    "[[body]]\nname = \"flat\"\nshape = { rectangle = { size = [1.0, 1e-12] } }",
    "[[body]]\nname = \"ball\"\nshape = { sphere = { radius = 100.0 } }",
    "[initial.field]\ndensity = \"sin(40 * x)\"\npressure = \"exp(900 * x)\"",
    "[initial.riemann]\nposition = 0.5\nleft = { density = 1, pressure = 1e9 }\nright = { density = 1e-9, pressure = 1 }",
];

/// A generator of numbers (`SplitMix64`, Steele, Lea & Flood 2014).
struct Dice(u64);

impl Dice {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number below `sides`, zero where there are none.
    fn throw(&mut self, sides: usize) -> usize {
        (self.next() % sides.max(1) as u64) as usize
    }

    fn choose<'a>(&mut self, from: &[&'a str]) -> &'a str {
        from[self.throw(from.len())]
    }
}

/// Byte ranges of all numbers in a text.
fn numbers(text: &str) -> Vec<(usize, usize)> {
    let mut found = Vec::new();
    let bytes = text.as_bytes();
    let mut at = 0;
    while at < bytes.len() {
        let first = bytes[at].is_ascii_digit() && (at == 0 || b" [=-,(".contains(&bytes[at - 1]));
        if !first {
            at += 1;
            continue;
        }
        let rest = &bytes[at..];
        let end = rest
            .iter()
            .position(|b| !(b.is_ascii_digit() || b".eE".contains(b)))
            .unwrap_or(rest.len());
        found.push((at, at + end));
        at += end;
    }
    found
}

/// One mutation of a scene's text.
fn mutate(text: &str, dice: &mut Dice) -> String {
    if text.is_empty() {
        return dice.choose(&LINES).into();
    }
    let lines: Vec<&str> = text.lines().collect();
    let line = dice.throw(lines.len());
    let joined = |lines: Vec<&str>| lines.join("\n") + "\n";
    match dice.throw(12) {
        0..=3 => {
            let found = numbers(text);
            let Some(&(from, to)) = found.get(dice.throw(found.len())) else {
                return text.into();
            };
            format!("{}{}{}", &text[..from], dice.choose(&NUMBERS), &text[to..])
        }
        4 | 5 => match lines[line].split_once('=') {
            Some((key, _)) => {
                let changed = format!("{key}= {}", dice.choose(&VALUES));
                let mut lines = lines.clone();
                lines[line] = &changed;
                joined(lines)
            }
            None => text.into(),
        },
        6 => {
            let mut lines = lines;
            lines.remove(line);
            joined(lines)
        }
        7 => {
            let mut lines = lines.clone();
            lines.insert(line, lines[dice.throw(lines.len())]);
            joined(lines)
        }
        8 | 9 => {
            let mut lines = lines;
            lines.insert(line + dice.throw(2), dice.choose(&LINES));
            joined(lines)
        }
        10 => {
            // A character comes, goes or changes; now and then a very long word.
            let mut characters: Vec<char> = text.chars().collect();
            let at = dice.throw(characters.len());
            match dice.throw(4) {
                0 => {
                    characters.remove(at);
                }
                1 => characters.insert(
                    at,
                    dice.choose(&["é", "=", "\"", "[", "\0", "-", "😀"])
                        .chars()
                        .next()
                        .unwrap_or(' '),
                ),
                2 => characters[at] = char::from(b'!' + dice.throw(90) as u8),
                _ => {
                    let word = "x".repeat(1 << dice.throw(16));
                    characters.splice(at..at, word.chars());
                }
            }
            characters.into_iter().collect()
        }
        _ => {
            let at = dice.throw(text.len());
            text.get(..at).unwrap_or(text).into()
        }
    }
}

/// All scenes of the project, made so coarse that each takes moments.
fn scenes() -> Vec<String> {
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases");
    let mut paths: Vec<PathBuf> = [cases.clone(), cases.join("stress")]
        .iter()
        .flat_map(|folder| std::fs::read_dir(folder).expect("a folder of scenes"))
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|ending| ending == "toml"))
        .collect();
    paths.sort();
    let coarse = |path: &PathBuf| {
        let mut scene = Scene::load(path).expect("a scene of the project");
        let text = std::fs::read_to_string(path).expect("a scene of the project");
        let first = scene.file().spacing.get();
        let mut spacing = first;
        while size(&scene) > 0.3 * SMALL && spacing < 16.0 * first {
            spacing *= 2.0;
            scene.set(&format!("spacing={spacing}")).expect("a spacing");
        }
        let old = format!("spacing = {first}");
        assert!(text.contains(&old), "{}", path.display());
        text.replacen(&old, &format!("spacing = {spacing}"), 1)
    };
    paths.iter().map(coarse).collect()
}

/// About how many particles a scene holds, its bodies' ghosts counted roughly.
fn size(scene: &Scene) -> f64 {
    let file = scene.file();
    let spacing = file.spacing.get();
    let widths = || file.domain.min.iter().zip(&file.domain.max);
    let cells = |dx: f64| -> f64 {
        widths()
            .map(|(a, b)| (b.get() - a.get()) / dx + 12.0)
            .product()
    };
    let finest = file.body.iter().filter_map(|body| body.spacing);
    let finest = finest.fold(spacing, |least, own| own.get().min(least));
    cells(spacing).max(cells(finest) * 0.1)
}

/// Whether the memory of any machine would have to refuse it.
const ABSURD: f64 = 1e11;

/// What became of a scene.
#[derive(Debug)]
enum Fate {
    Refused(String),
    Ran,
    TooLarge,
}

fn try_scene(text: &str, setting: Option<&str>, folder: &Path) -> Result<Fate, SceneError> {
    let mut scene = Scene::parse(text, "fuzz", Path::new(""))?;
    if let Some(setting) = setting {
        scene.set(setting)?;
    }
    let size = size(&scene);
    if (SMALL..ABSURD).contains(&size) {
        return Ok(Fate::TooLarge);
    }
    let case = scene.build_any()?;
    let place = Place {
        folder,
        scene: "",
        resume: false,
    };
    let mut stop = |_| ControlFlow::Break(());
    Ok(match run_any(case, place, Stopwatch::start(), &mut stop) {
        Err(RunError::Stopped { reason, .. }) if !reason.starts_with("interrupted") => {
            Fate::Refused(reason)
        }
        Ok(_) | Err(RunError::Stopped { .. }) => Fate::Ran,
        Err(error) => Fate::Refused(error.to_string()),
    })
}

/// Whether a refusal says what is wrong and where: a line of the file, a key or a body in backticks, or
/// the particle at which a run went wrong.
fn tells_its_cause(reason: &str) -> bool {
    let names_place =
        reason.contains('`') || reason.contains("line ") || reason.contains("particle");
    names_place && reason.len() > 30
}

/// Tries so many scenes; a scene that panics, hangs or is refused without a word fails the test.
fn fuzz(rounds: usize, seed: u64) {
    let place = Arc::new(Mutex::new(String::new()));
    let noted = Arc::clone(&place);
    std::panic::set_hook(Box::new(move |panic| {
        *noted.lock().expect("no panic in here") = panic.to_string();
    }));
    let scenes = scenes();
    let (tell, told) = mpsc::channel::<(String, Option<Result<(Fate, Duration), String>>)>();
    let worker = std::thread::spawn(move || {
        let mut dice = Dice(seed);
        let folder = tempfile::tempdir().expect("a temporary folder");
        for round in 0..rounds {
            let mut text = scenes[round % scenes.len()].clone();
            for _ in 0..=dice.throw(3) {
                text = mutate(&text, &mut dice);
            }
            let setting = (dice.throw(8) == 0).then(|| {
                let key = [
                    "spacing",
                    "domain.max.0",
                    "body.0.spacing",
                    "gas.gamma",
                    "a.b",
                    "",
                ];
                format!("{}={}", dice.choose(&key), dice.choose(&NUMBERS))
            });
            let shown = format!("{text}\n# --set {setting:?}");
            if tell.send((shown.clone(), None)).is_err() {
                return;
            }
            let (start, cpu) = (Instant::now(), ProcessTime::now());
            let tried = catch_unwind(AssertUnwindSafe(|| {
                try_scene(&text, setting.as_deref(), folder.path())
            }));
            // Others on the machine may slow the clock, and threads hurry the processor's.
            let elapsed = start.elapsed().min(cpu.elapsed());
            let answer = match tried {
                Ok(Ok(fate)) => Ok((fate, elapsed)),
                Ok(Err(error)) => Ok((Fate::Refused(error.to_string()), elapsed)),
                Err(_) => Err(place.lock().expect("a message").clone()),
            };
            if tell.send((shown, Some(answer))).is_err() {
                return;
            }
        }
    });
    let mut counts = [0; 3];
    let (mut slowest, mut whole) = (Duration::ZERO, Duration::ZERO);
    let mut current = String::new();
    let mut faults = Vec::new();
    // Several times the limit: a machine may be busy, but not for ever.
    while let Ok((text, answer)) = told.recv_timeout(15 * LIMIT) {
        match answer {
            None => current = text,
            Some(Err(panic)) => faults.push((panic, text)),
            Some(Ok((fate, elapsed))) => {
                slowest = slowest.max(elapsed);
                whole += elapsed;
                current.clear();
                if elapsed > LIMIT {
                    faults.push((format!("took {elapsed:?}: {fate:?}"), text.clone()));
                }
                match fate {
                    Fate::Refused(reason) if !tells_its_cause(&reason) => {
                        faults.push((format!("refused with `{reason}`"), text));
                    }
                    Fate::Refused(_) => counts[0] += 1,
                    Fate::Ran => counts[1] += 1,
                    Fate::TooLarge => counts[2] += 1,
                }
            }
        }
    }
    let _ = std::panic::take_hook();
    if current.is_empty() {
        worker.join().expect("the worker came to its end");
    } else {
        faults.push(("hangs".into(), current));
    }
    println!(
        "refused {}, ran {}, too large {}; {whole:.0?} of processor time, slowest {slowest:.2?}",
        counts[0], counts[1], counts[2]
    );
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("fuzz");
    std::fs::create_dir_all(&folder).expect("a folder for faults");
    for (number, (fault, text)) in faults.iter().enumerate() {
        let path = folder.join(format!("{number}.toml"));
        std::fs::write(&path, text).expect("a file for a fault");
        eprintln!("{}: {}", path.display(), fault.replace('\n', " "));
    }
    assert!(faults.is_empty(), "{} faults", faults.len());
    assert!(
        counts[0] > rounds / 4 && counts[1] > rounds / 50,
        "{counts:?}"
    );
}

#[test]
fn a_thousand_scenes_from_hell_are_answered_in_time() {
    fuzz(1000, 1);
}

#[test]
#[ignore = "five minutes of processor time: 100 000 scenes"]
fn a_hundred_thousand_scenes_from_hell_are_answered_in_time() {
    let seed = std::env::var("AERO_FUZZ_SEED")
        .ok()
        .and_then(|seed| seed.parse().ok());
    let rounds = std::env::var("AERO_FUZZ_ROUNDS")
        .ok()
        .and_then(|n| n.parse().ok());
    fuzz(rounds.unwrap_or(100_000), seed.unwrap_or(2));
}
