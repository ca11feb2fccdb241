//! `aero fly`: a body from its file to drag, lift and a report, in one command.

mod budget;
mod closer;
mod family;
pub mod telling;
pub mod trip;

use std::path::{Path, PathBuf};
use std::time::Instant;

use aero::fly::{self, Flight, Report, Wishes, minutes};
use aero::output::make_folder;
use clap::{Args, ValueEnum};

use self::budget::for_runs;
use super::body::{BodyArgs, mach, stream_angle};
use super::interrupt::Interrupt;
use super::scene::folder;
use super::{CommandError, on_threads};
use trip::{Trip, budget};

/// What `aero fly` takes.
#[derive(Args, Debug)]
pub struct FlyArgs {
    /// STL, OBJ or PLY file, packed as .gz or not
    body: PathBuf,
    /// Mach number
    #[arg(long, value_name = "M", allow_negative_numbers = true, value_parser = mach)]
    mach: f64,
    /// Angle of attack, degrees: the stream comes from below
    #[arg(long, value_name = "DEG", default_value_t = 0.0, allow_hyphen_values = true, value_parser = stream_angle)]
    incidence: f64,
    /// Sideslip, degrees
    #[arg(long, value_name = "DEG", default_value_t = 0.0, allow_hyphen_values = true, value_parser = stream_angle)]
    sideslip: f64,
    #[command(flatten)]
    how: BodyArgs,
    /// What carries the gas
    #[arg(long, value_enum, default_value_t = MotionWord::Fixed)]
    motion: MotionWord,
    /// Write the scene to this file and stop; one that is there already is left, unless told `--overwrite`
    #[arg(long, value_name = "FILE")]
    scene: Option<PathBuf>,
    /// Folder for the results; `out/NAME-fly` unless given
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Write over the results of another flight, or another scene
    #[arg(long)]
    overwrite: bool,
    /// Number of threads; all processors unless given
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    threads: Option<u16>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum MotionWord {
    Fixed,
    WithTheGas,
}

/// Cells of the box at which the first look is taken.
const LOOK: [f64; 2] = [1_200.0, 5_000.0];

/// A flight with room for its shocks, with the halvings that the finest `spacing` asks for where one is given, and those that its body is worth within
/// so many minutes; and the spacing at which a
/// first look is taken.
pub fn prepared(
    wishes: Wishes,
    minutes: Option<f64>,
    spacing: Option<f64>,
) -> Result<(Flight, f64), CommandError> {
    let mut flight = Flight::new(wishes).map_err(CommandError::wrong)?;
    let cells = LOOK[usize::from(flight.dimension() == 3)];
    flight.widen(cells);
    let look = flight.spacing_of(cells);
    if let Some(finest) = spacing {
        flight.deepen(finest, look);
    }
    let seconds = for_runs(budget(minutes, spacing));
    closer::resolve(&mut flight, look, cells, seconds)?;
    Ok((flight, look))
}

/// Refuses a place for a scene where one cannot be written, or something is already.
fn check_place(path: &Path, overwrite: bool) -> Result<(), CommandError> {
    let refused = |why: &str| {
        let path = path.display();
        Err(CommandError::wrong(format!("`--scene {path}`: {why}")))
    };
    let folder = path
        .parent()
        .filter(|folder| !folder.as_os_str().is_empty());
    if path.is_dir() {
        refused("is a folder; give the name of a file in it")
    } else if path.exists() && !overwrite {
        refused("is there already; give another name, or `--overwrite`")
    } else if folder.is_some_and(|folder| !folder.is_dir()) {
        refused("its folder is not there; make it, or give another")
    } else {
        Ok(())
    }
}

/// Flies a body.
pub fn fly(args: &FlyArgs) -> Result<(), CommandError> {
    let begun = Instant::now();
    if let Some(path) = &args.scene {
        check_place(path, args.overwrite)?;
    }
    let interrupt = Interrupt::listen()?;
    let wishes = Wishes {
        with_the_gas: args.motion == MotionWord::WithTheGas,
        ..args
            .how
            .wishes(&args.body, [args.mach, args.incidence, args.sideslip])
    };
    let (flight, look) = prepared(wishes, args.how.minutes, args.how.spacing)?;
    for line in words(&flight) {
        say!("{line}");
    }
    let out = folder(args.out.as_ref(), &format!("{}-fly", flight.name));
    if args.scene.is_none() && out.join("fly.json").exists() && !args.overwrite {
        return Err(CommandError::wrong(format!(
            "`{}` holds the results of another flight; give `--out` another folder, or `--overwrite`",
            out.display()
        )));
    }
    on_threads(args.threads, || {
        let mut trip = Trip::new(flight, begun, args.how.minutes, args.how.spacing);
        let (family, told) = trip.family(look)?;
        say!("{told}");
        if let Some(path) = &args.scene {
            let text = trip
                .flight()
                .scene(family.finest(), None)
                .map_err(CommandError::wrong)?;
            std::fs::write(path, text).map_err(|error| {
                CommandError::wrong(format!("cannot write `{}`: {error}", path.display()))
            })?;
            say!("wrote `{}`: aero run {0}", path.display());
            return Ok(());
        }
        make_folder(&out).map_err(CommandError::wrong)?;
        let (levels, failures) = trip.runs(&family, &out, &interrupt)?;
        let flight = trip.flight();
        let mut warnings = telling::warnings(flight);
        warnings.extend(failures);
        let report =
            Report::new(flight, words(flight), levels, warnings).map_err(CommandError::failed)?;
        fly::write_report(flight, &report, &out).map_err(CommandError::failed)?;
        say_all!("{}", report.text());
        say!(
            "{}, {} in all; report in `{}`",
            report.runs_words(flight.halvings()),
            minutes(begun.elapsed().as_secs_f64()),
            out.join("report.html").display()
        );
        Ok(())
    })
}

/// How the body lies, what is computed, what is referred to.
pub fn words(flight: &Flight) -> Vec<String> {
    let w = &flight.wishes;
    let size = flight.bounds.size();
    let mut lines = flight.attitude.words(&size, w.incidence, w.sideslip);
    lines.extend(telling::half(flight));
    lines.extend(
        flight
            .repairs
            .iter()
            .map(|repair| format!("mended: {repair}")),
    );
    lines.push(flight.stream_words());
    let sizes = flight.region().size();
    let sizes = sizes.iter().take(flight.dimension());
    let sizes: Vec<String> = sizes.map(|size| format!("{size:.3}")).collect();
    lines.push(format!(
        "{}, in a box of {} m",
        flight.extent_words(),
        sizes.join(" x ")
    ));
    lines.push(format!(
        "area {:.5e} m2, length {:.4} m, {}",
        flight.area,
        flight.reference_length(),
        flight.centre_words()
    ));
    lines
}
