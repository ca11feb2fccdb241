//! From the file's `[free_stream]` and `[initial]` to states of the gas.

use std::path::Path;

use super::error::SceneError;
use super::file::{FreeStreamEntry, SceneFile, StateEntry};
use super::manufactured::Manufactured;
use super::transport::equation_of_state;
use super::vector::{side_key, vector_or_zero};
use super::{earlier, field, liquid, stream};
use crate::case::Stop;
use aero_solver::gas::Gas;
use aero_solver::problem::{Domain, Initial, Opening, Side, State};

/// The undisturbed state: `[free_stream]`, or, in a domain that nothing enters, the left state of a
/// Riemann problem or the state in the lowest corner of a field or of a manufactured solution.
pub(super) fn free_stream<const D: usize>(
    file: &SceneFile,
    domain: &Domain<D>,
    solution: Option<&Manufactured<D>>,
) -> Result<State<D>, SceneError> {
    if let Some(entry) = &file.free_stream {
        return stream::state(
            &stream::with_constant(file, entry),
            &equation_of_state(file),
        );
    }
    if let Some(solution) = solution {
        return Ok(solution.state(&domain.bounds.min, 0.0));
    }
    let needs_one = domain.has(Side::lets_in);
    let gas = equation_of_state(file);
    match (&file.initial.riemann, &file.initial.field) {
        (Some(riemann), _) if !needs_one => state("initial.riemann.left", &riemann.left, &gas),
        (None, Some(entry)) if !needs_one => {
            field::reference(entry, &gas, domain, file.spacing.get())
        }
        (Some(_), _) | (_, Some(_)) => Err(SceneError::value(
            "free_stream",
            "missing, though a side of the domain is an inlet or a free stream; add the section with mach, density and pressure",
        )),
        (None, None) => Err(SceneError::value(
            "free_stream",
            "missing; add the section with mach, density and pressure, or start from [initial.riemann] or [initial.field]",
        )),
    }
}

/// When the run ends: as the scene says, or, of one that stops by itself, when the stream has crossed the box many times.
pub(super) fn end_time<const D: usize>(
    file: &SceneFile,
    stop: Stop,
    domain: &Domain<D>,
    free_stream: &State<D>,
) -> Result<f64, SceneError> {
    /// A flow that is not steady by then will not be.
    const CROSSINGS: f64 = 20.0;
    match (file.end_time, stop) {
        (Some(end), _) => Ok(end.get()),
        (None, Stop::EndTime) => Err(SceneError::value(
            "end_time",
            "missing; say when the run ends, or add stop = \"steady\"",
        )),
        (None, Stop::Steady) => {
            let size = domain.bounds.size();
            let velocity = &free_stream.velocity;
            let gas = equation_of_state(file);
            let sound = gas.sound_speed_at(free_stream.density, free_stream.pressure);
            let crossing = size.dot(&velocity.abs()) / velocity.norm_squared();
            let crossing = if crossing.is_finite() {
                crossing
            } else {
                size.max() / sound
            };
            Ok(CROSSINGS * crossing)
        }
    }
}

/// Refuses an inlet that the free stream does not flow in through.
pub(super) fn check_inlets<const D: usize>(
    domain: &Domain<D>,
    free_stream: &State<D>,
) -> Result<(), SceneError> {
    for k in 0..D {
        for (end, inward) in [(0, 1.0), (1, -1.0)] {
            let speed = inward * free_stream.velocity[k];
            let is_given = |opening: &Opening<D>| {
                (opening.axis, opening.end) == (k, end) && opening.part.is_none()
            };
            if domain.openings.iter().any(is_given) {
                continue;
            }
            if domain.sides[k][end].is_inlet() && speed <= 0.0 {
                return Err(SceneError::value(
                    side_key(k, end),
                    format!(
                        "is an inlet, but the free stream enters there at a speed of {speed}; choose free-stream or outlet, or turn free_stream.direction"
                    ),
                ));
            }
        }
    }
    Ok(())
}

/// Refuses a reservoir whose gas does not come straight in below the speed of sound, or that shares
/// the domain with another side that gas enters through: their lattices would drift apart.
pub(super) fn check_reservoir<const D: usize>(
    domain: &Domain<D>,
    free_stream: &State<D>,
    gas: &Gas,
) -> Result<(), SceneError> {
    let entrances = domain.sides.iter().flatten().filter(|side| side.lets_in());
    let entrances = entrances.count();
    for k in 0..D {
        for (end, inward) in [(0, 1.0), (1, -1.0)] {
            if !domain.sides[k][end].is_reservoir() {
                continue;
            }
            let place = side_key(k, end);
            if entrances > 1 {
                return Err(SceneError::value(
                    place,
                    "is a reservoir, which goes with no second reservoir, inlet or free-stream side; close the others with walls, symmetry or outlets",
                ));
            }
            let velocity = &free_stream.velocity;
            let sound = gas.sound_speed_at(free_stream.density, free_stream.pressure);
            let speed = inward * velocity[k];
            if speed < 0.0 || speed >= sound || velocity.norm() > speed * (1.0 + 1e-12) {
                return Err(SceneError::value(
                    place,
                    format!(
                        "is a reservoir, but the free stream does not come straight in there below the speed of sound, {sound:.4}; turn free_stream.direction, slow it down, or choose inlet"
                    ),
                ));
            }
        }
    }
    Ok(())
}

/// The start from the frame at `path`.
fn of_frame<const D: usize>(
    file: &SceneFile,
    path: &Path,
    folder: &Path,
    free_stream: &State<D>,
) -> Result<Initial<D>, SceneError> {
    let turned = |section: &str, path: &Path, stream: Option<&FreeStreamEntry>| {
        let place = format!("{section}.stream");
        let stream = stream.map(|entry| {
            stream::state(
                &stream::with_constant(file, entry),
                &equation_of_state(file),
            )
        });
        let stream = stream.transpose();
        let stream = stream.map_err(|error| error.moved("free_stream", &place))?;
        let streams = stream.as_ref().map(|before| [before, free_stream]);
        earlier::Turned::new(&format!("{section}.frame"), path, streams)
    };
    let initial = &file.initial;
    let flow = turned("initial", path, initial.stream.as_ref())?;
    let trend = initial.trend.as_ref().map(|trend| {
        let path = folder.join(&trend.frame);
        let before = turned("initial.trend", &path, trend.stream.as_ref())?;
        Ok((before, trend.part.get()))
    });
    Ok(earlier::initial(flow, trend.transpose()?))
}

/// State at the start; files are looked for from `folder`.
pub(super) fn initial<const D: usize>(
    file: &SceneFile,
    folder: &Path,
    domain: &Domain<D>,
    free_stream: &State<D>,
) -> Result<Initial<D>, SceneError> {
    let given = [
        file.initial.riemann.is_some(),
        file.initial.field.is_some(),
        file.initial.frame.is_some(),
    ];
    let given = given.into_iter().filter(|is_given| *is_given).count();
    if given > 1 {
        let message = "give one of riemann, field and frame";
        return Err(SceneError::value("initial", message));
    }
    if given > 0 && file.manufactured.is_some() {
        let message = "says how the gas starts, and so does [manufactured]; leave out all but `disorder`, or leave out [manufactured]";
        return Err(SceneError::value("initial", message));
    }
    if let Some(frame) = &file.initial.frame {
        return of_frame(file, &folder.join(frame), folder, free_stream);
    }
    let of_frames = [
        ("initial.stream", file.initial.stream.is_some()),
        ("initial.trend", file.initial.trend.is_some()),
    ];
    if let Some((key, _)) = of_frames.into_iter().find(|(_, is_given)| *is_given) {
        let message =
            "goes with `initial.frame`, the frame of an earlier run; give that, or leave this out";
        return Err(SceneError::value(key, message));
    }
    if let Some(entry) = &file.initial.field {
        return field::initial(
            entry,
            &equation_of_state(file),
            free_stream,
            file.spacing.get(),
        );
    }
    let Some(riemann) = &file.initial.riemann else {
        return Ok(Initial::FreeStream);
    };
    let gas = equation_of_state(file);
    let position = riemann.position.get();
    let (low, high) = (domain.bounds.min[0], domain.bounds.max[0]);
    if position <= low || position >= high {
        return Err(SceneError::value(
            "initial.riemann.position",
            format!("{position} is outside the domain, which spans {low} to {high} in x"),
        ));
    }
    Ok(Initial::Riemann {
        left: state("initial.riemann.left", &riemann.left, &gas)?,
        right: state("initial.riemann.right", &riemann.right, &gas)?,
        position,
        smooth: riemann.smooth.unwrap_or(false),
    })
}

fn state<const D: usize>(
    place: &str,
    entry: &StateEntry,
    gas: &Gas,
) -> Result<State<D>, SceneError> {
    let [density, pressure] = match (gas.liquid(), entry.density, entry.pressure) {
        (Some(liquid), density, pressure) => liquid::state(liquid, place, [density, pressure])?,
        (None, Some(density), Some(pressure)) => [density.get(), pressure.get()],
        (None, density, _) => {
            let missing = if density.is_none() {
                "density"
            } else {
                "pressure"
            };
            return Err(SceneError::value(
                format!("{place}.{missing}"),
                "is missing; give density and pressure",
            ));
        }
    };
    Ok(State {
        density,
        velocity: vector_or_zero(&format!("{place}.velocity"), entry.velocity.as_ref())?,
        pressure,
    })
}
