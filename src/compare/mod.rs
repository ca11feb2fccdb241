//! Compares runs with theory: ties the application to the independent `validation` crate.
//!
//! One file per case, which declares a [`Comparison`](comparison::Comparison): scene, variants, rows,
//! pictures. Exact solutions and metrics are not here.

mod apollo;
pub mod biconvex;
mod comparison;
pub mod cone;
pub mod cylinder;
mod double_mach;
mod nozzle;
mod profiles;
mod report;
mod row;
pub mod scenes;
pub mod sod;
mod sphere;
mod square;
mod stability;
mod step;
mod stress;
mod variant;
mod view;
pub mod wedge;

use std::path::Path;

use aero::run::RunError;
use aero::scene::SceneError;
use aero_validation::metrics::MetricError;
use aero_validation::table::Check;

use comparison::Compare;
pub use variant::Scheme;

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
    /// Told of every run before it starts.
    pub announce: &'a dyn Fn(&str),
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
    #[error("unknown case `{name}`; known are {known}")]
    Unknown {
        /// As typed.
        name: String,
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
    /// The flow does not show what is to be measured.
    #[error(transparent)]
    Metric(#[from] MetricError),
    /// A frame that the next run starts from cannot be written.
    #[error(transparent)]
    Frame(#[from] aero::output::OutputError),
    /// There is no exact solution.
    #[error(transparent)]
    Exact(#[from] aero_validation::exact::ExactError),
    /// The page that holds it all cannot be written.
    #[error("cannot write `{}`: {source}", path.display())]
    Report {
        /// The page.
        path: std::path::PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// A picture cannot be written.
    #[error(transparent)]
    Picture(#[from] aero_validation::pictures::PictureError),
}

/// A case by the name that is typed, and what it compares.
type Case = (&'static str, &'static [&'static dyn Compare]);

/// The cases that run where none is named, in this order.
static CASES: [Case; 11] = [
    ("wedge", &[&wedge::WEDGE]),
    ("sod", &[&sod::SOD]),
    ("cylinder", &[&cylinder::CYLINDER]),
    ("nozzle", &[&nozzle::NOZZLE]),
    ("step", &[&step::FORWARD_STEP]),
    ("double-mach", &[&double_mach::DOUBLE_MACH]),
    ("biconvex", &[&biconvex::BICONVEX]),
    ("square", &[&square::SQUARE]),
    ("cone", &[&cone::CONE]),
    ("sphere", &[&sphere::SPHERE]),
    ("apollo", &[&apollo::QUARTER, &apollo::RINGS]),
];

/// Cases that run only where they are named: they show where the method ends, and some of their rows
/// fail.
static ON_REQUEST: [Case; 6] = [
    (
        "stress",
        &[
            &stress::TUBES,
            &stress::BALLS,
            &stress::SMOOTH,
            &stress::BODIES,
        ],
    ),
    ("stress-tubes", &[&stress::TUBES]),
    ("stress-balls", &[&stress::BALLS]),
    ("stress-smooth", &[&stress::SMOOTH]),
    ("stress-bodies", &[&stress::BODIES]),
    ("stability", &[&stability::Stability]),
];

/// Runs the named cases, all but those on request where none is named, and returns their rows; the page
/// [`report::NAME`] about them grows with every case. A run that stops is a row that fails.
///
/// # Errors
/// A name that is not a case, before anything runs; a scene of the project that is wrong; files that
/// cannot be written.
pub fn compare(names: &[String], context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let all = || CASES.iter().chain(&ON_REQUEST);
    if let Some(name) = names.iter().find(|name| all().all(|case| case.0 != **name)) {
        let known: Vec<&str> = all().map(|(name, _)| *name).collect();
        return Err(CompareError::Unknown {
            name: name.clone(),
            known: known.join(", "),
        });
    }
    let mut checks = Vec::new();
    for (number, (name, comparisons)) in all().enumerate() {
        let is_usual = names.is_empty() && number < CASES.len();
        if is_usual || names.iter().any(|asked| asked == name) {
            for comparison in *comparisons {
                checks.extend(comparison.compare(context)?);
            }
            report::write(&checks, context.level, context.out).map_err(|source| {
                CompareError::Report {
                    path: context.out.join(report::NAME),
                    source,
                }
            })?;
        }
    }
    Ok(checks)
}
