//! How much is compared, and why it may fail.

use std::path::Path;

use aero::run::RunError;
use aero::scene::SceneError;
use aero_validation::metrics::MetricError;
use aero_validation::table::Check;

/// How much to run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// Minutes in all.
    Quick,
    /// At the published resolution, every variant.
    Full,
}

/// What a case gets.
pub struct Context<'a> {
    /// How much to run.
    pub level: Level,
    /// Settings of every run (`section.key=value`), on top of its own.
    pub settings: &'a [String],
    /// Folder for pictures.
    pub out: &'a Path,
    /// Told of every run before it starts, by whichever thread starts it.
    pub announce: &'a (dyn Fn(&str) + Sync),
}

impl Context<'_> {
    /// What is said of a run called `label`, which has more settings than its own.
    pub fn called(&self, label: String) -> String {
        if self.settings.is_empty() {
            label
        } else {
            format!("{label}, with {}", self.settings.join(" "))
        }
    }

    /// Says so in a row, too, that does not yet.
    pub fn name(&self, check: &mut Check) {
        let with = self.called(String::new());
        if !check.quantity.contains(&with) {
            check.quantity += &with;
        }
    }
}

impl std::fmt::Debug for Context<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Context")
            .field("level", &self.level)
            .finish_non_exhaustive()
    }
}

/// Why a comparison could not be made.
#[derive(Debug, thiserror::Error)]
pub enum CompareError {
    /// No such case.
    #[error("unknown case `{name}`{hint}; known are {known}")]
    Unknown {
        /// As typed.
        name: String,
        /// What may have been meant.
        hint: String,
        /// All names.
        known: String,
    },
    /// A scene of the project is wrong.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// A run stopped.
    #[error("scene `{scene}` with {settings}: {source}")]
    Run {
        /// Name of the scene.
        scene: String,
        /// What was set on top of it.
        settings: String,
        /// Why.
        source: Box<RunError>,
    },
    /// The program, run as it would be typed, failed.
    #[error("`aero {typed}` failed: {reason}")]
    Program {
        /// What was typed.
        typed: String,
        /// What it said.
        reason: String,
    },
    /// What the program wrote cannot be read.
    #[error("cannot read `{}`: {reason}", path.display())]
    Unreadable {
        /// The file.
        path: std::path::PathBuf,
        /// Why.
        reason: String,
    },
    /// The flow does not show what is to be measured.
    #[error(transparent)]
    Metric(#[from] MetricError),
    /// A frame that the next run starts from cannot be written.
    #[error(transparent)]
    Frame(#[from] aero::output::OutputError),
    /// There is no exact solution.
    #[error(transparent)]
    Exact(#[from] aero_validation::exact::ExactError),
    /// A page, or what the program is to be given, cannot be written.
    #[error("cannot write `{}`: {source}", path.display())]
    Report {
        /// The file.
        path: std::path::PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// A shape that the project makes is none.
    #[error(transparent)]
    Geometry(#[from] aero_geometry::GeometryError),
    /// A shape that the project makes cannot be packed.
    #[error(transparent)]
    Pack(#[from] aero_packer::PackError),
    /// The table of quick limits is wrong.
    #[error("validation/quick-limits.json: {0}")]
    Limits(#[from] serde_json::Error),
    /// A picture cannot be written.
    #[error(transparent)]
    Picture(#[from] aero_validation::pictures::PictureError),
}
