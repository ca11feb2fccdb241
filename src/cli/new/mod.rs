//! `aero new`: a scene to begin with.

use std::fs::OpenOptions;
use std::io::Write as _;
use std::path::PathBuf;

use clap::Args;

use super::CommandError;
use aero::nearest::nearest;

/// What `aero new` takes.
#[derive(Args, Debug)]
pub struct NewArgs {
    /// What kind of flow; lists the kinds where none is given
    #[arg(value_name = "KIND")]
    kind: Option<String>,
    /// The scene's file; `KIND.toml` unless given
    #[arg(value_name = "FILE")]
    file: Option<PathBuf>,
}

/// A kind of flow, what it is and its scene.
type Kind = (&'static str, &'static str, &'static str);

/// All kinds of flow.
const KINDS: [Kind; 11] = [
    (
        "body",
        "a body from a mesh file at incidence and altitude, forces until they are steady",
        include_str!("body.toml"),
    ),
    (
        "wedge",
        "oblique shock at a compression corner, particles",
        include_str!("../../../cases/wedge.toml"),
    ),
    (
        "wedge-fixed",
        "the same, points that stay, steady",
        include_str!("../../../cases/wedge-fixed.toml"),
    ),
    (
        "biconvex",
        "lens aerofoil in the plane",
        include_str!("../../../cases/biconvex.toml"),
    ),
    (
        "cylinder",
        "bow shock in the plane",
        include_str!("../../../cases/cylinder.toml"),
    ),
    (
        "cone",
        "a cone about its axis",
        include_str!("../../../cases/cone.toml"),
    ),
    (
        "nozzle",
        "a nozzle about its axis, from a reservoir",
        include_str!("../../../cases/nozzle.toml"),
    ),
    (
        "sphere",
        "a quarter of a sphere in space",
        include_str!("../../../cases/sphere.toml"),
    ),
    (
        "step",
        "a step in a wind tunnel",
        include_str!("../../../cases/step.toml"),
    ),
    (
        "square",
        "a square that moves through gas at rest",
        include_str!("../../../cases/square.toml"),
    ),
    (
        "tube",
        "a shock tube in one dimension",
        include_str!("../../../cases/sod-1d.toml"),
    ),
];

/// Writes a scene to begin with, or lists what there is.
pub fn new(args: &NewArgs) -> Result<(), CommandError> {
    let Some(kind) = &args.kind else {
        for (name, what, _) in KINDS {
            say!("{name:12} {what}");
        }
        return Ok(());
    };
    let names = KINDS.map(|(name, ..)| name);
    let Some((_, _, scene)) = KINDS.iter().find(|(name, ..)| name == kind) else {
        return Err(CommandError::wrong(format!(
            "there is no kind of scene `{kind}`{}; there are {}",
            nearest(kind, &names),
            names.join(", ")
        )));
    };
    let file = args
        .file
        .clone()
        .unwrap_or_else(|| PathBuf::from(format!("{kind}.toml")));
    let shown = file.display();
    let made = OpenOptions::new().write(true).create_new(true).open(&file);
    let written = made.and_then(|mut made| made.write_all(scene.as_bytes()));
    written.map_err(|error| match error.kind() {
        std::io::ErrorKind::AlreadyExists => CommandError::wrong(format!(
            "`{shown}` is there already; name another file: aero new {kind} FILE"
        )),
        _ => CommandError::wrong(format!("cannot write `{shown}`: {error}")),
    })?;
    say!("wrote `{shown}`; run it with: aero run {shown}");
    Ok(())
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use aero::scene::Scene;

    #[test]
    fn every_kind_is_a_scene() {
        for (name, _, text) in super::KINDS {
            if let Err(error) = Scene::parse(text, name, Path::new("")) {
                panic!("{error}");
            }
        }
    }
}
