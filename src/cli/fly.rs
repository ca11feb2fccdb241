//! `aero fly`: a body from its file to drag, lift and a report, in one command.

mod trip;

use std::path::PathBuf;
use std::time::Instant;

use aero::fly::{self, Air, Axes, Flight, Report, Wishes, minutes};
use aero::output::make_folder;
use aero::scene::shapes::Unit;
use clap::{Args, ValueEnum};

use super::scene::folder;
use super::{CommandError, on_threads};
use trip::Trip;

/// What `aero fly` takes.
#[derive(Args, Debug)]
pub struct FlyArgs {
    /// STL, OBJ or PLY file, packed as .gz or not
    body: PathBuf,
    /// Mach number
    #[arg(long, value_name = "M")]
    mach: f64,
    /// Angle of attack, degrees: the stream comes from below
    #[arg(long, value_name = "DEG", default_value_t = 0.0, allow_hyphen_values = true, value_parser = angle)]
    incidence: f64,
    /// Sideslip, degrees
    #[arg(long, value_name = "DEG", default_value_t = 0.0, allow_hyphen_values = true, value_parser = angle)]
    sideslip: f64,
    /// Turn of the body about its length, degrees
    #[arg(long, value_name = "DEG", default_value_t = 0.0, allow_hyphen_values = true, value_parser = angle)]
    roll: f64,
    /// Height in the standard atmosphere: 12km, 12000 or 40kft; sea level unless given
    #[arg(long, value_name = "H", allow_hyphen_values = true, value_parser = height, conflicts_with_all = ["pressure", "temperature"])]
    altitude: Option<f64>,
    /// Pressure of the stream, Pa, with a temperature
    #[arg(long, value_name = "PA", requires = "temperature", value_parser = positive)]
    pressure: Option<f64>,
    /// Temperature of the stream, K, with a pressure
    #[arg(long, value_name = "K", requires = "pressure", value_parser = positive)]
    temperature: Option<f64>,
    /// Unit of the file; metres unless given
    #[arg(long, value_enum)]
    unit: Option<UnitWord>,
    /// Directions of the file out of the nose and up, such as -x,+z; as the body looks unless given
    #[arg(long, value_name = "NOSE[,UP]", allow_hyphen_values = true)]
    axis: Option<Axes>,
    /// Reference area, m2; the frontal area unless given
    #[arg(long, value_name = "M2", value_parser = positive)]
    area: Option<f64>,
    /// Reference length, m; the body's length unless given
    #[arg(long, value_name = "M", value_parser = positive)]
    length: Option<f64>,
    /// Point of the moments, m behind the nose; the middle unless given
    #[arg(long, value_name = "M", allow_hyphen_values = true)]
    centre: Option<f64>,
    /// Time that it may take; 10 unless this or a spacing is given
    #[arg(long, value_name = "N", value_parser = positive)]
    minutes: Option<f64>,
    /// The finest spacing, m, near body and shocks: the same results on any machine
    #[arg(long, value_name = "M", value_parser = positive)]
    spacing: Option<f64>,
    /// What carries the gas
    #[arg(long, value_enum, default_value_t = MotionWord::Fixed)]
    motion: MotionWord,
    /// Write the scene to this file and stop
    #[arg(long, value_name = "FILE")]
    scene: Option<PathBuf>,
    /// Folder for the results; `out/NAME-fly` unless given
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Write over the results of another flight
    #[arg(long)]
    overwrite: bool,
    /// Number of threads; all processors unless given
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    threads: Option<u16>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum UnitWord {
    M,
    Mm,
    In,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum MotionWord {
    Fixed,
    WithTheGas,
}

fn angle(text: &str) -> Result<f64, String> {
    let angle: f64 = text.parse().map_err(|_| "is no number of degrees")?;
    if angle.abs() <= 360.0 {
        Ok(angle)
    } else {
        Err("is no angle in degrees, which is -360 to 360".into())
    }
}

fn positive(text: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().ok();
    let number = number.filter(|x| x.is_finite() && *x > 0.0);
    number.ok_or_else(|| "is not a positive number".into())
}

/// A height in m, typed in m, km or thousands of feet.
fn height(text: &str) -> Result<f64, String> {
    let units = [
        ("kft", 304.8),
        ("km", 1e3),
        ("ft", 0.3048),
        ("m", 1.0),
        ("", 1.0),
    ];
    let read = units.into_iter().find_map(|(unit, metres)| {
        let number = text.trim().strip_suffix(unit)?.trim();
        Some(number.parse::<f64>().ok()? * metres)
    });
    read.filter(|height| height.is_finite())
        .ok_or_else(|| "is no height; write 12km, 12000 or 40kft".into())
}

/// Cells of the box at which the first look is taken.
const LOOK: [f64; 2] = [1_200.0, 5_000.0];

/// Flies a body.
pub fn fly(args: &FlyArgs) -> Result<(), CommandError> {
    let begun = Instant::now();
    let mut flight = Flight::new(wishes(args)).map_err(CommandError::wrong)?;
    flight.widen(LOOK[usize::from(flight.dimension() == 3)]);
    let words = words(&flight);
    for line in &words {
        println!("{line}");
    }
    let out = folder(args.out.as_ref(), &format!("{}-fly", flight.name));
    if args.scene.is_none() && out.join("fly.json").exists() && !args.overwrite {
        return Err(CommandError::wrong(format!(
            "`{}` holds the results of another flight; give `--out` another folder, or `--overwrite`",
            out.display()
        )));
    }
    on_threads(args.threads, || {
        let cells = LOOK[usize::from(flight.dimension() == 3)];
        let trip = Trip::new(&flight, begun, args.minutes, args.spacing);
        let (family, told) = trip.family(flight.spacing_of(cells))?;
        println!("{told}");
        if let Some(path) = &args.scene {
            let text = flight
                .scene(family.finest(), None)
                .map_err(CommandError::wrong)?;
            std::fs::write(path, text).map_err(CommandError::failed)?;
            println!("wrote `{}`: aero run {0}", path.display());
            return Ok(());
        }
        make_folder(&out).map_err(CommandError::wrong)?;
        let (levels, failures) = trip.runs(&family, &out)?;
        let mut warnings = trip.warnings(&levels);
        warnings.extend(failures);
        let report = Report::new(&flight, words, levels, warnings).map_err(CommandError::failed)?;
        fly::write_report(&flight, &report, &out).map_err(CommandError::failed)?;
        print!("{}", report.text());
        println!(
            "{} in all; report in `{}`",
            minutes(begun.elapsed().as_secs_f64()),
            out.join("report.html").display()
        );
        Ok(())
    })
}

fn wishes(args: &FlyArgs) -> Wishes {
    Wishes {
        body: args.body.clone(),
        unit: args.unit.map(|unit| match unit {
            UnitWord::M => Unit::M,
            UnitWord::Mm => Unit::Mm,
            UnitWord::In => Unit::In,
        }),
        axes: args.axis,
        roll: args.roll,
        mach: args.mach,
        incidence: args.incidence,
        sideslip: args.sideslip,
        air: match (args.pressure, args.temperature) {
            (Some(pressure), Some(temperature)) => Air::State(pressure, temperature),
            _ => Air::Altitude(args.altitude.unwrap_or(0.0)),
        },
        with_the_gas: args.motion == MotionWord::WithTheGas,
        area: args.area,
        length: args.length,
        centre: args.centre,
    }
}

/// How the body lies, what is computed, what is referred to.
fn words(flight: &Flight) -> Vec<String> {
    let w = &flight.wishes;
    let size = flight.bounds.size();
    let mut lines = flight.attitude.words(&size, w.incidence, w.sideslip);
    lines.extend(
        flight
            .repairs
            .iter()
            .map(|repair| format!("mended: {repair}")),
    );
    let box_size = flight.region().size();
    lines.push(format!(
        "{}, in a box of {:.3} x {:.3} x {:.3} m",
        flight.extent_words(),
        box_size[0],
        box_size[1],
        box_size[2]
    ));
    lines.push(format!(
        "area {:.5e} m2, length {:.4} m, moments about {:.4} m behind the nose",
        flight.area,
        flight.reference_length(),
        flight.centre()
    ));
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heights_are_read_in_the_units_of_aviation() {
        for (text, metres) in [
            ("12km", 12e3),
            ("12000", 12e3),
            ("12000m", 12e3),
            ("40kft", 12_192.0),
            ("1000 ft", 304.8),
        ] {
            assert!((height(text).unwrap() - metres).abs() < 1e-9, "{text}");
        }
        assert!(height("high").is_err());
    }
}
