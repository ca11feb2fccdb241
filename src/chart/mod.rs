//! Speed against accuracy: a case at several spacings and in each variant of scheme and extrapolation,
//! its error over the processor time of the run alone, peers beside it. Measures with what
//! [`crate::compare`] compares with.

mod pysph;
mod studies;

use std::path::{Path, PathBuf};

use aero_validation::metrics::MetricError;
use aero_validation::pictures::PictureError;
use aero_validation::pictures::speed::{SpeedChart, SpeedPoint, SpeedSeries};

use aero::output::{self, OutputError};
use aero::run::{Keep, Outcome};

use aero::nearest::nearest;
use aero_compare::scenes::Source;
use aero_compare::{CompareError, Context, Level, Motion, Scheme};

/// One line of a chart.
#[derive(Clone, Copy)]
struct Line {
    scheme: Scheme,
    shifted: bool,
    /// Each spacing starts from the flow that twice the spacing has found.
    coarse_start: bool,
    /// Pairs in single precision.
    mixed: bool,
    /// Halvings of the spacing where the flow asks for them, of points that stay.
    refine: u8,
}

/// The lines, in their order.
const LINES: [Line; 10] = {
    const fn plain(scheme: Scheme) -> Line {
        Line {
            scheme,
            shifted: false,
            coarse_start: false,
            mixed: false,
            refine: 0,
        }
    }
    let settled = plain(Scheme::USUAL.by_points(Motion::Settled));
    let usual = plain(Scheme::USUAL);
    [
        usual,
        plain(Scheme::USUAL.wm()),
        Line {
            shifted: true,
            ..usual
        },
        Line {
            coarse_start: true,
            ..usual
        },
        Line {
            coarse_start: true,
            mixed: true,
            ..usual
        },
        plain(Scheme::USUAL.paper()),
        plain(Scheme::USUAL.paper().wm()),
        plain(Scheme::USUAL.by_points(Motion::Marched)),
        settled,
        Line {
            refine: 3,
            ..settled
        },
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
    measure: fn(&Outcome, u32) -> Result<f64, CompareError>,
    /// Other codes' points.
    peers: fn(&[SpeedSeries], &Costs) -> Vec<SpeedSeries>,
}

/// How many particle updates each run of the published scheme took, by label; for other codes' sake that run
/// the same equations.
#[derive(Default)]
struct Costs(Vec<Cost>);

struct Cost {
    line: String,
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
    pub announce: &'a (dyn Fn(&str) + Sync),
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
pub fn chart(names: &[String], wishes: Wishes<'_>) -> Result<Vec<PathBuf>, CompareError> {
    let studies = studies::all();
    let known = |name: &str| studies.iter().any(|study| study.scene.name == name);
    if let Some(name) = names.iter().find(|name| !known(name)) {
        let all: Vec<&str> = studies.iter().map(|study| study.scene.name).collect();
        return Err(CompareError::Unknown {
            name: name.clone(),
            hint: nearest(name, &all),
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
    fn draw(&self, wishes: Wishes<'_>) -> Result<[PathBuf; 2], CompareError> {
        let mut costs = Costs::default();
        let mut series = Vec::new();
        for line in LINES.into_iter().filter(|line| self.has(line)) {
            series.push(self.measure_line(line, wishes, &mut costs)?);
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

    fn has(&self, line: &Line) -> bool {
        let is_for_steady = line.coarse_start || line.scheme.motion == Motion::Settled;
        (self.shifted || !line.shifted) && (self.settles_in.is_some() || !is_for_steady)
    }

    /// All spacings of one line.
    fn measure_line(
        &self,
        line: Line,
        wishes: Wishes<'_>,
        costs: &mut Costs,
    ) -> Result<SpeedSeries, CompareError> {
        let name = line.name();
        let more: &[u32] = if wishes.full { self.cells[1] } else { &[] };
        let cells = self.cells[0].iter().chain(more).copied();
        let mut points = Vec::new();
        for cells in cells.take(wishes.spacings.unwrap_or(usize::MAX)) {
            let label = format!("{}/{cells}", self.unit);
            let found = self
                .run(line, cells, wishes)
                .and_then(|runs| Ok(((self.measure)(&runs.last, cells)?, runs)));
            let (error, runs) = match found {
                Ok(found) => found,
                Err(error @ (CompareError::Run { .. } | CompareError::Metric(_))) => {
                    (wishes.announce)(&format!("no point for {name}, {label}: {error}"));
                    continue;
                }
                Err(error) => return Err(error),
            };
            let summary = &runs.last.summary;
            costs.0.push(Cost {
                line: name.clone(),
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

    /// One spacing of one line, after the coarser ones that it starts from.
    fn run(&self, line: Line, cells: u32, wishes: Wishes<'_>) -> Result<Runs, CompareError> {
        let context = Context {
            level: Level::Quick,
            settings: &[],
            out: wishes.out,
            announce: wishes.announce,
        };
        let mut settings = (self.settings)(cells);
        settings.extend(line.settings());
        let half = cells / 2;
        let settles_in = self.settles_in.filter(|_| line.coarse_start);
        let Some(time) = settles_in.filter(|_| cells.is_multiple_of(2) && half >= COARSEST) else {
            let last = self.scene.run(&settings, Keep::End, &context)?;
            return Ok(Runs {
                cpu_seconds: last.summary.cpu_seconds,
                last,
            });
        };
        let before = self.run(line, half, wishes)?;
        let frame = wishes.out.join(format!("{}-start.vtp", self.scene.name));
        output::make_folder(wishes.out)?;
        output::write_frame(&frame, before.last.frame, &[], None, false)?;
        settings.push(format!("initial.frame={}", frame.display()));
        settings.push(format!("end_time={time}"));
        let last = self.scene.run(&settings, Keep::End, &context);
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

impl Line {
    fn name(&self) -> String {
        let shifted = if self.shifted { ", shifted" } else { "" };
        let start = if self.coarse_start {
            ", coarse start"
        } else {
            ""
        };
        let mixed = if self.mixed { ", mixed" } else { "" };
        if self.scheme.is_of_points() {
            let refined = if self.refine > 0 { ", refined" } else { "" };
            return format!("{}{refined}", self.scheme);
        }
        let Scheme {
            equations,
            extrapolation,
            ..
        } = self.scheme;
        format!("{equations}, {extrapolation}{shifted}{start}{mixed}")
    }

    fn settings(&self) -> Vec<String> {
        let precision = if self.mixed { "mixed" } else { "double" };
        let mut settings = self.scheme.settings();
        if self.scheme.is_of_points() {
            settings.push(format!("scheme.refine={}", self.refine));
            return settings;
        }
        settings.push(format!("scheme.shifting={}", self.shifted));
        settings.push(format!("scheme.precision={precision}"));
        settings
    }
}

/// The error of a flow that does not show what was to be measured.
fn unread(what: &'static str) -> CompareError {
    CompareError::Metric(MetricError::TooFew {
        what,
        found: 0,
        needed: 1,
        remedy: "refine the spacing",
    })
}
