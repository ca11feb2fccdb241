//! What carries the gas, from `[scheme]`.

use super::SceneError;
use super::budget;
use super::file::SchemeEntry;
use super::refine::RefineEntry;
use super::words::MotionWord;
use crate::case::Stop;
use aero_solver::method::{FixedPoints, Method, Refine, Time};

/// The method that `entry` means in a run that ends by `stop`.
pub(super) fn method(entry: &SchemeEntry, stop: Stop) -> Result<Method, SceneError> {
    if entry.motion == Some(MotionWord::Fixed) {
        check_particle_keys(entry)?;
        let usual = match stop {
            Stop::EndTime => Time::Accurate,
            Stop::Steady => Time::Settle,
        };
        let time = entry.time.map_or(usual, Into::into);
        let usual = FixedPoints::default();
        let cfl = match (entry.cfl, time) {
            (None, _) => usual.cfl,
            (Some(cfl), Time::Accurate) => cfl.get(),
            (Some(_), Time::Settle) => {
                return Err(SceneError::value(
                    "scheme.cfl",
                    "is of steps in time, and this flow settles without; leave it out, or set `scheme.time = \"accurate\"`",
                ));
            }
        };
        return Ok(Method::Fixed(FixedPoints {
            time,
            refine: entry.refine.map_or(Ok(usual.refine), refine)?,
            cfl,
            room: budget::room_for_points(),
        }));
    }
    let of_points = [
        ("scheme.time", entry.time.is_some()),
        ("scheme.refine", entry.refine.is_some()),
    ];
    refuse(
        &of_points,
        "is of points that stay where they are; set `scheme.motion = \"fixed\"` or leave it out",
    )?;
    Ok(Method::WithTheGas)
}

/// What `entry` says outright.
fn refine(entry: RefineEntry) -> Result<Refine, SceneError> {
    match entry {
        RefineEntry::To(refine) => Ok(refine),
        RefineEntry::Minutes(_) => Err(SceneError::value(
            "scheme.refine",
            "`aero run` and `aero check` turn minutes into points; give a number of halvings or `{ points = N }` here",
        )),
    }
}

/// Refuses what only particles have.
fn check_particle_keys(entry: &SchemeEntry) -> Result<(), SceneError> {
    let of_particles = [
        ("scheme.equations", entry.equations.is_some()),
        ("scheme.extrapolation", entry.extrapolation.is_some()),
        ("scheme.shield", entry.shield.is_some()),
        ("scheme.shifting", entry.shifting.is_some()),
        (
            "scheme.constant_ghost_volume",
            entry.constant_ghost_volume.is_some(),
        ),
        (
            "scheme.limited_viscosity",
            entry.limited_viscosity.is_some(),
        ),
        (
            "scheme.limited_conduction",
            entry.limited_conduction.is_some(),
        ),
        (
            "scheme.artificial_dissipation",
            entry.artificial_dissipation.is_some(),
        ),
        ("scheme.surface_tags", entry.surface_tags.is_some()),
        ("scheme.skip_undisturbed", entry.skip_undisturbed.is_some()),
        ("scheme.precision", entry.precision.is_some()),
    ];
    refuse(
        &of_particles,
        "is of particles that move with the gas; leave it out, or leave out `scheme.motion = \"fixed\"`",
    )
}

fn refuse(keys: &[(&str, bool)], message: &str) -> Result<(), SceneError> {
    match keys.iter().find(|(_, is_given)| *is_given) {
        Some((key, _)) => Err(SceneError::value(*key, message)),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_that_stay_know_what_memory_holds_where_the_system_tells() {
        let entry: SchemeEntry = toml::from_str("motion = \"fixed\"").unwrap();
        let method = method(&entry, Stop::EndTime).unwrap();
        let room = method.fixed().and_then(|points| points.room);
        assert_eq!(room.is_some(), cfg!(target_os = "linux"));
        assert!(room.is_none_or(|room| room > 1000));
    }
}
