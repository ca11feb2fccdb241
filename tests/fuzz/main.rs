//! Scenes from hell: whatever is in the file, there is an answer in time, and never a panic.
//!
//! Mutations of every scene in `cases/` are read, built and, where they are small, run for a step.
//! The same seed gives the same scenes.

mod mutate;
mod scenes;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::{Arc, Mutex, mpsc};
use std::time::{Duration, Instant};

use cpu_time::ProcessTime;

use mutate::{Dice, NUMBERS, mutate};
use scenes::{Fate, scenes, try_scene};

/// Longest time for an answer.
const LIMIT: Duration = Duration::from_secs(2);

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
