//! The scenes that are changed, and what becomes of one.

use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

use aero::run::{Destination, RunError, Stopwatch, run_any};
use aero::scene::{Scene, SceneError};

/// Scenes that hold more are not packed and run: they may take longer, and rightly so.
const SMALL: f64 = 5000.0;

/// Whether the memory of any machine would have to refuse it.
const ABSURD: f64 = 1e11;

/// All scenes of the project, made so coarse that each takes moments.
pub fn scenes() -> Vec<String> {
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

/// What became of a scene.
#[derive(Debug)]
pub enum Fate {
    Refused(String),
    Ran,
    TooLarge,
}

pub fn try_scene(text: &str, setting: Option<&str>, folder: &Path) -> Result<Fate, SceneError> {
    let mut scene = Scene::parse(text, "fuzz", Path::new(""))?;
    if let Some(setting) = setting {
        scene.set(setting)?;
    }
    let size = size(&scene);
    if (SMALL..ABSURD).contains(&size) {
        return Ok(Fate::TooLarge);
    }
    let case = scene.build_any()?;
    let place = Destination {
        folder,
        scene: "",
        noted: "",
        resume: false,
        skips_start: false,
        overwrite: true,
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
