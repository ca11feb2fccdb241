//! What is swept: a scene, or the scene of a body from its file.

use std::path::Path;
use std::time::Instant;

use aero::fly::{Flight, minutes, thin_warning};
use aero::scene::Scene;

use super::SweepArgs;
use super::values::Values;
use crate::cli::CommandError;
use crate::cli::body::{BodyArgs, is_body};
use crate::cli::fly::telling::warnings;
use crate::cli::fly::trip::Trip;
use crate::cli::fly::{prepared, words};

/// Minutes of a whole sweep where nothing is given.
const MINUTES: f64 = 10.0;

/// The scene that is swept in so many points, and the flight of a body.
pub fn scene(args: &SweepArgs, points: usize) -> Result<(Scene, Option<Flight>), CommandError> {
    let path = &args.scene.scene;
    if is_body(path) {
        let (scene, flight) = scene_of_body(args, points)?;
        return Ok((args.scene.overridden(scene)?, Some(flight)));
    }
    if args.how != BodyArgs::default() {
        return Err(CommandError::wrong(format!(
            "`{}` is a scene, which says by itself how its bodies lie and how fine it is; leave out what is of a body's file, or \
             use `--set`",
            path.display()
        )));
    }
    Ok((args.scene.load()?, None))
}

/// One box for all points, as wide as the slowest and the most inclined ask for, at the spacing that the minutes hold.
fn scene_of_body(args: &SweepArgs, points: usize) -> Result<(Scene, Flight), CommandError> {
    let begun = Instant::now();
    let Some(Values(machs)) = &args.mach else {
        return Err(CommandError::wrong(
            "a body has no Mach number of its own; give --mach, as in --mach 1.5,2,3",
        ));
    };
    let slowest = machs.iter().copied().fold(f64::INFINITY, f64::min);
    let largest = |list: &Option<Values>| {
        let values = list.iter().flat_map(|Values(values)| values);
        values.fold(0.0, |most: f64, value| most.max(value.abs()))
    };
    let stream = [slowest, largest(&args.incidence), largest(&args.sideslip)];
    let each = match (args.how.minutes, args.how.spacing) {
        (None, Some(_)) => None,
        (minutes, _) => Some(minutes.unwrap_or(MINUTES) / points as f64),
    };
    let wishes = args.how.wishes(&args.scene.scene, stream);
    let (flight, look) = prepared(wishes, each, args.how.spacing)?;
    for line in words(&flight) {
        say!("{line}");
    }
    let (family, _) = Trip::new(flight.clone(), begun, each, args.how.spacing).family(look)?;
    say!(
        "{points} points at a spacing of {:.3e} m, finer near body and shocks; this will take about {}",
        family.finest(),
        minutes(points as f64 * family.seconds_of_finest())
    );
    let finest = family.finest() / f64::from(1_u32 << flight.body_halvings());
    for warning in warnings(&flight)
        .into_iter()
        .chain(thin_warning(&flight, finest))
    {
        say!("warning: {warning}");
    }
    let text = flight.scene(family.finest(), None);
    let text = text.map_err(CommandError::wrong)?;
    let scene = Scene::parse(&text, &flight.name, Path::new(""));
    Ok((scene.map_err(CommandError::wrong)?, flight))
}
