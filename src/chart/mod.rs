//! Speed against accuracy: a case at several spacings and in each variant of scheme and extrapolation,
//! its error over the processor time of the run alone, peers beside it. Measures with what
//! [`crate::validate`] compares with.

mod pysph;
mod studies;

use std::path::{Path, PathBuf};

use aero_validation::metrics::MetricError;
use aero_validation::pictures::PictureError;
use aero_validation::pictures::speed::{SpeedChart, SpeedPoint, SpeedSeries};

use crate::output::{self, OutputError};
use crate::validate::outcome::{Outcome, Source, run};
use crate::validate::{Context, Level, ValidateError};

/// One line of a chart.
#[derive(Clone, Copy)]
struct Variant {
    equations: &'static str,
    extrapolation: &'static str,
    shifted: bool,
    /// Each spacing starts from the flow that twice the spacing has found.
    coarse_start: bool,
    /// Pairs in single precision.
    mixed: bool,
}

/// The variants, in the order of their lines.
const VARIANTS: [Variant; 7] = {
    const fn plain(equations: &'static str, extrapolation: &'static str) -> Variant {
        Variant {
            equations,
            extrapolation,
            shifted: false,
            coarse_start: false,
            mixed: false,
        }
    }
    let usual = plain("conservative", "wom");
    [
        usual,
        plain("conservative", "wm"),
        Variant {
            shifted: true,
            ..usual
        },
        Variant {
            coarse_start: true,
            ..usual
        },
        Variant {
            coarse_start: true,
            mixed: true,
            ..usual
        },
        plain("paper", "wom"),
        plain("paper", "wm"),
    ]
};

/// No coarse start has fewer cells.
const COARSEST: u32 = 6;

/// One case: what is run and what is measured.
struct Study {
    scene: Source,
    title: &'static str,
    /// What the error is, with its unit.
    error: &'static str,
    /// The length that spacings are parts of, as in `R/40`.
    unit: &'static str,
    /// Spacings to that length: coarse ones, minutes in all, and those to add at length.
    cells: [&'static [u32]; 2],
    /// With a line for shifted particles too.
    shifted: bool,
    /// Time in which a flow taken over from twice the spacing settles; with a line for such starts where it is given.
    settles_in: Option<f64>,
    /// What a spacing asks of the scene.
    settings: fn(u32) -> Vec<String>,
    /// The size of the error.
    measure: fn(&Outcome, u32) -> Result<f64, ValidateError>,
    /// Other codes' points.
    peers: fn(&[SpeedSeries], &Costs) -> Vec<SpeedSeries>,
}

/// How many particle updates each run of the published scheme took, by label; for other codes' sake that run
/// the same equations.
#[derive(Default)]
struct Costs(Vec<Cost>);

struct Cost {
    variant: String,
    label: String,
    particles: f64,
    updates: f64,
}

/// How the charts are made.
#[derive(Clone, Copy)]
pub struct Wishes<'a> {
    /// The finest spacings as well.
    pub full: bool,
    /// At most so many of the coarsest spacings; all where none.
    pub spacings: Option<usize>,
    /// Folder for charts and tables.
    pub out: &'a Path,
    /// Told of every run before it starts, and of those that give no point.
    pub announce: &'a dyn Fn(&str),
}

impl std::fmt::Debug for Wishes<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Wishes")
            .field("full", &self.full)
            .finish_non_exhaustive()
    }
}

/// Charts the named cases, all of them where none is named; returns the files.
///
/// # Errors
/// A name that is not a case, before anything runs; a scene of the project that is wrong; files that
/// cannot be written. A run that stops, or whose flow does not show what is to be measured, has no point.
pub fn chart(names: &[String], wishes: Wishes<'_>) -> Result<Vec<PathBuf>, ValidateError> {
    let studies = studies::all();
    let known = |name: &str| studies.iter().any(|study| study.scene.name == name);
    if let Some(name) = names.iter().find(|name| !known(name)) {
        let all: Vec<&str> = studies.iter().map(|study| study.scene.name).collect();
        return Err(ValidateError::Unknown {
            name: name.clone(),
            known: all.join(", "),
        });
    }
    let mut files = Vec::new();
    for study in &studies {
        if names.is_empty() || names.iter().any(|name| name == study.scene.name) {
            files.extend(study.draw(wishes)?);
        }
    }
    Ok(files)
}

impl Study {
    fn draw(&self, wishes: Wishes<'_>) -> Result<[PathBuf; 2], ValidateError> {
        let mut costs = Costs::default();
        let mut series = Vec::new();
        for variant in VARIANTS.into_iter().filter(|v| self.has(v)) {
            series.push(self.line(variant, wishes, &mut costs)?);
        }
        let peers = (self.peers)(&series, &costs);
        series.extend(peers);
        let chart = SpeedChart {
            title: self.title.into(),
            error_label: self.error.into(),
            series,
        };
        let file = |ending: &str| wishes.out.join(format!("{}.{ending}", self.scene.name));
        let files = [file("svg"), file("csv")];
        chart.save_csv(&files[1])?;
        match chart.save(&files[0]) {
            Ok(()) => {}
            Err(PictureError::Empty(_)) => (wishes.announce)("no run gave a point: no chart"),
            Err(error) => return Err(error.into()),
        }
        Ok(files)
    }

    fn has(&self, variant: &Variant) -> bool {
        (self.shifted || !variant.shifted) && (self.settles_in.is_some() || !variant.coarse_start)
    }

    /// All spacings of one variant.
    fn line(
        &self,
        variant: Variant,
        wishes: Wishes<'_>,
        costs: &mut Costs,
    ) -> Result<SpeedSeries, ValidateError> {
        let name = variant.name();
        let more: &[u32] = if wishes.full { self.cells[1] } else { &[] };
        let cells = self.cells[0].iter().chain(more).copied();
        let mut points = Vec::new();
        for cells in cells.take(wishes.spacings.unwrap_or(usize::MAX)) {
            let label = format!("{}/{cells}", self.unit);
            let found = self
                .run(variant, cells, wishes)
                .and_then(|runs| Ok(((self.measure)(&runs.last, cells)?, runs)));
            let (error, runs) = match found {
                Ok(found) => found,
                Err(error @ (ValidateError::Run { .. } | ValidateError::Metric { .. })) => {
                    (wishes.announce)(&format!("no point for {name}, {label}: {error}"));
                    continue;
                }
                Err(error) => return Err(error),
            };
            let summary = &runs.last.summary;
            costs.0.push(Cost {
                variant: name.clone(),
                label: label.clone(),
                particles: summary.particles.fluid as f64,
                updates: summary.particle_updates_per_cpu_second * summary.cpu_seconds,
            });
            points.push(SpeedPoint {
                label,
                cpu_seconds: runs.cpu_seconds,
                error,
            });
        }
        Ok(SpeedSeries {
            name,
            peer: false,
            points,
        })
    }

    /// One spacing of one variant, after the coarser ones that it starts from.
    fn run(&self, variant: Variant, cells: u32, wishes: Wishes<'_>) -> Result<Runs, ValidateError> {
        let context = Context {
            level: Level::Quick,
            settings: &[],
            out: wishes.out,
            announce: wishes.announce,
        };
        let mut settings = (self.settings)(cells);
        settings.extend(variant.settings());
        let half = cells / 2;
        let settles_in = self.settles_in.filter(|_| variant.coarse_start);
        let Some(time) = settles_in.filter(|_| cells.is_multiple_of(2) && half >= COARSEST) else {
            let last = run(self.scene, &settings, &context)?;
            return Ok(Runs {
                cpu_seconds: last.summary.cpu_seconds,
                last,
            });
        };
        let before = self.run(variant, half, wishes)?;
        let frame = wishes.out.join(format!("{}-start.vtp", self.scene.name));
        output::make_folder(wishes.out)?;
        output::write_frame(&frame, &before.last.frame, false)?;
        settings.push(format!("initial.frame={}", frame.display()));
        settings.push(format!("end_time={time}"));
        let last = run(self.scene, &settings, &context);
        std::fs::remove_file(&frame).map_err(|source| OutputError::new(&frame, source))?;
        let last = last?;
        Ok(Runs {
            cpu_seconds: before.cpu_seconds + last.summary.cpu_seconds,
            last,
        })
    }
}

/// A run, and what it and those that it started from took.
struct Runs {
    last: Outcome,
    cpu_seconds: f64,
}

impl Variant {
    fn name(&self) -> String {
        let shifted = if self.shifted { ", shifted" } else { "" };
        let start = if self.coarse_start {
            ", coarse start"
        } else {
            ""
        };
        let mixed = if self.mixed { ", mixed" } else { "" };
        let (equations, extrapolation) = (self.equations, self.extrapolation);
        format!("{equations}, {extrapolation}{shifted}{start}{mixed}")
    }

    fn settings(&self) -> [String; 4] {
        let precision = if self.mixed { "mixed" } else { "double" };
        [
            format!("scheme.equations={}", self.equations),
            format!("scheme.extrapolation={}", self.extrapolation),
            format!("scheme.shifting={}", self.shifted),
            format!("scheme.precision={precision}"),
        ]
    }
}

/// The error of a flow that does not show what was to be measured.
fn unread(scene: Source, what: &'static str) -> ValidateError {
    scene.unread(MetricError::TooFew {
        what,
        found: 0,
        needed: 1,
        remedy: "refine the spacing",
    })
}
