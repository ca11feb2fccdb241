//! `refine = { minutes = T }`: turned into points before a run begins.

use std::path::Path;

use aero::run::{burst, is_of};
use aero::scene::Scene;

use super::CommandError;
use super::scene::checked;

/// Seconds of looking how fast the scene goes: this part of the budget, within these bounds.
const LOOK: f64 = 0.02;
const LOOKS: [f64; 2] = [0.2, 5.0];

/// `scene` with so many points, or halvings, as its minutes allow on this machine: those that a run of it in `earlier` was given, so
/// that it can be repeated and gone on with; else by a look at how fast it goes. Says which.
///
/// # Errors
/// A scene that cannot be run.
pub fn turned_into_points(mut scene: Scene, earlier: Option<&Path>) -> Result<Scene, CommandError> {
    let Some(minutes) = scene.refine_minutes() else {
        return Ok(scene);
    };
    if let Some(same) = earlier.and_then(|folder| as_before(&scene, folder)) {
        note!(
            "refine: as the run in the folder before; `--overwrite` looks anew what fits into {minutes} minutes"
        );
        return Ok(same);
    }
    scene.set("scheme.refine=0").map_err(CommandError::wrong)?;
    let seconds = 60.0 * minutes;
    let look = (LOOK * seconds).clamp(LOOKS[0], LOOKS[1]);
    let shown = burst(checked(&scene)?, look).map_err(CommandError::wrong)?;
    let words = match shown.refine_within(seconds, scene.dimension()) {
        None => {
            let alone = shown.seconds_per_step * shown.steps_to_go / 60.0;
            note!(
                "warning: no points are added: without any the run takes about {alone:.1} minutes of the {minutes} that \
                 `scheme.refine` allows; a larger `spacing` leaves time for them"
            );
            return Ok(scene);
        }
        Some(refine) => refine.to_string(),
    };
    note!(
        "refine = {words}: about what {minutes} minutes allow on {} threads of this machine",
        rayon::current_num_threads()
    );
    scene
        .set(&format!("scheme.refine={words}"))
        .map_err(CommandError::wrong)?;
    Ok(scene)
}

/// `scene` with the points of the run in `folder`, if that was one of the same scene otherwise.
fn as_before(scene: &Scene, folder: &Path) -> Option<Scene> {
    let run = std::fs::read_to_string(folder.join("run.toml")).ok()?;
    let setting = run
        .lines()
        .find(|line| line.starts_with("scheme.refine"))?
        .replace(' ', "");
    let mut same = scene.clone();
    same.set(&match setting.strip_prefix("scheme.refine.points=") {
        Some(points) => format!("scheme.refine={{points={points}}}"),
        None => setting,
    })
    .ok()?;
    is_of(folder, &same.lines_from_anywhere()).then_some(same)
}
