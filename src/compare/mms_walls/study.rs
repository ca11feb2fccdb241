//! One solution about one wall at several spacings: what each treatment adds to the error, and its order.

use super::arrangement::{Arrangement, Manner, Places};
use super::flow::{Outcome, Trial};
use super::solution::{Condition, Family, Solution};
use super::treatment::{Mistake, Treatment};
use crate::context::CompareError;

/// Particles beside one wall at several spacings, coarse to fine.
pub struct Study {
    pub arrangement: Arrangement,
    pub cells: [u32; 3],
    places: Vec<Places>,
}

/// Errors at each spacing, or what a treatment adds to them: pressure and velocity.
#[derive(Clone, Debug)]
pub struct Errors {
    cells: [u32; 3],
    errors: Vec<[f64; 2]>,
}

/// Runs with ghosts that take the solution.
pub struct Base {
    solution: Solution,
    outcomes: Vec<Outcome>,
}

impl Study {
    /// Lays the particles of an arrangement with so many `cells`; a pair of spacings where the first is zero.
    ///
    /// # Errors
    /// Spacings that the packer refuses.
    pub fn new(arrangement: Arrangement, cells: [u32; 3]) -> Result<Self, CompareError> {
        let used = cells.into_iter().filter(|&cells| cells > 0);
        let lay = |cells| Arrangement {
            cells,
            ..arrangement
        };
        let places: Result<_, _> = used.map(|cells| lay(cells).lay()).collect();
        Ok(Self {
            arrangement,
            cells,
            places: places?,
        })
    }

    pub fn manner(&self) -> Manner {
        self.arrangement.manner()
    }

    /// Runs a solution with ghosts that take it.
    pub fn base(&self, family: Family, condition: Condition) -> Base {
        let solution = Solution {
            family,
            condition,
            form: self.arrangement.form,
        };
        Base {
            solution,
            outcomes: self.outcomes(Trial {
                solution,
                treatment: None,
                mistake: None,
            }),
        }
    }

    fn outcomes(&self, trial: Trial<'_>) -> Vec<Outcome> {
        self.places.iter().map(|places| trial.run(places)).collect()
    }

    /// Errors with ghosts that take the solution.
    pub fn own(&self, base: &Base) -> Errors {
        self.gather(base.outcomes.iter().map(|outcome| outcome.errors))
    }

    /// Errors with the ghosts of a treatment.
    pub fn errors(&self, base: &Base, treatment: &dyn Treatment) -> Errors {
        let outcomes = self.outcomes(Trial {
            solution: base.solution,
            treatment: Some(treatment),
            mistake: None,
        });
        self.gather(outcomes.iter().map(|outcome| outcome.errors))
    }

    /// What a treatment adds, with a mistake in it if there is one.
    pub fn added(
        &self,
        base: &Base,
        treatment: &dyn Treatment,
        mistake: Option<Mistake>,
    ) -> Errors {
        let outcomes = self.outcomes(Trial {
            solution: base.solution,
            treatment: Some(treatment),
            mistake,
        });
        let pairs = outcomes.iter().zip(&base.outcomes);
        self.gather(pairs.map(|(outcome, base)| outcome.beside(base)))
    }

    fn gather(&self, errors: impl Iterator<Item = [f64; 2]>) -> Errors {
        Errors {
            cells: self.cells,
            errors: errors.collect(),
        }
    }

    /// The spacings, as `100-200-400`.
    pub fn range(&self) -> String {
        let used = self.cells.iter().filter(|&&cells| cells > 0);
        used.map(u32::to_string).collect::<Vec<_>>().join("-")
    }
}

impl Errors {
    /// Of the quantity that a condition is about, at the finest spacing.
    pub fn finest(&self, condition: Condition) -> f64 {
        self.errors
            .last()
            .map_or(f64::NAN, |error| error[quantity(condition)])
    }

    /// Order between the two finest spacings; minus infinity where the flow broke up.
    pub fn order(&self, condition: Condition) -> f64 {
        let k = quantity(condition);
        let [.., coarse, fine] = self.errors[..] else {
            return f64::NAN;
        };
        let finer = f64::from(self.cells[2]) / f64::from(self.cells[1]);
        let order = (coarse[k] / fine[k]).ln() / finer.ln();
        if order.is_finite() {
            order
        } else {
            f64::NEG_INFINITY
        }
    }

    /// Spacings and errors, for a picture.
    pub fn points(&self, condition: Condition) -> Vec<[f64; 2]> {
        let used = self.cells.iter().filter(|&&cells| cells > 0);
        let spacings = used.map(|&cells| 1.0 / f64::from(cells));
        spacings
            .zip(&self.errors)
            .map(|(spacing, error)| [spacing, error[quantity(condition)]])
            .collect()
    }
}

/// Pressure where its gradient is treated, velocity otherwise.
fn quantity(condition: Condition) -> usize {
    usize::from(condition != Condition::Neumann)
}
