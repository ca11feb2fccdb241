//! The scenes of `cases/`, compiled in so that `aero validate` works from any folder, and one run of
//! them.

use std::path::Path;

use aero::output::Summary;
use aero::run::{Keep, Outcome, RunError, Stopwatch, run_in_memory};
use aero::scene::Scene;

use super::context::{CompareError, Context};

/// A scene of the project, by name and text.
#[derive(Clone, Copy, Debug)]
pub struct Source {
    /// Name of the file without its ending.
    pub name: &'static str,
    /// The file.
    pub text: &'static str,
}

/// The scene `cases/NAME.toml`, or `cases/FOLDER/NAME.toml`.
macro_rules! scene {
    ($name:literal) => {
        $crate::scenes::Source {
            name: $name,
            text: include_str!(concat!(
                env!("CARGO_MANIFEST_DIR"),
                "/../../cases/",
                $name,
                ".toml"
            )),
        }
    };
    ($folder:literal, $name:literal) => {
        $crate::scenes::Source {
            name: $name,
            text: include_str!(concat!(
                env!("CARGO_MANIFEST_DIR"),
                "/../../cases/",
                $folder,
                "/",
                $name,
                ".toml"
            )),
        }
    };
}
pub(crate) use scene;

impl Source {
    /// The scene with `settings` (`section.key=value`) on top.
    pub fn scene(self, settings: &[String]) -> Result<Scene, CompareError> {
        let mut scene = Scene::parse(self.text, self.name, Path::new(""))?;
        for setting in settings {
            scene.set(setting)?;
        }
        Ok(scene)
    }

    /// Runs the scene with `settings`, and those of the `context` on top of them.
    pub fn run(
        self,
        settings: &[String],
        keep: Keep,
        context: &Context<'_>,
    ) -> Result<Outcome, CompareError> {
        let settings = [settings, context.settings].concat();
        let scene = self.scene(&settings)?;
        (context.announce)(&format!("{}: {}", self.name, settings.join(" ")));
        let stopwatch = Stopwatch::start();
        run_in_memory(scene.build_any()?, keep, stopwatch).map_err(|error| CompareError::Run {
            scene: self.name.into(),
            settings: settings.join(" "),
            source: Box::new(error),
        })
    }

    /// As [`Self::run`]; only a scene that is wrong is an error.
    pub fn attempt(
        self,
        settings: &[String],
        context: &Context<'_>,
    ) -> Result<Attempt, CompareError> {
        match self.run(settings, Keep::End, context) {
            Ok(outcome) => Ok(Attempt::Ended(Box::new(outcome))),
            Err(CompareError::Run {
                scene,
                settings,
                source,
            }) => match *source {
                RunError::Stopped { reason, summary } => Ok(Attempt::Stopped(reason, summary)),
                other => Err(CompareError::Run {
                    scene,
                    settings,
                    source: Box::new(other),
                }),
            },
            Err(error) => Err(error),
        }
    }
}

/// A run that came to its end or did not.
#[derive(Debug)]
pub enum Attempt {
    /// It did.
    Ended(Box<Outcome>),
    /// It stopped, and why.
    Stopped(String, Box<Summary>),
}

impl Attempt {
    /// The summary of the run, however it ended.
    pub fn summary(&self) -> &Summary {
        match self {
            Self::Ended(outcome) => &outcome.summary,
            Self::Stopped(_, summary) => summary,
        }
    }

    /// The outcome of a run that came to its end.
    pub fn outcome(&self) -> Option<&Outcome> {
        match self {
            Self::Ended(outcome) => Some(outcome),
            Self::Stopped(..) => None,
        }
    }
}
