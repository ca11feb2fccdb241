//! From the file's `[free_stream]` and `[initial]` to states of the gas.

use std::path::Path;

use aero_geometry::Vector;

use super::error::SceneError;
use super::file::{FreeStreamEntry, SceneFile, StateEntry};
use super::number::{Gamma, Positive};
use super::vector::{AXES, vector, vector_or_zero};
use super::{earlier, field};
use aero_solver::problem::{Domain, Initial, Side, State};

/// Specific gas constant of dry air, J/(kg K) (R* / M = 8.31446 / 0.0289652; Picard et al. 2008,
/// Metrologia 45, 149, doi 10.1088/0026-1394/45/2/004).
const AIR: f64 = 287.05;

/// Ratio of specific heats of a diatomic gas.
const DIATOMIC: f64 = 1.4;

/// Ratio of specific heats of the scene.
pub(super) fn gamma(file: &SceneFile) -> f64 {
    file.gas.gamma.map_or(DIATOMIC, Gamma::get)
}

/// The undisturbed state: `[free_stream]`, or, in a domain that nothing enters, the left state of a
/// Riemann problem or the state in the lowest corner of a field.
pub(super) fn free_stream<const D: usize>(
    file: &SceneFile,
    domain: &Domain<D>,
) -> Result<State<D>, SceneError> {
    if let Some(entry) = &file.free_stream {
        return stream_state(entry, gamma(file));
    }
    let needs_one = domain.has(Side::lets_in);
    match (&file.initial.riemann, &file.initial.field) {
        (Some(riemann), _) if !needs_one => state("initial.riemann.left", &riemann.left),
        (None, Some(entry)) if !needs_one => field::reference(entry, domain, file.spacing.get()),
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

/// Refuses an inlet that the free stream does not flow in through.
pub(super) fn check_inlets<const D: usize>(
    domain: &Domain<D>,
    free_stream: &State<D>,
) -> Result<(), SceneError> {
    for k in 0..D {
        for (end, inward) in [(0, 1.0), (1, -1.0)] {
            let speed = inward * free_stream.velocity[k];
            if domain.sides[k][end] == Side::Inlet && speed <= 0.0 {
                let word = ["min", "max"][end];
                return Err(SceneError::value(
                    format!("domain.sides.{}_{word}", AXES[k]),
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
    gamma: f64,
) -> Result<(), SceneError> {
    let entrances = domain.sides.iter().flatten().filter(|side| side.lets_in());
    let entrances = entrances.count();
    for k in 0..D {
        for (end, inward) in [(0, 1.0), (1, -1.0)] {
            if domain.sides[k][end] != Side::Reservoir {
                continue;
            }
            let place = format!("domain.sides.{}_{}", AXES[k], ["min", "max"][end]);
            if entrances > 1 {
                return Err(SceneError::value(
                    place,
                    "is a reservoir, which goes with no second reservoir, inlet or free-stream side; close the others with walls, symmetry or outlets",
                ));
            }
            let velocity = &free_stream.velocity;
            let sound = (gamma * free_stream.pressure / free_stream.density).sqrt();
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
    if given.into_iter().filter(|is_given| *is_given).count() > 1 {
        let message = "give one of riemann, field and frame";
        return Err(SceneError::value("initial", message));
    }
    if let Some(frame) = &file.initial.frame {
        return earlier::initial(&folder.join(frame));
    }
    if let Some(entry) = &file.initial.field {
        return field::initial(entry, free_stream, file.spacing.get());
    }
    let Some(riemann) = &file.initial.riemann else {
        return Ok(Initial::FreeStream);
    };
    let position = riemann.position.get();
    let (low, high) = (domain.bounds.min[0], domain.bounds.max[0]);
    if position <= low || position >= high {
        return Err(SceneError::value(
            "initial.riemann.position",
            format!("{position} is outside the domain, which spans {low} to {high} in x"),
        ));
    }
    Ok(Initial::Riemann {
        left: state("initial.riemann.left", &riemann.left)?,
        right: state("initial.riemann.right", &riemann.right)?,
        position,
        smooth: riemann.smooth.unwrap_or(false),
    })
}

fn state<const D: usize>(place: &str, entry: &StateEntry) -> Result<State<D>, SceneError> {
    Ok(State {
        density: entry.density.get(),
        velocity: vector_or_zero(&format!("{place}.velocity"), entry.velocity.as_ref())?,
        pressure: entry.pressure.get(),
    })
}

fn stream_state<const D: usize>(
    entry: &FreeStreamEntry,
    gamma: f64,
) -> Result<State<D>, SceneError> {
    let pressure = entry.pressure.get();
    let density = density(entry)?;
    let sound_speed = (gamma * pressure / density).sqrt();
    let velocity = match (entry.mach, entry.speed, &entry.velocity) {
        (Some(mach), None, None) => direction(entry)? * (mach.get() * sound_speed),
        (None, Some(speed), None) => direction(entry)? * speed.get(),
        (None, None, Some(velocity)) => {
            let given = [
                ("direction", entry.direction.is_some()),
                ("incidence", entry.incidence.is_some()),
            ];
            if let Some((key, _)) = given.iter().find(|(_, is_given)| *is_given) {
                return Err(SceneError::value(
                    format!("free_stream.{key}"),
                    "goes with mach or speed; velocity has a direction already, so leave one out",
                ));
            }
            vector("free_stream.velocity", velocity)?
        }
        _ => {
            return Err(SceneError::value(
                "free_stream",
                "give exactly one of mach, speed and velocity",
            ));
        }
    };
    Ok(State {
        density,
        velocity,
        pressure,
    })
}

/// `rho`, or `p / (R T)`.
fn density(entry: &FreeStreamEntry) -> Result<f64, SceneError> {
    match (entry.density, entry.temperature) {
        (Some(density), None) if entry.gas_constant.is_none() => Ok(density.get()),
        (None, Some(temperature)) => {
            let gas_constant = entry.gas_constant.map_or(AIR, Positive::get);
            Ok(entry.pressure.get() / (gas_constant * temperature.get()))
        }
        (Some(_), None) => Err(SceneError::value(
            "free_stream.gas_constant",
            "goes with temperature; leave it out, or give temperature in place of density",
        )),
        _ => Err(SceneError::value(
            "free_stream",
            "give exactly one of density and temperature",
        )),
    }
}

fn direction<const D: usize>(entry: &FreeStreamEntry) -> Result<Vector<D>, SceneError> {
    let place = "free_stream.direction";
    if let Some(incidence) = &entry.incidence {
        if entry.direction.is_some() {
            return Err(SceneError::value(
                "free_stream.incidence",
                "is a direction too; leave out one of incidence and direction",
            ));
        }
        if D == 1 {
            return Err(SceneError::value(
                "free_stream.incidence",
                "has no meaning in a scene of dimension 1; leave it out",
            ));
        }
        let (sin, cos) = incidence.get().to_radians().sin_cos();
        return Ok(Vector::from_fn(|k, _| [cos, sin, 0.0][k]));
    }
    let Some(numbers) = &entry.direction else {
        return Ok(Vector::<D>::from_fn(|k, _| f64::from(u8::from(k == 0))));
    };
    vector::<D>(place, numbers)?
        .try_normalize(0.0)
        .ok_or_else(|| SceneError::value(place, "is zero; give the way that the gas goes"))
}
