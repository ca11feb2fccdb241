//! `aero converge`: any scene at several spacings, and what its coefficients go to.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use aero::fly::{Extrapolated, extrapolate};
use aero::output::{Summary, make_folder, write_json};
use aero::run::{Destination, RunError, Stopwatch};
use aero::scene::Scene;
use aero_validation::pictures::curves::{Curves, Panel, Series, Style};
use clap::Args;
use serde::Serialize;

use super::interrupt::Interrupt;
use super::neighbour::{Neighbour, started};
use super::scene::{SceneArgs, checked, folder, run_watched, tell};
use super::{CommandError, on_threads};

/// What `aero converge` takes.
#[derive(Args, Debug)]
pub struct ConvergeArgs {
    #[command(flatten)]
    scene: SceneArgs,
    /// Number of spacings, the scene's own the finest
    #[arg(long, value_name = "N", default_value_t = 3, value_parser = clap::value_parser!(u16).range(2..=8))]
    spacings: u16,
    /// Ratio of each spacing to the next finer one
    #[arg(long, value_name = "R", default_value_t = 2.0, value_parser = ratio)]
    ratio: f64,
    /// Folder for the results; `out/NAME-converge` unless given
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Write over the results of another study
    #[arg(long)]
    overwrite: bool,
}

fn ratio(text: &str) -> Result<f64, String> {
    let ratio = text.parse::<f64>().ok().filter(|r| (1.1..=4.0).contains(r));
    ratio.ok_or_else(|| "is no ratio of spacings, which is 1.1 to 4".into())
}

/// A coefficient of a body at all spacings, and what it goes to.
#[derive(Clone, Debug, Serialize)]
struct Row {
    body: String,
    coefficient: &'static str,
    spacings: Vec<f64>,
    values: Vec<f64>,
    #[serde(flatten)]
    found: Extrapolated,
}

/// What is said of a scene without coefficients.
const NOTHING: &str =
    "the scene has no body in a stream, so no coefficients: nothing here is known to converge";

/// Runs the scene at all spacings, coarse to fine.
pub fn converge(args: &ConvergeArgs) -> Result<(), CommandError> {
    let interrupt = Interrupt::listen()?;
    let scene = args.scene.load()?;
    if scene.file().body.is_empty() {
        return Err(CommandError::wrong(NOTHING));
    }
    let out = folder(args.out.as_ref(), &format!("{}-converge", scene.name()));
    let steps = (0..i32::from(args.spacings)).rev();
    let factors: Vec<f64> = steps.map(|n| args.ratio.powi(n)).collect();
    // All scenes are read before the first runs.
    let scenes = factors
        .iter()
        .map(|factor| at(&scene, *factor))
        .collect::<Result<Vec<_>, _>>()?;
    if out.join("converge.json").exists() && !args.overwrite {
        return Err(CommandError::wrong(format!(
            "`{}` holds the results of another study; give `--out` another folder, or `--overwrite`",
            out.display()
        )));
    }
    make_folder(&out).map_err(CommandError::wrong)?;
    on_threads(args.scene.threads, || {
        let mut summaries: Vec<Summary> = Vec::new();
        let mut before: Option<Neighbour> = None;
        for (number, scene) in scenes.iter().enumerate() {
            let folder = out.join(format!("spacing-{}", number + 1));
            let spacing = scene.file().spacing.get();
            note!(
                "run {} of {}, spacing {spacing:.4e}",
                number + 1,
                scenes.len()
            );
            summaries.push(run(scene, &folder, before.as_ref(), &interrupt)?);
            let scene = scene.clone();
            before = Some(Neighbour { scene, folder });
        }
        let rows = rows(&summaries);
        if rows.is_empty() {
            return Err(CommandError::wrong(NOTHING));
        }
        say_all!("{}", text(&rows));
        for summary in summaries.iter().filter(|summary| !came_to_rest(summary)) {
            say!(
                "warning: spacing {:.4e}: {}",
                summary.spacing,
                summary.stop_reason
            );
        }
        write_json(&out.join("converge.json"), &rows).map_err(CommandError::failed)?;
        picture(&rows, scene.name())
            .save(&out.join("converge.svg"))
            .map_err(CommandError::failed)?;
        say!("results in `{}`", out.display());
        Ok(())
    })
}

/// The scene with all its spacings times `factor`.
fn at(scene: &Scene, factor: f64) -> Result<Scene, CommandError> {
    let file = scene.file();
    let mut settings = vec![format!("spacing={:?}", factor * file.spacing.get())];
    for body in &file.body {
        if let Some(spacing) = body.spacing {
            let spacing = factor * spacing.get();
            settings.push(format!("body.{}.spacing={spacing:?}", body.name.as_str()));
        }
    }
    let mut scene = scene.clone();
    for setting in settings {
        scene.set(&setting).map_err(CommandError::wrong)?;
    }
    Ok(scene)
}

fn run(
    scene: &Scene,
    folder: &Path,
    before: Option<&Neighbour>,
    interrupt: &Interrupt,
) -> Result<Summary, CommandError> {
    let scene = started(scene, before, None)?;
    let stopwatch = Stopwatch::start();
    let case = checked(&scene)?;
    tell(&case);
    let lines = scene.lines();
    let destination = Destination {
        folder,
        scene: &lines,
        noted: &scene.lines_from_anywhere(),
        resume: false,
        skips_start: false,
        overwrite: true,
    };
    run_watched(case, destination, stopwatch, interrupt, &[], &mut |_| false).map_err(|error| {
        match error {
            RunError::SetUp(_) | RunError::Resume(_) | RunError::Occupied(_) => {
                CommandError::wrong(error)
            }
            _ => CommandError::failed(error),
        }
    })
}

/// True where loads came to rest, or a run through time to its end.
fn came_to_rest(summary: &Summary) -> bool {
    let words = ["settled", "steady", "end time reached"];
    let reason = &summary.stop_reason;
    words.iter().any(|word| reason.starts_with(word)) && !reason.contains("not steady")
}

/// Coefficients of all bodies that all runs have.
fn rows(summaries: &[Summary]) -> Vec<Row> {
    let Some(first) = summaries.first() else {
        return Vec::new();
    };
    let mut rows = Vec::new();
    for name in first.bodies.keys() {
        for (number, coefficient) in ["cd", "cl", "cm"].into_iter().enumerate() {
            let value = |summary: &Summary| {
                let body = summary.bodies.get(name)?;
                [body.cd_mean, body.cl_mean, body.cm_mean][number]
            };
            let values: Option<Vec<f64>> = summaries.iter().map(value).collect();
            let Some(values) = values else { continue };
            let spacings: Vec<f64> = summaries.iter().map(|summary| summary.spacing).collect();
            let runs: Vec<(f64, f64)> = spacings
                .iter()
                .copied()
                .zip(values.iter().copied())
                .collect();
            rows.push(Row {
                body: name.clone(),
                coefficient,
                found: extrapolate(&runs),
                spacings,
                values,
            });
        }
    }
    rows
}

/// The table for people.
fn text(rows: &[Row]) -> String {
    let mut text = format!("{:14} {:3}", "body", "");
    // Writing to a string cannot fail.
    for spacing in rows.first().map_or(&[][..], |row| &row.spacings) {
        let _ = write!(text, " {spacing:>11.3e}");
    }
    text += "  extrapolated          +-  order\n";
    for row in rows {
        let _ = write!(text, "{:14} {:3}", row.body, row.coefficient);
        for value in &row.values {
            let _ = write!(text, " {value:>11.5}");
        }
        let order = row
            .found
            .order
            .map_or("-".into(), |order| format!("{order:.2}"));
        let _ = writeln!(
            text,
            "   {:>11.5} {:>11.5}  {order}",
            row.found.value, row.found.band
        );
    }
    text
}

fn picture(rows: &[Row], name: &str) -> Curves {
    let panels = rows.iter().map(|row| {
        let points: Vec<[f64; 2]> = row
            .spacings
            .iter()
            .zip(&row.values)
            .map(|(h, v)| [*h, *v])
            .collect();
        let widest = row.spacings.first().copied().unwrap_or(1.0);
        let mut series = vec![Series::new("runs", Style::Dots, points)];
        for (label, y) in [
            ("band", row.found.value - row.found.band),
            ("", row.found.value + row.found.band),
        ] {
            let mut line = Series::new(label, Style::Dashed, vec![[0.0, y], [widest, y]]);
            line.colour = Some([120, 122, 128]);
            series.push(line);
        }
        Panel::new(
            "spacing",
            &format!("{} of {}", row.coefficient, row.body),
            series,
        )
    });
    Curves {
        title: format!("{name}: convergence"),
        panels: panels.collect(),
        columns: 3,
    }
}
