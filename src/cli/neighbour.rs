//! A run that starts where one like it has settled: another spacing of the same scene, or another stream.

use std::path::PathBuf;

use aero::fly::last_file;
use aero::scene::Scene;

use super::CommandError;

/// A run that is done.
#[derive(Clone, Debug)]
pub struct Neighbour {
    /// What was run, the start aside.
    pub scene: Scene,
    /// Where its files are.
    pub folder: PathBuf,
}

/// `scene` from where `neighbour` came to, if it is to become steady and says nothing of its start itself: with its points and its
/// flow, turned and sped up with the stream; beyond it by a part of the way to there from another one, where that is known.
pub fn started(
    scene: &Scene,
    neighbour: Option<&Neighbour>,
    trend: Option<(&Neighbour, f64)>,
) -> Result<Scene, CommandError> {
    let mut scene = scene.clone();
    let may = scene.file().stop.is_some() && scene.starts_in_the_free_stream();
    let Some(neighbour) = neighbour.filter(|_| may) else {
        return Ok(scene);
    };
    let Some(frame) = last_frame(neighbour)? else {
        return Ok(scene);
    };
    let mut settings = vec![format!("initial.frame={frame:?}")];
    settings.extend(stream("initial.stream", &scene, neighbour));
    if let Some((before, part)) = trend
        && let Some(frame) = last_frame(before)?
    {
        settings.push(format!(
            "initial.trend={{ frame = {frame:?}, part = {part:?} }}"
        ));
        settings.extend(stream("initial.trend.stream", &scene, before));
    }
    for setting in settings {
        scene.set(&setting).map_err(CommandError::wrong)?;
    }
    Ok(scene)
}

/// The last frame of a run, from wherever it is looked for.
fn last_frame(neighbour: &Neighbour) -> Result<Option<String>, CommandError> {
    let frame = last_file(&neighbour.folder, "frame-").map(std::path::absolute);
    let frame = frame.transpose().map_err(CommandError::failed)?;
    Ok(frame.map(|frame| frame.display().to_string()))
}

/// What a scene says of the free stream of another; nothing where it is its own.
fn stream(key: &str, now: &Scene, neighbour: &Neighbour) -> Vec<String> {
    let lines = |scene: &Scene| -> Vec<String> {
        let lines = scene.lines();
        let lines = lines.lines();
        let stream = lines.filter_map(|line| line.strip_prefix("free_stream."));
        stream.map(|line| format!("{key}.{line}")).collect()
    };
    let before = lines(&neighbour.scene);
    if before == lines(now) {
        Vec::new()
    } else {
        before
    }
}
