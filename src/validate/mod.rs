//! Runs cases and compares them with theory: ties the solver to the independent `validation` crate.
//!
//! One file per case. A case runs its scene of `cases/` in several variants and returns rows of the
//! table; exact solutions and metrics are not here.

mod apollo;
pub(crate) mod biconvex;
pub(crate) mod cone;
pub(crate) mod cylinder;
mod double_mach;
mod nozzle;
pub(crate) mod outcome;
pub mod report;
pub(crate) mod sod;
mod sphere;
mod square;
mod stability;
mod step;
mod stress;
pub(crate) mod wedge;

use std::path::Path;

use aero_validation::metrics::MetricError;
use aero_validation::table::{Check, Subject};

use crate::run::RunError;
use crate::scene::SceneError;

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
pub enum ValidateError {
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
    #[error("case `{case}` with {variant}: {source}")]
    Run {
        /// Name of the case.
        case: String,
        /// What was varied.
        variant: String,
        /// Why.
        source: Box<RunError>,
    },
    /// The flow does not show what is to be measured.
    #[error("case `{case}`: {source}")]
    Metric {
        /// Name of the case.
        case: String,
        /// Why.
        source: MetricError,
    },
    /// A frame that the next run starts from cannot be written.
    #[error(transparent)]
    Frame(#[from] crate::output::OutputError),
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

type Comparison = fn(&Context<'_>) -> Result<Vec<Check>, ValidateError>;

/// Cases that run only where they are named: they show where the method ends, and some of their rows
/// fail.
const ON_REQUEST: [(&str, Comparison); 6] = [
    ("stress", stress::compare),
    ("stress-tubes", stress::tubes),
    ("stress-balls", stress::balls),
    ("stress-smooth", stress::smooth),
    ("stress-bodies", stress::bodies),
    ("stability", stability::compare),
];

/// All other cases, in the order in which they run.
const CASES: [(&str, Comparison); 11] = [
    ("wedge", wedge::compare),
    ("sod", sod::compare),
    ("cylinder", cylinder::compare),
    ("nozzle", nozzle::compare),
    ("step", step::compare),
    ("double-mach", double_mach::compare),
    ("biconvex", biconvex::compare),
    ("square", square::compare),
    ("cone", cone::compare),
    ("sphere", sphere::compare),
    ("apollo", apollo::compare),
];

/// Runs the named cases, all but those on request where none is named, and returns their rows; the page
/// [`report::NAME`] about them grows with every case. A run that stops is a row that fails.
///
/// # Errors
/// A name that is not a case, before anything runs; a scene of the project that is wrong; files that
/// cannot be written.
pub fn validate(names: &[String], context: &Context<'_>) -> Result<Vec<Check>, ValidateError> {
    let all = || CASES.iter().chain(&ON_REQUEST);
    if let Some(name) = names.iter().find(|name| all().all(|case| case.0 != **name)) {
        let known: Vec<&str> = all().map(|(name, _)| *name).collect();
        return Err(ValidateError::Unknown {
            name: name.clone(),
            known: known.join(", "),
        });
    }
    let mut checks = Vec::new();
    for (number, (name, compare)) in all().enumerate() {
        let usual = names.is_empty() && number < CASES.len();
        if usual || names.iter().any(|asked| asked == name) {
            match compare(context) {
                Ok(rows) => checks.extend(rows),
                Err(error @ (ValidateError::Run { .. } | ValidateError::Metric { .. })) => {
                    let what = error.to_string();
                    checks.push(Subject::new(name, &what, "a run to its end").unmeasured(0.0));
                }
                Err(error) => return Err(error),
            }
            report::write(&checks, context.level, context.out).map_err(|source| {
                ValidateError::Report {
                    path: context.out.join(report::NAME),
                    source,
                }
            })?;
        }
    }
    Ok(checks)
}
