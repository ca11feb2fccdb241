//! What is swept: a scene, or the scene of a body from its file.

use std::path::Path;
use std::time::Instant;

use aero::fly::minutes;
use aero::scene::Scene;

use super::SweepArgs;
use super::values::Values;
use crate::cli::CommandError;
use crate::cli::body::BodyArgs;
use crate::cli::fly::trip::Trip;
use crate::cli::fly::{prepared, words};

/// Minutes of a whole sweep where nothing is given.
const MINUTES: f64 = 10.0;

/// The scene that is swept in so many points.
pub fn scene(args: &SweepArgs, points: usize) -> Result<Scene, CommandError> {
    let path = &args.scene.scene;
    if is_body(path) {
        return args.scene.overridden(scene_of_body(args, points)?);
    }
    if args.how != BodyArgs::default() {
        return Err(CommandError::wrong(format!(
            "`{}` is a scene, which says by itself how its bodies lie and how fine it is; leave out what is of a body's file, or \
             use `--set`",
            path.display()
        )));
    }
    args.scene.load()
}

/// True of a file of triangles.
fn is_body(path: &Path) -> bool {
    let name = path.to_string_lossy().to_lowercase();
    let name = name.strip_suffix(".gz").unwrap_or(&name);
    [".stl", ".obj", ".ply"]
        .iter()
        .any(|end| name.ends_with(end))
}

/// One box for all points, as wide as the slowest and the most inclined ask for, at the spacing that the minutes hold.
fn scene_of_body(args: &SweepArgs, points: usize) -> Result<Scene, CommandError> {
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
    let (family, _) = Trip::new(&flight, begun, each, args.how.spacing).family(look)?;
    say!(
        "{points} points at a spacing of {:.3e} m, finer near body and shocks; this will take about {}",
        family.finest(),
        minutes(points as f64 * family.seconds_of_finest())
    );
    let text = flight.scene(family.finest(), None);
    let text = text.map_err(CommandError::wrong)?;
    Scene::parse(&text, &flight.name, Path::new("")).map_err(CommandError::wrong)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bodies_are_known_by_their_names() {
        for name in ["a.stl", "b.STL.gz", "c/d.obj", "e.ply"] {
            assert!(is_body(Path::new(name)), "{name}");
        }
        assert!(!is_body(Path::new("stl.toml")));
    }
}
