//! From the file's `[output]` to when to write what.

use super::error::SceneError;
use super::file::OutputEntry;
use super::number::Count;
use super::picture;
use super::region::{Surroundings, mirrors, region};
use super::views;
use crate::case::{Extras, OutputPlan, Pressure};

/// What a run of that length writes, about points that stay or not.
pub(super) fn plan<const D: usize>(
    entry: &OutputEntry,
    end_time: f64,
    is_fixed: bool,
    scene: &Surroundings<'_, D>,
) -> Result<OutputPlan<D>, SceneError> {
    /// Enough for a smooth film of a few seconds.
    const FRAMES: usize = 20;
    /// What a crash may cost, s.
    const BETWEEN_CHECKPOINTS: f64 = 60.0;
    /// Ten thousand years, s: clocks end somewhere.
    const NEVER: f64 = 3e11;
    let frame_interval = match (entry.frames, entry.interval) {
        (Some(_), Some(_)) => {
            return Err(SceneError::value(
                "output",
                "give frames or interval, not both",
            ));
        }
        (None, Some(interval)) => interval.get(),
        (frames, None) => end_time / frames.map_or(FRAMES, Count::get) as f64,
    };
    let has_cells = entry.cells.unwrap_or(false);
    if has_cells && !(is_fixed && D > 1) {
        return Err(SceneError::value(
            "output.cells",
            "is of points that stay, in the plane or in space; leave it out, or set `scheme.motion = \"fixed\"`",
        ));
    }
    let has_ghosts = entry.ghosts.unwrap_or(false);
    if has_ghosts && is_fixed {
        return Err(SceneError::value(
            "output.ghosts",
            "points that stay have none; leave it out",
        ));
    }
    let mirrors = if entry.mirror.unwrap_or(false) {
        mirrors(scene.domain)?
    } else {
        Vec::new()
    };
    let shown = entry.region.as_ref().map(|shown| region("output", shown));
    let field = entry.field.as_ref();
    let field = field.map(|field| views::field(field, (scene.domain, &mirrors), scene.spacing));
    let picture = entry.picture.as_ref();
    let picture = picture.map(|picture| picture::picture(picture, scene, &mirrors));
    Ok(OutputPlan {
        frame_interval,
        extras: Extras {
            cells: has_cells,
            ghosts: has_ghosts,
            gradients: entry.density_gradient.unwrap_or(false),
        },
        region: shown.transpose()?,
        field: field.transpose()?,
        picture: picture.transpose()?,
        mirrors,
        is_compressed: entry.compress.unwrap_or(true),
        coefficients: entry.coefficients.map_or(Pressure::Gauge, Into::into),
        history_every: entry.history_every.map_or(1, Count::get),
        checkpoint_seconds: entry
            .checkpoint_seconds
            .map_or(BETWEEN_CHECKPOINTS, |seconds| seconds.get().min(NEVER)),
    })
}
