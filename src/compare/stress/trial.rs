//! One run that may stop: the rows that every such run gets, and its own.

use aero::run::Outcome;
use aero_validation::table::Check;

use crate::context::{CompareError, Context};
use crate::row::{Heading, Row};
use crate::scenes::{Attempt, Source};
use crate::variant::Scheme;

/// Largest drift of mass, momentum and energy: what is left when no law loses anything but the
/// time step's error.
const DRIFT: f64 = 1e-3;

/// One run.
#[derive(Clone, Debug)]
pub struct Trial {
    /// What is run.
    pub scene: Source,
    /// Name of the case.
    pub case: String,
    /// What stands before each quantity.
    pub label: String,
    /// By which scheme; rows of the published one only inform.
    pub scheme: Scheme,
    /// What is set beside it.
    pub settings: Vec<String>,
}

impl Trial {
    /// A run of the scene as it is, under its name.
    pub fn new(scene: Source, scheme: Scheme) -> Self {
        Self {
            scene,
            case: scene.name.to_owned(),
            label: scheme.to_string(),
            scheme,
            settings: Vec::new(),
        }
    }

    /// The same with something set on top.
    pub fn with(mut self, settings: impl IntoIterator<Item = String>) -> Self {
        self.settings.extend(settings);
        self
    }

    /// The same under another label.
    pub fn called(self, label: String) -> Self {
        Self { label, ..self }
    }

    /// Runs it; `rows` sees the outcome of a run that came to its end.
    pub fn compare(
        &self,
        context: &Context<'_>,
        rows: impl FnOnce(Option<&Outcome>) -> Result<Vec<Row>, CompareError>,
    ) -> Result<Vec<Check>, CompareError> {
        let all = match self.attempt(context) {
            Ok(attempt) => {
                let mut all = common(&attempt);
                all.extend(rows(attempt.outcome())?);
                all
            }
            // Pistons, moving bodies and vacuum.
            Err(error) if self.scheme.is_of_points() => {
                let what = format!("refused: {error}");
                vec![Row::informs(
                    what,
                    "points that stay cannot follow it",
                    0.0,
                    0.0,
                )]
            }
            Err(error) => return Err(error),
        };
        let heading = Heading {
            case: &self.case,
            label: &self.label,
            only_informs: !self.scheme.is_conservative(),
            is_quick: false,
        };
        Ok(all.into_iter().map(|row| row.check(heading)).collect())
    }

    /// Runs it.
    pub fn attempt(&self, context: &Context<'_>) -> Result<Attempt, CompareError> {
        self.scene.attempt(&self.all_settings(), context)
    }

    /// Scheme and what is set beside it.
    pub fn all_settings(&self) -> Vec<String> {
        let scheme = self.scheme.settings().into_iter();
        scheme.chain(self.settings.iter().cloned()).collect()
    }
}

/// Whether a run came to its end, what it lost, and its extremes.
fn common(attempt: &Attempt) -> Vec<Row> {
    let (end, stopped) = match attempt {
        Attempt::Ended(_) => ("comes to its end".to_owned(), 0.0),
        Attempt::Stopped(reason, _) => (format!("stops: {reason}"), 1.0),
    };
    let summary = attempt.summary();
    let mut rows = vec![Row::at_most(end, "a run must", stopped, 0.0)];
    // A flow that settles goes through no time.
    rows.extend(summary.conservation.map(|drift| {
        let drift = drift.mass.abs().max(drift.momentum).max(drift.energy.abs());
        let quantity = "drift of mass, momentum, energy";
        Row::at_most(quantity, "conservation", drift, DRIFT)
    }));
    rows.extend([
        // A run stops where they are not positive, so they inform.
        Row::informs("smallest density", "positive", summary.min_density, 0.0),
        Row::informs("smallest energy", "positive", summary.min_energy, 0.0),
    ]);
    rows
}
