//! What commands that take a scene share: its file, its overrides, its threads, and a case run before a person's eyes.

use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

use aero::case::AnyCase;
use aero::output::Summary;
use aero::run::{Destination, Progress, RunError, Stopwatch, run_any};
use aero::scene::Scene;
use clap::Args;

use super::CommandError;
use super::body::is_body;
use super::interrupt::Interrupt;
use super::progress::Display;

/// A scene as it is typed.
#[derive(Args, Clone, Debug)]
pub struct SceneArgs {
    /// Scene file (TOML)
    pub scene: PathBuf,
    /// Override a value of the scene; may be given many times
    #[arg(long = "set", value_name = "SECTION.KEY=VALUE")]
    set: Vec<String>,
    /// Number of threads; all processors unless given
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub threads: Option<u16>,
}

impl SceneArgs {
    /// The scene with its overrides.
    pub fn load(&self) -> Result<Scene, CommandError> {
        if is_body(&self.scene) {
            return Err(CommandError::wrong(format!(
                "`{0}` is a body, not a scene: `aero fly {0} --mach 2` flies it, `aero pack {0}` packs it, `aero new body` writes a scene to put it in",
                self.scene.display()
            )));
        }
        self.overridden(Scene::load(&self.scene).map_err(CommandError::wrong)?)
    }

    /// `scene` with the overrides.
    pub fn overridden(&self, mut scene: Scene) -> Result<Scene, CommandError> {
        for setting in &self.set {
            scene.set(setting).map_err(CommandError::wrong)?;
        }
        Ok(scene)
    }
}

/// The folder for results: the one that was given, or `out/NAME`.
pub fn folder(given: Option<&PathBuf>, name: &str) -> PathBuf {
    given
        .cloned()
        .unwrap_or_else(|| Path::new("out").join(name))
}

/// The case that a scene means, packed and looked at.
pub fn checked(scene: &Scene) -> Result<AnyCase, CommandError> {
    let case = scene.build_any().map_err(CommandError::wrong)?;
    case.checked().map_err(CommandError::wrong)
}

/// What a scene is, in words, a line each.
pub fn described(scene: &Scene, case: &AnyCase) -> Vec<String> {
    let heading = format!(
        "{}: {} dimensions, spacing {}",
        scene.name(),
        scene.dimension(),
        scene.file().spacing.get()
    );
    let lines = case.description();
    let lines = lines.iter().map(|line| format!("  {line}"));
    std::iter::once(heading).chain(lines).collect()
}

/// Tells what was mended in the bodies, and what the user should know.
pub fn tell(case: &AnyCase) {
    for line in case.remarks() {
        note!("{line}");
    }
}

/// Runs a case with its progress shown, until an interrupt or until `is_late` says so; once it is under way `words` are said.
///
/// # Errors
/// As of [`run_any`].
pub fn run_watched(
    case: AnyCase,
    destination: Destination<'_>,
    stopwatch: Stopwatch,
    interrupt: &Interrupt,
    words: &[String],
    is_late: &mut dyn FnMut(Progress) -> bool,
) -> Result<Summary, RunError> {
    let mut display = Display::of_run();
    let mut words = words.iter();
    let result = run_any(case, destination, stopwatch, &mut |progress| {
        interrupt.hold(true);
        for line in words.by_ref() {
            note!("{line}");
        }
        display.show(progress);
        if is_late(progress) {
            ControlFlow::Break(())
        } else {
            interrupt.wish()
        }
    });
    interrupt.hold(false);
    display.finish();
    result
}
