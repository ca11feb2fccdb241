//! A flight's runs, coarse to fine, within its budget.

use std::path::{Path, PathBuf};
use std::time::Instant;

use aero::fly::{self, Costs, FAMILY, Flight, Level, minutes};
use aero::run::{Destination, Progress, RunError, Stopwatch, burst};
use aero::scene::Scene;
use aero_solver::problem::side_name;

use super::super::CommandError;
use super::super::interrupt::Interrupt;
use super::super::scene::{checked, run_watched};
use super::budget::{PATIENCE, Room, UNDER_WAY, for_runs, may_take};
use super::family::{Family, next_spacing};
use super::telling::{is_long, tell, tell_rest};

/// Most cells of the finest box, refinement aside: memory.
const MOST_CELLS: f64 = 1.5e6;

/// Minutes where nothing is given.
const MINUTES: f64 = 10.0;

/// Runs at most: what a cheap first one leaves of the budget goes to finer ones.
const MOST_RUNS: usize = 8;

/// So often sides that are too near are moved, within this part of the budget.
const WIDENINGS: usize = 4;
const EARLY: f64 = 0.25;

/// So often a run that failed is tried on another lattice, this much finer.
const TRIES: usize = 4;
const ANOTHER: f64 = 0.93;

/// Most spacings of the look in the coarsest: more leave a box of fewer cells than flows around bodies need.
const COARSEST: f64 = 4.0;

/// Seconds that the look may take, as a part of the budget.
const LOOKING: f64 = 0.02;

/// The same is no shorter and no longer than these, s.
const LOOKS: [f64; 2] = [0.2, 2.0];

/// Seconds that a flight may take: without end where a spacing is given and no time.
pub fn budget(minutes: Option<f64>, spacing: Option<f64>) -> f64 {
    let otherwise = if spacing.is_some() {
        f64::INFINITY
    } else {
        MINUTES
    };
    60.0 * minutes.unwrap_or(otherwise)
}

/// What became of a run.
enum Came {
    /// It has loads.
    Through(Box<Level>),
    /// The gas came to a state that makes no sense.
    ToGrief(String),
    /// The budget was spent before.
    Late,
}

/// A flight with its budget.
pub struct Trip {
    flight: Flight,
    costs: Costs,
    /// Seconds.
    budget: f64,
    /// The finest spacing that is asked for, near body and shocks.
    wanted: Option<f64>,
    begun: Instant,
}

impl Trip {
    /// Of a flight that has begun, with a budget, or a finest spacing near body and shocks, or both.
    pub fn new(flight: Flight, begun: Instant, minutes: Option<f64>, spacing: Option<f64>) -> Self {
        Self {
            costs: Costs::new(flight.dimension(), flight.wishes.with_the_gas),
            flight,
            budget: budget(minutes, spacing),
            wanted: spacing,
            begun,
        }
    }

    /// The flight, in the box that its runs have shown that it needs.
    pub fn flight(&self) -> &Flight {
        &self.flight
    }

    /// Seconds left for runs.
    fn left(&self) -> f64 {
        for_runs(self.budget) - self.begun.elapsed().as_secs_f64()
    }

    /// What is said where nothing is left before the first run.
    fn is_spent(&self) -> Option<String> {
        (self.left() <= 0.0).then(|| {
            format!(
                "reading and looking at the body took all of {}: one coarse run is made all the same; give more --minutes",
                minutes(self.budget)
            )
        })
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
    pub fn family(&self, look: f64) -> Result<(Family, String), CommandError> {
        let halved = f64::from(1_u32 << self.flight.halvings());
        let coarser = self.costs.coarsest();
        let asked = self.wanted.map(|finest| finest * halved * coarser);
        // What is asked for is looked at itself where it is no finer than what is looked at otherwise.
        let mut look = asked.map_or(look, |first| first.max(look));
        let seconds = (LOOKING * self.budget).clamp(LOOKS[0], LOOKS[1]);
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
        let took = Costs::of_burst(
            [seen.seconds_before, seen.seconds_per_step],
            seen.steps_to_go,
            seen.settles,
        );
        let first = match asked {
            Some(first) => first,
            None => (look * self.costs.fit(took, self.left()).min(COARSEST))
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
        let size = self.flight.bounds.size().min();
        let across = |extent: f64| {
            let cells =
                extent / (family.finest() / f64::from(1_u32 << self.flight.body_halvings()));
            if cells < 1.0 {
                "less than one cell".into()
            } else {
                format!("{cells:.0} cells")
            }
        };
        let across = match self.flight.thinnest {
            Some(thin) if thin < size => format!("{} across the thinnest part", across(thin)),
            _ => format!("{} across the body", across(size)),
        };
        let most = if let Some(words) = self.is_spent() {
            format!("; {words}")
        } else if self.budget.is_finite() {
            format!(", at most {}", minutes(self.left()))
        } else if is_long(seconds) {
            "; --minutes N beside --spacing ends it after N minutes, --minutes alone finds the spacings that fit into them".into()
        } else {
            String::new()
        };
        let told = format!(
            "{FAMILY} runs{}, down to a spacing of {finest:.3e} m near shocks, {across}; this will take about {} on {} threads{most}",
            if family.is_fixed { "" } else { " or more" },
            minutes(seconds),
            rayon::current_num_threads(),
        );
        Ok((family, told))
    }

    /// Moves sides that were too near for the run of `level` away, early in a flight, and a few times at most; true where it did.
    fn make_room(&mut self, level: &Level, times: usize) -> bool {
        let is_early = self.begun.elapsed().as_secs_f64() < EARLY * self.budget;
        let may = is_early && times < WIDENINGS && !level.near_sides.is_empty();
        if may {
            self.flight.give_room(&level.near_sides);
            let names: Vec<String> = (level.near_sides.iter())
                .map(|&(axis, end)| format!("`{}`", side_name(axis, end)))
                .collect();
            note!(
                "{} too near: a larger box, from the coarsest run on",
                match &names[..] {
                    [name] => format!("side {name} is"),
                    _ => format!("sides {} are", names.join(", ")),
                }
            );
        }
        may
    }

    /// Runs coarse to fine, each from the one before, as far as the budget goes; and what is to be told of those that failed.
    pub fn runs(
        &mut self,
        family: &Family,
        out: &Path,
        interrupt: &Interrupt,
    ) -> Result<(Vec<Level>, Vec<String>), CommandError> {
        let mut levels: Vec<Level> = Vec::new();
        let mut failures: Vec<String> = self.is_spent().into_iter().collect();
        let mut spacing = family.first;
        let mut finest_took = 0.0;
        let most = if family.is_fixed { FAMILY } else { MOST_RUNS };
        let (mut number, mut widenings) = (0, 0);
        while number < most {
            number += 1;
            let begun = Instant::now();
            let to_come = FAMILY.saturating_sub(number);
            let is_finest = levels.last().is_none_or(|last| spacing < last.spacing);
            let room = Room {
                seconds: may_take(self.costs, self.left(), to_come),
                is_first: levels.is_empty(),
            };
            let folder = out.join(format!("spacing-{number}"));
            let mut frame = start_of(&levels, spacing)?;
            let mut tries = 0;
            let level = loop {
                // Those that are through go into the report.
                interrupt.hold(!levels.is_empty());
                note!("run {number}, spacing {spacing:.3e} m");
                let scene = self.scene_at(spacing, frame.as_deref(), out)?;
                if is_finest {
                    self.write_scene(spacing, out)?;
                }
                match self.run(&scene, spacing, &folder, room, interrupt)? {
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
            let seconds = begun.elapsed().as_secs_f64();
            tell(&level, seconds);
            if !interrupt.came() && self.make_room(&level, widenings) {
                for level in levels.drain(..).chain([level]) {
                    std::fs::remove_dir_all(&level.folder).map_err(CommandError::failed)?;
                }
                (spacing, number) = (family.first, 0);
                widenings += 1;
                continue;
            }
            let place = levels.partition_point(|other| other.spacing > level.spacing);
            levels.insert(place, level);
            interrupt.hold(true);
            if interrupt.came() {
                break;
            }
            if is_finest {
                // One that was cut short says little of what the next will take.
                finest_took = if seconds < room.seconds {
                    seconds
                } else {
                    seconds / PATIENCE
                };
            }
            let next = if family.is_fixed {
                tell_rest(self.costs, finest_took, to_come);
                Some(spacing / family.ratio)
            } else {
                let ends = [&levels[0], &levels[levels.len() - 1]].map(|level| level.spacing);
                next_spacing(self.costs, ends, levels.len(), finest_took, self.left())
            };
            let Some(next) = next else {
                break;
            };
            spacing = next;
        }
        Ok((levels, failures))
    }

    /// Leaves the scene of the finest run so far where it is easily found.
    fn write_scene(&self, spacing: f64, out: &Path) -> Result<(), CommandError> {
        let text = self
            .flight
            .scene(spacing, None)
            .map_err(CommandError::wrong)?;
        std::fs::write(out.join("scene.toml"), text).map_err(CommandError::failed)
    }

    /// One run, which is cut short where its room ends.
    fn run(
        &self,
        scene: &Scene,
        spacing: f64,
        folder: &Path,
        room: Room,
        interrupt: &Interrupt,
    ) -> Result<Came, CommandError> {
        let lines = scene.lines();
        let destination = Destination {
            folder,
            scene: &lines,
            noted: &scene.lines_from_anywhere(),
            resume: false,
            skips_start: false,
            overwrite: true,
        };
        let begun = Instant::now();
        let is_late = |steps: u64| room.is_over(begun.elapsed().as_secs_f64(), steps);
        let case = checked(scene)?;
        if is_late(0) {
            return Ok(Came::Late);
        }
        let mut steps = 0;
        let mut watch = |progress: Progress| {
            steps = progress.steps;
            is_late(steps)
        };
        let result = run_watched(
            case,
            destination,
            Stopwatch::start(),
            interrupt,
            &[],
            &mut watch,
        );
        let summary = match result {
            Ok(summary) => summary,
            Err(RunError::Stopped { reason, summary }) => {
                if !interrupt.came() && !is_late(steps) {
                    return Ok(Came::ToGrief(reason));
                }
                // Loads of a run that was cut short count once it was well under way.
                if summary.steps < UNDER_WAY {
                    return Ok(Came::Late);
                }
                let mut summary = *summary;
                if !interrupt.came() {
                    summary.stop_reason =
                        format!("its share of the time was over after {steps} steps");
                }
                summary
            }
            Err(error @ RunError::Output(_)) => return Err(CommandError::failed(error)),
            Err(error) => return Err(CommandError::wrong(error)),
        };
        let level = Level::read(&self.flight, folder, spacing, &summary);
        level
            .map(|level| Came::Through(Box::new(level)))
            .map_err(CommandError::failed)
    }
}

/// The last frame of the run whose spacing is nearest to `spacing` in the order coarse to fine, to start from.
fn start_of(levels: &[Level], spacing: f64) -> Result<Option<PathBuf>, CommandError> {
    let coarser = levels.iter().rev().find(|level| level.spacing > spacing);
    let level = coarser.or(levels.first());
    let frame = level.and_then(|level| fly::last_file(&level.folder, "frame-"));
    let frame = frame.map(std::path::absolute).transpose();
    frame.map_err(CommandError::failed)
}
