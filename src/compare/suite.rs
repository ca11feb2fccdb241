//! Comparisons of one subject that share no frame of variants.

use aero_validation::table::Check;

use super::comparison::Compare;
use super::context::{CompareError, Context};
use super::variant::Levels;

/// Runs what it needs at the level of the context, and returns its rows.
pub type Run = fn(&Context<'_>) -> Result<Vec<Check>, CompareError>;

/// Parts in their order, each with the levels that it is run at.
pub struct Suite {
    parts: &'static [(Levels, Run)],
    wants_all_threads: bool,
}

impl Suite {
    /// These parts.
    pub const fn of(parts: &'static [(Levels, Run)]) -> Self {
        Self {
            parts,
            wants_all_threads: false,
        }
    }

    /// These, with no other comparison beside them.
    pub const fn alone(parts: &'static [(Levels, Run)]) -> Self {
        Self {
            parts,
            wants_all_threads: true,
        }
    }
}

impl Compare for Suite {
    fn compare(&self, context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
        let runs = self
            .parts
            .iter()
            .filter(|(levels, _)| levels.contain(context.level));
        let parts = runs.map(|(_, run)| run(context));
        Ok(parts.collect::<Result<Vec<_>, _>>()?.concat())
    }

    fn wants_all_threads(&self) -> bool {
        self.wants_all_threads
    }
}
