//! A flight's runs, coarse to fine, within its budget.

use std::path::Path;
use std::time::{Duration, Instant};

use aero::fly::{self, Costs, Extent, FAMILY, Flight, Level, minutes};
use aero::run::{Destination, RunError, Stopwatch, burst};
use aero::scene::Scene;

use super::super::CommandError;
use super::super::interrupt::Interrupt;
use super::super::scene::{checked, run_watched};

/// Most cells of the finest box, refinement aside: memory.
const MOST_CELLS: f64 = 1.5e6;

/// Minutes where nothing is given.
const MINUTES: f64 = 10.0;

/// Runs at most: what a cheap first one leaves of the budget goes to finer ones.
const MOST_RUNS: usize = 6;

/// So often a run that failed is tried on another lattice, this much finer.
const TRIES: usize = 4;
const ANOTHER: f64 = 0.93;

/// Iterations after which a run that is cut short counts.
const UNDER_WAY: u64 = 100;

/// A run may take so many times its share of what is left: a coarse wake that never settles leaves time for the finer ones.
const PATIENCE: f64 = 4.0;

/// Seconds that the look may take, as a part of the budget.
const LOOKING: f64 = 0.02;

/// What became of a run.
enum Came {
    /// It has loads.
    Through(Box<Level>),
    /// The gas came to a state that makes no sense.
    ToGrief(String),
    /// The budget was spent before.
    Late,
}

/// Spacings of runs that are planned.
pub struct Family {
    /// The coarsest.
    first: f64,
    ratio: f64,
    /// True where there are just these: what is left of the budget makes no finer ones.
    is_fixed: bool,
    /// Seconds that the finest may take.
    seconds: f64,
}

impl Family {
    /// The finest that is planned.
    pub fn finest(&self) -> f64 {
        self.first / self.ratio.powi(FAMILY as i32 - 1)
    }

    /// Seconds that it may take.
    pub fn seconds_of_finest(&self) -> f64 {
        self.seconds
    }
}

/// A flight with its budget.
pub struct Trip<'a> {
    flight: &'a Flight,
    costs: Costs,
    /// Seconds; without end where a spacing is given and no time.
    budget: f64,
    /// The finest spacing that is asked for, near body and shocks.
    wanted: Option<f64>,
    begun: Instant,
}

impl<'a> Trip<'a> {
    /// Of a flight that has begun, with a budget, or a finest spacing near body and shocks, or both.
    pub fn new(
        flight: &'a Flight,
        begun: Instant,
        minutes: Option<f64>,
        spacing: Option<f64>,
    ) -> Self {
        let otherwise = if spacing.is_some() {
            f64::INFINITY
        } else {
            MINUTES
        };
        Self {
            flight,
            costs: Costs::new(flight.dimension(), flight.wishes.with_the_gas),
            budget: 60.0 * minutes.unwrap_or(otherwise),
            wanted: spacing,
            begun,
        }
    }

    fn left(&self) -> f64 {
        self.budget - self.begun.elapsed().as_secs_f64()
    }

    fn scene_at(
        &self,
        spacing: f64,
        frame: Option<&Path>,
        folder: &Path,
    ) -> Result<Scene, CommandError> {
        let text = self
            .flight
            .scene(spacing, frame)
            .map_err(CommandError::wrong)?;
        Scene::parse(&text, &self.flight.name, folder).map_err(CommandError::wrong)
    }

    /// Spacings that fit the budget, by a look from the spacing `look` at how fast it goes, or that are asked for; and what is
    /// told of them.
    pub fn family(&self, mut look: f64) -> Result<(Family, String), CommandError> {
        let seconds = (LOOKING * self.budget).clamp(0.2, 5.0);
        let mut tries = 1;
        let seen = loop {
            let scene = self.scene_at(look, None, Path::new("."))?;
            match burst(checked(&scene)?, seconds) {
                Ok(seen) => break seen,
                Err(error) if tries == TRIES => return Err(CommandError::wrong(error)),
                Err(_) => look *= ANOTHER,
            }
            tries += 1;
        };
        let took = Costs::of_burst(seen.seconds_per_step, seen.steps_to_go, seen.settles);
        let halved = f64::from(1_u32 << self.flight.halvings());
        let coarser = self.costs.ratio.powi(FAMILY as i32 - 1);
        let first = match self.wanted {
            Some(finest) => finest * halved * coarser,
            None => (look * self.costs.fit(took, self.left()))
                .max(self.flight.spacing_of(MOST_CELLS) * coarser),
        };
        let family = Family {
            first,
            ratio: self.costs.ratio,
            is_fixed: self.wanted.is_some(),
            seconds: took * (look * coarser / first).powf(self.costs.power),
        };
        let seconds = self
            .costs
            .of_family(took * (look / first).powf(self.costs.power));
        let finest = family.finest() / halved;
        let across = self
            .flight
            .thinnest
            .unwrap_or(f64::INFINITY)
            .min(self.flight.bounds.size().min());
        let most = if self.budget.is_finite() {
            format!(", at most {}", minutes(self.left()))
        } else {
            String::new()
        };
        let told = format!(
            "{FAMILY} runs{}, down to a spacing of {finest:.3e} m, {:.1} across the thinnest part; this will take about {} on {} threads{most}",
            if family.is_fixed { "" } else { " or more" },
            across / finest,
            minutes(seconds),
            rayon::current_num_threads(),
        );
        Ok((family, told))
    }

    /// Runs coarse to fine, each from the one before, as far as the budget goes; and what is to be told of those that failed.
    pub fn runs(
        &self,
        family: &Family,
        out: &Path,
        interrupt: &Interrupt,
    ) -> Result<(Vec<Level>, Vec<String>), CommandError> {
        let mut levels: Vec<Level> = Vec::new();
        let mut failures = Vec::new();
        let mut spacing = family.first;
        let most = if family.is_fixed { FAMILY } else { MOST_RUNS };
        for number in 1..=most {
            let begun = Instant::now();
            let to_come = FAMILY.saturating_sub(number);
            let may_take = may_take(self.costs, self.left(), to_come);
            let folder = out.join(format!("spacing-{number}"));
            let frame = levels
                .last()
                .and_then(|level| fly::last_file(&level.folder, "frame-"));
            let mut frame = frame
                .map(std::path::absolute)
                .transpose()
                .map_err(CommandError::failed)?;
            let mut tries = 0;
            let level = loop {
                // Those that are through go into the report.
                interrupt.hold(!levels.is_empty());
                note!("run {number}, spacing {spacing:.3e} m");
                match self.run(spacing, frame.as_deref(), &folder, may_take, interrupt)? {
                    Came::Through(level) => break *level,
                    Came::Late => return Ok((levels, failures)),
                    Came::ToGrief(reason) => {
                        failures.push(format!(
                            "the run at spacing {spacing:.3e} failed and is left out: {reason}"
                        ));
                        note!("it failed: {reason}");
                    }
                }
                tries += 1;
                if tries == TRIES {
                    return match failures.last() {
                        Some(reason) if levels.is_empty() => Err(CommandError::failed(reason)),
                        _ => Ok((levels, failures)),
                    };
                }
                // Another lattice, and another start.
                spacing *= ANOTHER;
                frame = None;
            };
            say!(
                "spacing {spacing:.3e}: cd {:.5}, cl {:.5}, cm {:.5}, {} points, {}, {}",
                level.coefficients.cd,
                level.coefficients.cl,
                level.coefficients.cm,
                level.points,
                minutes(begun.elapsed().as_secs_f64()),
                if level.settled {
                    "settled"
                } else {
                    "NOT settled"
                }
            );
            levels.push(level);
            interrupt.hold(true);
            if interrupt.came() {
                break;
            }
            let seconds = begun.elapsed().as_secs_f64();
            // One that was cut short says little of what the next will take.
            let seconds = if seconds < may_take {
                seconds
            } else {
                seconds / PATIENCE
            };
            let more = to_come.max(1);
            let ratio = if family.is_fixed {
                Some(family.ratio)
            } else {
                self.costs.next_ratio(seconds, self.left(), more)
            };
            let Some(ratio) = ratio else {
                break;
            };
            spacing /= ratio;
        }
        Ok((levels, failures))
    }

    /// One run, which is cut short after so many seconds.
    fn run(
        &self,
        spacing: f64,
        frame: Option<&Path>,
        folder: &Path,
        seconds: f64,
        interrupt: &Interrupt,
    ) -> Result<Came, CommandError> {
        let out = folder.parent().unwrap_or(Path::new(""));
        let scene = self.scene_at(spacing, frame, out)?;
        let text = self
            .flight
            .scene(spacing, None)
            .map_err(CommandError::wrong)?;
        std::fs::write(out.join("scene.toml"), text).map_err(CommandError::failed)?;
        let lines = scene.lines();
        let destination = Destination {
            folder,
            scene: &lines,
            resume: false,
            overwrite: true,
        };
        let deadline = Duration::try_from_secs_f64(seconds)
            .ok()
            .and_then(|seconds| Instant::now().checked_add(seconds));
        let is_late = || deadline.is_some_and(|deadline| Instant::now() >= deadline);
        let case = checked(&scene)?;
        if is_late() {
            return Ok(Came::Late);
        }
        let result = run_watched(case, destination, Stopwatch::start(), interrupt, deadline);
        let summary = match result {
            Ok(summary) => summary,
            Err(RunError::Stopped { reason, summary }) => {
                if !interrupt.came() && !is_late() {
                    return Ok(Came::ToGrief(reason));
                }
                // Loads of a run that was cut short count once it was well under way.
                if summary.steps < UNDER_WAY {
                    return Ok(Came::Late);
                }
                *summary
            }
            Err(error @ RunError::Output(_)) => return Err(CommandError::failed(error)),
            Err(error) => return Err(CommandError::wrong(error)),
        };
        let level = Level::read(self.flight, folder, spacing, &summary);
        level
            .map(|level| Came::Through(Box::new(level)))
            .map_err(CommandError::failed)
    }

    /// What of the flight as a whole is to be told.
    pub fn warnings(&self, levels: &[Level]) -> Vec<String> {
        let mut warnings = Vec::new();
        let flight = self.flight;
        if flight.attitude.is_guess && flight.dimension() == 3 {
            warnings.push(format!(
                "how the body lies was guessed: its nose points along {} of the file, up is {}; mend with --axis",
                flight.attitude.nose, flight.attitude.up
            ));
        }
        if let (Some(thin), Some(level)) = (flight.thinnest, levels.last())
            && thin < 2.0 * level.finest
        {
            let mend = match self.wanted {
                Some(_) => "a smaller --spacing",
                None => "more --minutes",
            };
            warnings.push(format!(
                "the thinnest part, {thin:.2e} m, is {:.1} of the finest cells across: give {mend}",
                thin / level.finest
            ));
        }
        if let Extent::Meridian(_) = flight.extent
            && flight.wishes.roll != 0.0
        {
            warnings
                .push("a roll makes no difference to a body of revolution along the stream".into());
        }
        warnings
    }
}

/// Seconds that a run may take of those that are `left` for it and so many finer ones.
fn may_take(costs: Costs, left: f64, finer: usize) -> f64 {
    left * (PATIENCE * costs.share(finer)).min(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// In planes as in space: one that takes what it was thought to is not cut short, two that go on for ever leave more than half of
    /// the budget, and the finest may take all that is left.
    #[test]
    fn coarse_runs_that_do_not_settle_leave_their_time_to_finer_ones() {
        const BUDGET: f64 = 600.0;
        for dimension in [2, 3] {
            let costs = Costs::new(dimension, false);
            let mut left = BUDGET;
            for finer in [FAMILY - 1, FAMILY - 2] {
                let seconds = may_take(costs, left, finer);
                assert!(seconds > 2.0 * left * costs.share(finer), "{seconds}");
                left -= seconds;
            }
            assert!(left > 0.5 * BUDGET, "{left} s in {dimension} dimensions");
            assert_eq!(may_take(costs, left, 0), left);
        }
    }
}
